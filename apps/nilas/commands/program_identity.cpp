#include "apps/nilas/commands/program_identity.h"

#include "core/output/run/program_versions.h"
#include "core/scene/read/input_files.h"

namespace nilas::commands {

namespace {

std::string own_name() { return "nilas " + output::program_versions().at("nilas"); }

/// "cgal 5.5.1, compiler GNU 12.2.0, ...".
std::string built_with() {
  std::string list;
  for (const auto& [name, version] : output::program_versions())
    if (name != "nilas") list += (list.empty() ? "" : ", ") + name + " " + version;
  return list;
}

}  // namespace

std::string version_text() {
  return own_name() + "\nbuild: " + output::program_build() + "\nbuilt with: " + built_with();
}

sim::CheckpointOrigin checkpoint_origin(const std::string& scene_fingerprint) {
  const std::string program = own_name() + " (" + output::program_build() + ", " + built_with() + ")";
  // this is the file that runs, even if another file has taken its name since
  return {program, scene::file_sha256("/proc/self/exe"), scene_fingerprint};
}

}  // namespace nilas::commands
