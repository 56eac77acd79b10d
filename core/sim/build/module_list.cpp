#include "core/sim/build/module_list.h"

#include <algorithm>

#include "contact/registry.h"
#include "core/sim/build/module/breaking_settings.h"
#include "core/sim/build/module/crushing_settings.h"
#include "core/sim/build/module/flow_modules.h"
#include "core/sim/build/module/hull_water_modules.h"
#include "core/sim/build/module/manoeuvring_module.h"
#include "core/sim/build/module/remote_module.h"
#include "core/sim/build/module/thruster_modules.h"
#include "core/sim/build/module/wave_modules.h"
#include "core/sim/build/moored_vessel.h"
#include "core/vessel/mooring/moordyn_module.h"
#include "core/vessel/mooring/mooring_module.h"
#include "fracture/model/ice_modules.h"
#include "hydro/modules.h"

namespace nilas::sim {

namespace {

BuiltModule buoyancy(const ModuleSources& from) {
  if (!from.scene.hydro || !from.scene.hydro->buoyancy) return {};
  const bool without_vessel = from.scene.hydro->restoring;
  return {hydro::make_buoyancy(*from.parts.water, from.threads, without_vessel),
          without_vessel ? "<hydro><buoyancy>, but of the vessel by <restoring>" : "<hydro><buoyancy>"};
}

BuiltModule drag(const ModuleSources& from) {
  if (!from.scene.hydro || !from.scene.hydro->drag) return {};
  // A solver that keeps mirrored scenes mirrored needs loads that do not differ by rounding.
  const bool order_free = contact::find_solver(from.scene.contact.solver).order_free;
  const auto& drag = *from.scene.hydro->drag;
  const bool elsewhere = from.scene.vessel && from.scene.vessel->manoeuvring;
  return {hydro::make_drag(*from.parts.water, {drag.form, drag.skin}, from.threads, order_free, elsewhere),
          std::string("<hydro><drag>") + (order_free ? ", order-free for the solver" : "") +
              (elsewhere ? ", on the vessel in heave, roll and pitch only, since it has <manoeuvring>" : "")};
}

BuiltModule virtual_drag(const ModuleSources& from) {
  if (!from.scene.hydro || !from.scene.hydro->virtual_drag) return {};
  const auto& drag = *from.scene.hydro->virtual_drag;
  return {hydro::make_virtual_drag(drag.coefficient, drag.velocity), "<hydro><virtual_drag>"};
}

BuiltModule mooring(const ModuleSources& from) {
  const auto& given = from.scene.vessel ? from.scene.vessel->mooring : std::nullopt;
  if (!given) return {};
  if (given->model == MooringKind::moordyn) {
    const vessel::MoordynApi api = vessel::load_moordyn();
    const vessel::MoordynSettings settings{given->file, from.parts.info.vessel_mass.com,
                                           from.scene.water ? from.scene.water->level : 0, from.parts.vessel_index};
    return {vessel::make_moordyn_mooring(api, settings, from.parts.bodies),
            "<vessel><mooring model=\"moordyn\">, library " + api.name};
  }
  return {vessel::make_mooring(*from.parts.mooring, from.parts.vessel_index, from.parts.bodies, from.warnings),
          mooring_reason(from.parts)};
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
      // Loads of water and wind.
      {"buoyancy", true, buoyancy},
      {"restoring", true, restoring},
      {"drag", true, drag},
      {"virtual_drag", true, virtual_drag},
      {"added_mass", true, added_mass},
      {"radiation", true, radiation},
      {"wave_loads", true, wave_loads},
      {"database_tilt", false, database_tilt},
      {"wind", true, wind},
      {"mooring", true, mooring},
      // Ice that breaks.
      {"crushing", true, crushing},
      {"breaking", true, breaking},
      {"pieces", false, pieces},
      // Actuators, what follows them, and what commands them.
      {"manoeuvring", true, build_manoeuvring},
      {"thruster", true, build_thrusters},
      {"propeller_wash", true, propeller_wash},
      {"control", true, build_control},
      {"manoeuvre", true, build_manoeuvre},
      {"remote control", true, remote_control},
  };
  return modules;
}

}  // namespace nilas::sim
