#include "nilas/error.h"
#include "python/binding/module.h"

namespace nilas::python {

namespace py = pybind11;

/// The classes are made in Python (nilas/errors.py), so that they have docstrings and one home.
void bind_errors(py::module_&) {
  py::register_exception_translator([](std::exception_ptr thrown) {
    try {
      if (thrown) std::rethrow_exception(thrown);
    } catch (const Error& e) {
      const char* name = e.kind() == ErrorKind::input      ? "InputError"
                         : e.kind() == ErrorKind::file     ? "FileError"
                         : e.kind() == ErrorKind::numerics ? "SimulationError"
                                                           : "Defect";
      const py::object type = py::module_::import("nilas.errors").attr(name);
      PyErr_SetString(type.ptr(), e.what());
    }
  });
}

}  // namespace nilas::python
