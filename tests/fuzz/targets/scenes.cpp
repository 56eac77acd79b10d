/// Scenes, overrides and the mooring in a file of its own.
#include <sstream>

#include "core/scene/read/read_scene.h"
#include "tests/fuzz/targets.h"

namespace nilas::fuzz {

namespace {

constexpr const char* k_small_scene = R"(<scene version="1">
  <time step="0.01" end="1"/>
  <ice><floe id="1" thickness="0.1"><box size="1 1" position="0 0"/></floe></ice>
</scene>)";

constexpr const char* k_moored_scene = R"(<scene version="1">
  <time step="0.01" end="1"/>
  <vessel hull="hull.stl" control="free"><mooring file="mooring.xml"/></vessel>
</scene>)";

}  // namespace

void scene(std::string_view bytes) {
  const auto file = file_with("scene.xml", "");
  read_or_refuse([&] { scene::read_scene_text(std::string(bytes), file); });
}

void overrides(std::string_view bytes) {
  const auto file = file_with("scene.xml", "");
  read_or_refuse([&] {
    std::istringstream lines{std::string(bytes)};
    scene::Overrides all;
    for (std::string line; std::getline(lines, line);) all.push_back(scene::split_override(line));
    scene::read_scene_text(k_small_scene, file, all);
  });
}

void mooring(std::string_view bytes) {
  file_with("mooring.xml", bytes);
  const auto file = file_with("scene.xml", "");
  read_or_refuse([&] { scene::read_scene_text(k_moored_scene, file); });
}

}  // namespace nilas::fuzz
