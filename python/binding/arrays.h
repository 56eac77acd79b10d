#pragma once
/// Arrays of numpy as lists of the library, and back.
#include <pybind11/numpy.h>
#include <pybind11/pybind11.h>

#include <array>
#include <span>
#include <string>
#include <utility>
#include <vector>

namespace nilas::python {

namespace py = pybind11;

/// Numbers of any shape, row by row. pybind11 converts lists and other types of numbers.
using Numbers = py::array_t<double, py::array::c_style | py::array::forcecast>;

inline std::span<const double> span_of(const Numbers& numbers) {
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

template <std::size_t count>
py::array_t<double> array_of(const std::array<double, count>& numbers) {
  return array_of(std::vector<double>(numbers.begin(), numbers.end()));
}

}  // namespace nilas::python
