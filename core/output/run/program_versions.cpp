#include "core/output/run/program_versions.h"

namespace nilas::output {

std::map<std::string, std::string> program_versions() {
  return {
      {"nilas", NILAS_VERSION},           {"simbody", NILAS_SIMBODY_VERSION},   {"fcl", NILAS_FCL_VERSION},
      {"ccd", NILAS_CCD_VERSION},         {"eigen", NILAS_EIGEN_VERSION},       {"cgal", NILAS_CGAL_VERSION},
      {"hdf5", NILAS_HDF5_VERSION},       {"sundials", NILAS_SUNDIALS_VERSION}, {"tinyxml2", NILAS_TINYXML2_VERSION},
      {"cli11", NILAS_CLI11_VERSION},     {"fmt", NILAS_FMT_VERSION},           {"nlohmann-json", NILAS_JSON_VERSION},
      {"openssl", NILAS_OPENSSL_VERSION}, {"spdlog", NILAS_SPDLOG_VERSION},     {"zlib", NILAS_ZLIB_VERSION},
      {"compiler", NILAS_COMPILER}};
}

std::string program_build() { return NILAS_BUILD; }

}  // namespace nilas::output
