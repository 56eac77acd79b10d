#include "core/choices/database_files.h"
#include "core/choices/water_choices.h"
#include "core/choices/wave_choices.h"
#include "core/scene/check/cross_checks.h"
#include "core/scene/schema/attribute_values.h"

namespace nilas::scene {

static void check_restoring(const SceneElement& root, const SceneElement& hydro, const SceneElement& restoring,
                            std::vector<Fault>& faults) {
  const auto refuse = [&](const std::string& message) { faults.push_back(fault_of(restoring, message)); };
  if (!is_named(hydro, "database")) refuse("the scene names no database; allowed: with <hydro><database>");
  const SceneElement* vessel = child_of(root, "vessel");
  if (!vessel) return refuse("the scene has no vessel; allowed: with <vessel>");
  if (is_named(*vessel, "carriage") || is_named(*vessel, "part") || is_named(*vessel, "fixed"))
    refuse(
        "the linear hydrostatics of a database are those of a whole free vessel; allowed: without <carriage>, "
        "<fixed> and <part>");
  if (is_named(*vessel, "mooring"))
    refuse("the rest of a moored vessel is sought with the pressure on its mesh; allowed: without <mooring>");
  const SceneElement* loads = child_of(hydro, "wave_loads");
  if (loads && choice_of<VesselWaveLoads>(*loads, "vessel") == VesselWaveLoads::froude_krylov)
    refuse(
        "Froude-Krylov loads on the vessel add to the pressure on its mesh; allowed: with wave_loads "
        "vessel=\"database\" or \"none\"");
}

static void check_radiation(const SceneElement& root, const SceneElement& hydro, const SceneElement& radiation,
                            std::vector<Fault>& faults) {
  const auto refuse = [&](const std::string& message) { faults.push_back(fault_of(radiation, message)); };
  const SceneElement* hull = child_of(root, "vessel");
  if (!is_named(root, "vessel")) refuse("the scene has no vessel; allowed: with <vessel>");
  if (hull && is_named(*hull, "fixed"))
    refuse("a vessel that does not move makes no waves; allowed: with a vessel without <fixed>");
  if (!is_named(hydro, "database")) return refuse("the scene names no database; allowed: with <hydro><database>");
  const SceneElement* added = child_of(hydro, "added_mass");
  const auto vessel = added ? choice_of<VesselAddedMass>(*added, "vessel") : std::nullopt;
  if (is_misspelt(hydro, "added_mass") || (added && !vessel)) return;
  if (vessel != VesselAddedMass::database)
    refuse(
        "the added mass at infinite frequency is missing, without which radiation is only one half of the load; "
        "allowed: with <hydro><added_mass vessel=\"database\">");
}

void check_database(const SceneElement& root, std::vector<Fault>& faults) {
  const SceneElement* hydro = child_of(root, "hydro");
  if (const SceneElement* restoring = hydro ? child_of(*hydro, "restoring") : nullptr)
    check_restoring(root, *hydro, *restoring, faults);
  if (const SceneElement* radiation = hydro ? child_of(*hydro, "radiation") : nullptr)
    check_radiation(root, *hydro, *radiation, faults);
  const SceneElement* database = hydro ? child_of(*hydro, "database") : nullptr;
  if (!database) return;
  if (!is_named(root, "vessel"))
    faults.push_back(fault_of(*database, "the scene has no vessel; allowed: with <vessel>"));
  const auto file = text_of(*database, "file");
  if (!file) return;
  if (!is_wamit_file(*file)) {
    if (attribute_of(*database, "length"))
      faults.push_back(fault_of(*database, "length",
                                "only WAMIT's results are divided by a length, and the file is none of them; allowed: "
                                "without this attribute"));
    return;
  }
  for (const char* name : {"length", "density", "gravity"})
    if (!attribute_of(*database, name))
      faults.push_back(fault_of(*database, "the attribute " + std::string(name) +
                                               " is missing; WAMIT's results have no dimensions, so length (ULEN), "
                                               "density and gravity must be given"));
}

}  // namespace nilas::scene
