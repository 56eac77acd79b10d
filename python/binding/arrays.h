#pragma once
/// Arrays of numpy as lists of the library, and back.
#include <pybind11/numpy.h>
#include <pybind11/pybind11.h>

#include <array>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "nilas/error.h"

namespace nilas::python {

namespace py = pybind11;

/// Numbers of any shape, row by row. pybind11 converts lists and other types of numbers.
using Numbers = py::array_t<double, py::array::c_style | py::array::forcecast>;

inline std::string text_of(const std::vector<py::ssize_t>& shape) {
  std::string text;
  for (const py::ssize_t n : shape) text += (text.empty() ? "" : ", ") + std::to_string(n);
  return "(" + text + (shape.size() == 1 ? ",)" : ")");
}

/// The numbers of an array that has this shape, or one axis; the library then checks their number. `what`: its name in
/// messages. A size of -1 stands for any. Throws Error.
inline std::span<const double> span_of(const char* what, const Numbers& numbers,
                                       const std::vector<py::ssize_t>& shape) {
  const std::vector<py::ssize_t> found(numbers.shape(), numbers.shape() + numbers.ndim());
  bool fits = found.size() == shape.size();
  for (std::size_t k = 0; fits && k < shape.size(); ++k) fits = shape[k] < 0 || shape[k] == found[k];
  if (!fits && numbers.ndim() != 1 && numbers.size() > 0)
    throw Error(ErrorKind::input,
                std::string(what) + " has the shape " + text_of(found) + "; allowed: " + text_of(shape));
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
