#pragma once
/// The parts of the module nilas._core.
#include <pybind11/pybind11.h>

namespace nilas::python {

void bind_errors(pybind11::module_& module);
void bind_problems(pybind11::module_& module);
void bind_scenes(pybind11::module_& module);
void bind_simulation(pybind11::module_& module);

}  // namespace nilas::python
