#include "python/binding/module.h"

#include <malloc.h>

#include "nilas/solve.h"

PYBIND11_MODULE(_core, module) {
  // Each step frees and takes the same few megabytes: as in the program, they stay with the process in between.
  constexpr int k_keep_bytes = 1 << 28;
  mallopt(M_TRIM_THRESHOLD, k_keep_bytes);
  mallopt(M_MMAP_THRESHOLD, k_keep_bytes);
  module.doc() = "The compiled part of the package nilas.";
  nilas::python::bind_errors(module);
  nilas::python::bind_problems(module);
  nilas::python::bind_scenes(module);
  nilas::python::bind_simulation(module);
  module.def("version", &nilas::version, "The version of the library, as '0.2.0'.");
}
