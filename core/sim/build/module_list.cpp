#include "core/sim/build/module_list.h"

#include <algorithm>

#include "contact/registry.h"
#include "core/sim/build/breaking_settings.h"
#include "core/sim/build/crushing_settings.h"
#include "fracture/model/ice_modules.h"
#include "hydro/modules.h"

namespace nilas::sim {

namespace {

BuiltModule buoyancy(const ModuleSources& from) {
  if (!from.scene.hydro || !from.scene.hydro->buoyancy) return {};
  return {hydro::make_buoyancy(*from.parts.water, from.threads), "<hydro><buoyancy>"};
}

BuiltModule drag(const ModuleSources& from) {
  if (!from.scene.hydro || !from.scene.hydro->drag) return {};
  // A solver that keeps mirrored scenes mirrored needs loads that do not differ by rounding.
  const bool order_free = contact::find_solver(from.scene.contact.solver).order_free;
  const auto& drag = *from.scene.hydro->drag;
  return {hydro::make_drag(*from.parts.water, {drag.form, drag.skin}, from.threads, order_free),
          order_free ? "<hydro><drag>, order-free for the solver" : "<hydro><drag>"};
}

BuiltModule virtual_drag(const ModuleSources& from) {
  if (!from.scene.hydro || !from.scene.hydro->virtual_drag) return {};
  const auto& drag = *from.scene.hydro->virtual_drag;
  return {hydro::make_virtual_drag(drag.coefficient, drag.velocity), "<hydro><virtual_drag>"};
}

bool has_breakable_ice(const WorldParts& parts) {
  return parts.ice_properties &&
         std::any_of(parts.ice_properties->breakable.begin(), parts.ice_properties->breakable.end(),
                     [](char breakable) { return breakable != 0; });
}

bool crushes(const ModuleSources& from) {
  return from.scene.fracture && from.scene.fracture->crushing && has_breakable_ice(from.parts);
}

bool breaks(const ModuleSources& from) {
  return from.scene.fracture && (from.scene.fracture->bending || from.scene.fracture->splitting) &&
         has_breakable_ice(from.parts);
}

BuiltModule crushing(const ModuleSources& from) {
  if (!crushes(from)) return {};
  const bodies::Bodies& bodies = from.parts.bodies;
  return {fracture::make_crushing(crushing_settings(from.scene), bodies, *from.parts.ice_properties, from.warnings),
          crushing_description(from.scene, bodies)};
}

BuiltModule breaking(const ModuleSources& from) {
  if (!breaks(from)) return {};
  return {fracture::make_breaking(breaking_settings(from.scene), *from.parts.ice_properties),
          breaking_description(from.scene)};
}

BuiltModule pieces(const ModuleSources& from) {
  const bool clears = crushes(from) && from.scene.fracture->crushing->clear_volume;
  if (!breaks(from) && !clears) return {};
  return {fracture::make_pieces(piece_limits(from.scene), *from.parts.ice_properties, from.warnings), "<fracture>"};
}

}  // namespace

const ModuleList& scene_modules() {
  static const ModuleList modules{
      {"buoyancy", true, buoyancy}, {"drag", true, drag},         {"virtual_drag", true, virtual_drag},
      {"crushing", true, crushing}, {"breaking", true, breaking}, {"pieces", false, pieces},
  };
  return modules;
}

}  // namespace nilas::sim
