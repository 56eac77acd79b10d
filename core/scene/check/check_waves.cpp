#include "core/choices/wave_choices.h"
#include "core/scene/check/cross_checks.h"
#include "core/scene/elements/wave_scene.h"
#include "core/scene/schema/attribute_values.h"
#include "core/scene/spec/values.h"

namespace nilas::scene {

static void check_wave(const SceneElement& waves, std::vector<Fault>& faults) {
  const auto kind = choice_of<WaveKind>(waves, "kind");
  const auto period = number_of(waves, "period"), shortest = number_of(waves, "shortest_period");
  if (kind && *kind != WaveKind::regular && period && shortest && !(*shortest < *period))
    faults.push_back(fault_of(waves, "shortest_period",
                              "found " + format_number(*shortest) +
                                  "; allowed: shorter than the period of the peak, < " + format_number(*period) +
                                  " [s]"));
  const auto attenuation = choice_of<WaveAttenuation>(waves, "attenuation");
  if (attenuation && *attenuation != WaveAttenuation::none && !is_named(waves, "ice_edge"))
    faults.push_back(fault_of(waves, "attenuation",
                              "found '" + name_of(*attenuation) +
                                  "' without ice_edge; allowed: with a point of the "
                                  "ice edge, or none"));
}

/// Loads need waves, the buoyancy of still water to which the pressure of waves adds, and a database where they name
/// it.
static void check_wave_loads(const SceneElement& root, const SceneElement& hydro, const SceneElement& loads,
                             std::vector<Fault>& faults) {
  const SceneElement* water = child_of(root, "water");
  if (!water || !is_named(*water, "waves"))
    faults.push_back(fault_of(loads, "the scene has no waves; allowed: with <water><waves>"));
  const auto vessel = choice_of<VesselWaveLoads>(loads, "vessel");
  const auto floes = choice_of<FloeWaveLoads>(loads, "floes");
  const bool on_vessel = vessel == VesselWaveLoads::froude_krylov && is_named(root, "vessel");
  const bool pressure = on_vessel || floes == FloeWaveLoads::froude_krylov;
  if (pressure && !is_named(hydro, "buoyancy"))
    faults.push_back(fault_of(loads, on_vessel ? "vessel" : "floes",
                              "Froude-Krylov loads add to the pressure of still water; allowed: with <buoyancy>"));
  const bool diffracted = vessel == VesselWaveLoads::froude_krylov &&
                          choice_of<VesselDiffraction>(loads, "diffraction") == VesselDiffraction::database;
  if (vessel != VesselWaveLoads::database && !diffracted) return;
  const char* attribute = diffracted ? "diffraction" : "vessel";
  if (!is_named(root, "vessel"))
    faults.push_back(fault_of(loads, attribute, "the scene has no vessel; allowed: a scene with <vessel>"));
  else if (!is_named(hydro, "database"))
    faults.push_back(fault_of(loads, attribute, "the scene names no database; allowed: with <hydro><database>"));
}

void check_waves(const SceneElement& root, std::vector<Fault>& faults) {
  if (const SceneElement* water = child_of(root, "water"))
    for (const auto& child : water->children)
      if (child.name == "waves") check_wave(child, faults);
  const SceneElement* hydro = child_of(root, "hydro");
  const SceneElement* loads = hydro ? child_of(*hydro, "wave_loads") : nullptr;
  if (loads) check_wave_loads(root, *hydro, *loads, faults);
}

}  // namespace nilas::scene
