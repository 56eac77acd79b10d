#include "core/sim/implausible.h"

#include <fmt/format.h>

namespace nilas {

static void doubt_ice(const Scene& scene, const WorldParts& parts, std::vector<Fault>& warnings) {
  if (!scene.ice || !parts.water || scene.ice->density < parts.water->density) return;
  warnings.push_back(warning_at(
      scene, "ice/@density",
      fmt::format("ice of {:g} kg/m^3 sinks in water of {:g} kg/m^3", scene.ice->density, parts.water->density)));
}

void note_implausible(const Scene& scene, WorldParts& parts) {
  parts.info.warnings = scene.warnings;
  doubt_ice(scene, parts, parts.info.warnings);
}

}  // namespace nilas
