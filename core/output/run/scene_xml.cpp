#include "core/output/run/scene_xml.h"

#include "core/output/file/output_file.h"

namespace nilas::output {

void write_scene_xml(const std::filesystem::path& path, const scene::Scene& scene) {
  write_whole(path, scene.as_run, Flush::now);
}

}  // namespace nilas::output
