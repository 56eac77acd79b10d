#pragma once
/// Arrays of numpy as lists of the library, and back.
#include <pybind11/numpy.h>
#include <pybind11/pybind11.h>

#include <algorithm>
#include <array>
#include <functional>
#include <numeric>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "nilas/error.h"

namespace nilas::python {

namespace py = pybind11;

/// Numbers of any shape, row by row.
using Numbers = py::array_t<double, py::array::c_style | py::array::forcecast>;

inline std::string text_of(const std::vector<py::ssize_t>& shape) {
  std::string text;
  for (const py::ssize_t n : shape) text += (text.empty() ? "" : ", ") + (n < 0 ? "n" : std::to_string(n));
  return "(" + text + (shape.size() == 1 ? ",)" : ")");
}

inline std::vector<py::ssize_t> shape_of(const py::array& numbers) {
  return {numbers.shape(), numbers.shape() + numbers.ndim()};
}

/// Refuses an array that does not fit. `what`: its name in messages; `allowed`: the shapes that are. Throws Error.
inline void demand_shape(const char* what, const py::array& numbers, bool fits, const std::string& allowed) {
  if (!fits)
    throw Error(ErrorKind::input,
                std::string(what) + " has the shape " + text_of(shape_of(numbers)) + "; allowed: " + allowed);
}

/// An argument as an array of real numbers. Throws Error where it is none.
inline Numbers numbers_of(const char* what, const py::object& given) {
  constexpr std::string_view k_kinds = "biufO";  // of NumPy; numbers of other packages are objects
  std::string found = py::str(py::type::of(given).attr("__name__"));
  if (const auto any = py::array::ensure(given); any) {
    if (k_kinds.find(any.dtype().kind()) != std::string_view::npos)
      if (auto numbers = Numbers::ensure(any); numbers) return numbers;
    found += " of " + std::string(py::str(any.dtype()));
  }
  throw Error(ErrorKind::input, std::string(what) + " is no array of real numbers; found " + found);
}

/// The numbers of an array that has this shape, or as many along one axis. `what`: its name in messages. A size of -1
/// stands for any; of an array with such a size, and of an empty one, the library checks the number. Throws Error.
inline std::span<const double> span_of(const char* what, const Numbers& numbers,
                                       const std::vector<py::ssize_t>& shape) {
  const std::vector<py::ssize_t> found = shape_of(numbers);
  bool fits = found.size() == shape.size();
  for (std::size_t k = 0; fits && k < shape.size(); ++k) fits = shape[k] < 0 || shape[k] == found[k];
  const bool is_open = std::find(shape.begin(), shape.end(), -1) != shape.end();
  const py::ssize_t count = std::accumulate(shape.begin(), shape.end(), py::ssize_t{1}, std::multiplies<>());
  const bool is_list = numbers.ndim() == 1 && (is_open || numbers.size() == count);
  const bool is_empty = is_open && numbers.size() == 0;
  demand_shape(what, numbers, fits || is_list || is_empty,
               text_of(shape) + (shape.size() == 1 || is_open ? "" : " or " + text_of({count})));
  return {numbers.data(), static_cast<std::size_t>(numbers.size())};
}

/// An array that takes over the numbers of the list.
inline py::array_t<double> array_of(std::vector<double> numbers, std::vector<py::ssize_t> shape = {}) {
  if (shape.empty()) shape = {static_cast<py::ssize_t>(numbers.size())};
  auto* const kept = new std::vector<double>(std::move(numbers));
  const py::capsule owner(kept, [](void* list) { delete static_cast<std::vector<double>*>(list); });
  return py::array_t<double>(std::move(shape), kept->data(), owner);
}

inline py::array_t<double> rows_of(std::vector<double> numbers, py::ssize_t columns) {
  const auto rows = static_cast<py::ssize_t>(numbers.size()) / columns;
  return array_of(std::move(numbers), {rows, columns});
}

/// The same, which nobody can change: a state of the past.
inline py::array_t<double> fixed_rows_of(std::vector<double> numbers, py::ssize_t columns) {
  py::array_t<double> rows = rows_of(std::move(numbers), columns);
  rows.attr("setflags")(py::arg("write") = false);
  return rows;
}

template <std::size_t count>
py::array_t<double> array_of(const std::array<double, count>& numbers) {
  return array_of(std::vector<double>(numbers.begin(), numbers.end()));
}

}  // namespace nilas::python
