#include "core/sim/build/module/crushing_settings.h"

#include <fmt/format.h>

#include "core/base/error.h"
#include "fracture/model/crushing_surface.h"

namespace nilas::sim {

fracture::CrushingSettings crushing_settings(const scene::Scene& scene) {
  NILAS_DEMAND(scene.fracture && scene.fracture->crushing);
  const scene::CrushingScene& crushing = *scene.fracture->crushing;
  const fracture::CrushingLaw law{crushing.model, crushing.coefficient, crushing.exponent,
                                  scene.fracture->compressive_strength};
  return {law, crushing.between_floes, crushing.clear_volume};
}

std::string crushing_description(const scene::Scene& scene, const bodies::Bodies& bodies) {
  NILAS_DEMAND(scene.fracture && scene.fracture->crushing);
  std::string text = "<fracture><crushing>: " + name_of(scene.fracture->crushing->model);
  if (scene.fracture->crushing->between_floes) text += ", of floes by each other too";
  if (const auto& volume = scene.fracture->crushing->clear_volume)
    text += fmt::format(", cut out from {:g} m^3 on", *volume);
  for (std::size_t b = 0; b < bodies.id.size(); ++b)
    if (bodies.kind[b] == bodies::BodyKind::rigid && !fracture::has_crushing_surface(*bodies.shape[b]))
      text += "; '" + bodies.name[b] + "' has no flat faces and stays rigid";
  return text;
}

}  // namespace nilas::sim
