#include "core/output/run/program_versions.h"

namespace nilas::output {

std::map<std::string, std::string> program_versions() {
  return {{"nilas", NILAS_VERSION},       {"simbody", NILAS_SIMBODY_VERSION},   {"fcl", NILAS_FCL_VERSION},
          {"eigen", NILAS_EIGEN_VERSION}, {"cgal", NILAS_CGAL_VERSION},         {"sundials", NILAS_SUNDIALS_VERSION},
          {"hdf5", NILAS_HDF5_VERSION},   {"tinyxml2", NILAS_TINYXML2_VERSION}, {"compiler", NILAS_COMPILER}};
}

std::string program_build() { return NILAS_BUILD; }

}  // namespace nilas::output
