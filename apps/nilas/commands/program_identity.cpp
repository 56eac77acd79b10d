#include "apps/nilas/commands/program_identity.h"

#include "core/scene/read/input_files.h"

namespace nilas::commands {

std::map<std::string, std::string> program_versions() {
  return {{"nilas", NILAS_VERSION},
          {"simbody", NILAS_SIMBODY_VERSION},
          {"fcl", NILAS_FCL_VERSION},
          {"eigen", NILAS_EIGEN_VERSION},
          {"cgal", NILAS_CGAL_VERSION},
          {"sundials", NILAS_SUNDIALS_VERSION},
          {"tinyxml2", NILAS_TINYXML2_VERSION},
          {"compiler", NILAS_COMPILER}};
}

sim::CheckpointOrigin checkpoint_origin(const std::string& scene_fingerprint) {
  std::string program = "nilas " NILAS_VERSION " (" NILAS_BUILD;
  for (const auto& [name, version] : program_versions())
    if (name != "nilas") program += ", " + name + " " + version;
  // this is the file that runs, even if another file has taken its name since
  return {program + ")", scene::file_sha256("/proc/self/exe"), scene_fingerprint};
}

}  // namespace nilas::commands
