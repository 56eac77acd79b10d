#include "apps/nilas/commands/program_identity.h"

#include "core/output/run/program_versions.h"
#include "core/scene/read/input_files.h"

namespace nilas::commands {

sim::CheckpointOrigin checkpoint_origin(const std::string& scene_fingerprint) {
  const auto versions = output::program_versions();
  std::string program = "nilas " + versions.at("nilas") + " (" + output::program_build();
  for (const auto& [name, version] : versions)
    if (name != "nilas") program += ", " + name + " " + version;
  // this is the file that runs, even if another file has taken its name since
  return {program + ")", scene::file_sha256("/proc/self/exe"), scene_fingerprint};
}

}  // namespace nilas::commands
