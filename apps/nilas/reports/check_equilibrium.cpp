#include "apps/nilas/reports/check_equilibrium.h"

#include <fmt/format.h>

#include <cmath>

#include "core/base/error.h"
#include "hydro/equilibrium.h"

namespace nilas::commands {

static const char* held_by(const scene::VesselScene& vessel) {
  if (vessel.fixed) return "fixed";
  return vessel.carriage ? "carriage" : "none";
}

/// An angle [rad] in degrees with its side, "0 deg" if it is no more than rounding.
static std::string towards(double angle, const char* positive, const char* negative) {
  constexpr double k_rounding = 1e-9;  // [deg]
  const double degrees = angle / k_deg;
  if (std::abs(degrees) < k_rounding) return "0 deg";
  return fmt::format("{:.6g} deg {}", std::abs(degrees), degrees > 0 ? positive : negative);
}

static std::string describe(const hydro::FloatingEquilibrium& found, const hydro::Water& water,
                            const scene::VesselScene& vessel) {
  std::string text = fmt::format(
      "  draught {:.6g} m at the deepest point, trim {}, heel {}\n"
      "  GM transverse {:.6g} m, longitudinal {:.6g} m{}\n"
      "  displacement {:.6g} m^3, {:.6g} kg\n",
      found.draught, towards(found.trim, "by the bow", "by the stern"), towards(found.heel, "to starboard", "to port"),
      found.gm_transverse, found.gm_longitudinal,
      found.stable() ? "" : ": UNSTABLE, it would capsize or loll from here", found.volume,
      water.density * found.volume);
  constexpr double k_across = 2;  // a ship's transverse GM is a small fraction of its longitudinal GM
  if (found.gm_longitudinal > 0 && found.gm_transverse > k_across * found.gm_longitudinal)
    text +=
        "  The transverse GM is far above the longitudinal one. The hull may lie\n"
        "  across: x of its frame must point forward (nilas hull --forward).\n";
  if (vessel.fixed || vessel.carriage)
    text += fmt::format("  ({}; it would float like this if it were released)\n",
                        vessel.fixed ? "the vessel is fixed" : "the vessel is on a carriage");
  return text;
}

std::optional<EquilibriumReport> vessel_equilibrium(const scene::Scene& scene, const sim::WorldParts& parts) {
  if (!scene.vessel || !parts.water || !scene.hydro || !scene.hydro->buoyancy) return std::nullopt;
  const scene::VesselScene& vessel = *scene.vessel;
  if (!vessel.parts.empty() || !vessel.rods.empty())
    return std::nullopt;  // the hull alone does not float as the whole does
  const auto b = static_cast<std::size_t>(parts.vessel_index);
  EquilibriumReport report;
  report.text = fmt::format("\nfloating equilibrium of '{}':\n", vessel.name);
  report.json = {{"vessel", vessel.name}, {"held", held_by(vessel)}};
  try {
    const hydro::FloatingEquilibrium found =
        hydro::floating_equilibrium(*parts.bodies.shape[b], parts.bodies.mass[b], parts.bodies.q_GB[b], *parts.water);
    report.text += describe(found, *parts.water, vessel);
    report.json.update({{"floats", true},
                        {"stable", found.stable()},
                        {"draught_m", found.draught},
                        {"trim_deg", found.trim / k_deg},
                        {"heel_deg", found.heel / k_deg},
                        {"gm_transverse_m", found.gm_transverse},
                        {"gm_longitudinal_m", found.gm_longitudinal},
                        {"displaced_volume_m3", found.volume}});
  } catch (const InputError& error) {
    report.text += fmt::format("  none: {}\n", error.what());
    report.json.update({{"floats", false}, {"message", error.what()}});
  }
  return report;
}

}  // namespace nilas::commands
