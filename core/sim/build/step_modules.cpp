#include "core/sim/build/step_modules.h"

#include <algorithm>

#include "core/sim/build/breaking_settings.h"
#include "core/sim/build/crushing_settings.h"
#include "core/sim/world/contact_model.h"

namespace nilas {

static bool has_breakable_ice(const WorldParts& parts) {
  return parts.ice_properties &&
         std::any_of(parts.ice_properties->breakable.begin(), parts.ice_properties->breakable.end(),
                     [](char breakable) { return breakable != 0; });
}

bool has_crushing(const Scene& scene, const WorldParts& parts) {
  return scene.fracture && scene.fracture->crushing && has_breakable_ice(parts);
}

bool has_breaking(const Scene& scene, const WorldParts& parts) {
  return scene.fracture && (scene.fracture->bending || scene.fracture->splitting) && has_breakable_ice(parts);
}

bool clears_crushed_ice(const Scene& scene, const WorldParts& parts) {
  return has_crushing(scene, parts) && scene.fracture->crushing->clear_volume;
}

void list_step_modules(const Scene& scene, WorldParts& parts) {
  const ContactScene& contact = scene.contact;
  parts.info.modules.emplace_back(
      "contact", "law " + name_of(contact.law) + ", solver " + name_of(contact.solver) + ", stabilisation " +
                     name_of(contact.stabilisation) + ", detection " + name_of(contact.detection) + ", narrow phase " +
                     name_of(contact.narrow_phase) + ", integrator " + name_of(contact.integrator) +
                     (has_static_friction(contact) ? ", static friction above kinetic" : ""));
  if (has_crushing(scene, parts))
    parts.info.modules.emplace_back("crushing", crushing_description(scene, parts.bodies));
  if (has_breaking(scene, parts)) parts.info.modules.emplace_back("breaking", breaking_description(scene));
}

}  // namespace nilas
