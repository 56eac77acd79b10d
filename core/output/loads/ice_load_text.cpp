#include "core/output/loads/ice_load_text.h"

#include <fmt/format.h>

#include <cmath>

#include "core/output/text/console.h"
#include "core/sim/account/unsolved_advice.h"

namespace nilas::output {

namespace {

/// A number without exponent, with this number of significant digits.
std::string plain(double x, int digits) {
  if (x == 0 || !std::isfinite(x)) return fmt::format("{:g}", x);
  const int decimals = std::max(0, digits - 1 - static_cast<int>(std::floor(std::log10(std::abs(x)))));
  const double unit = std::pow(10, std::floor(std::log10(std::abs(x))) - digits + 1);
  return fmt::format("{:.{}f}", std::round(x / unit) * unit, decimals);
}

constexpr LoadSides k_along{"along"}, k_across{"across"};  // of structures, which have no bow
constexpr LoadSides k_along_drift{"along the drift"}, k_across_drift{"across the drift"};

/// A number without its sign where a word tells it.
double magnitude(double x, const LoadSides& sides) { return sides.negative != nullptr ? std::abs(x) : x; }

std::string side(double x, const LoadSides& sides) {
  return x < 0 && sides.negative != nullptr ? sides.negative : sides.positive;
}

/// A mean with its error and its side, as "16.9 N +- 2.1 N astern", both in the unit of the larger.
std::string with_error(double mean, const std::optional<double>& half_width, const LoadSides& sides,
                       bool at_least = false) {
  constexpr int k_error_digits = 2;
  const ForceUnit unit = force_unit(std::max(std::abs(mean), half_width.value_or(0)));
  const std::string error = half_width ? fmt::format(" +- {}{} {}", at_least ? "at least " : "",
                                                     plain(*half_width / unit.size, k_error_digits), unit.name)
                                       : " (+- not known)";
  return fmt::format("{:.4g} {}{} {}", magnitude(mean, sides) / unit.size, unit.name, error, side(mean, sides));
}

std::string mean_text(const ComponentLoad& load, const LoadSides& sides, bool at_least = false) {
  return with_error(load.statistics.mean, load.half_width, sides, at_least);
}

std::string window_text(const IceLoad& load) {
  return fmt::format("{:g} s to {:g} s, {}", load.window.from, load.window.to, load.window.reason);
}

std::string peak_lines(const IceLoad& load, const LoadSides& sides_along, const LoadSides& sides_across) {
  const Peak &along = load.along.peak, &across = load.across.peak;
  const bool turned = along.raw < 0 && sides_along.negative != nullptr;
  std::string text =
      account_line("  filtered peak",
                   fmt::format("{} at {:.5g} s, {}: means over {:.2g} s", sided_force(along.filtered, sides_along),
                               along.filtered_time, sided_force(across.filtered, sides_across), load.filter));
  text += account_line(
      "  raw peak",
      fmt::format("{} in one step, at {:g} s; the impact around it lasts {:.2g} s and has an impulse of {:.3g} "
                  "N s. {}",
                  sided_force(along.raw, sides_along), along.raw_time, along.event_to - along.event_from,
                  turned ? -along.event_impulse : along.event_impulse, raw_peak_depends_on(load)));
  if (load.impacts_dominate())
    text += account_line("  advice",
                         fmt::format("1 % of the window's steps carry {:.0f} % of its load: single rigid impacts. Let "
                                     "the ice crush (<fracture><crushing>, breakable ice) to limit them to the "
                                     "strength of ice.",
                                     100 * load.in_largest));
  return text;
}

/// A sentence on a component whose means over the halves of the window differ; empty where they do not.
std::string halves_line(const ComponentLoad& load, const LoadSides& sides) {
  if (!load.halves || !load.halves->differ()) return "";
  const HalfMean &first = load.halves->first, &second = load.halves->second;
  return account_line(
      "  not steady",
      fmt::format("The mean was {} over the first half of the window and {} over the second. Either "
                  "the load still changes or the window holds too little ice: run longer.",
                  with_error(first.mean, first.half_width, sides), with_error(second.mean, second.half_width, sides)));
}

std::string error_text(const LoadError& error) {
  const ChannelError& load = error.channels[error.headline];
  std::string text = fmt::format("solver {}{}, contact law {}{}", error.solver_at_least ? "at least " : "",
                                 force_text(load.solver), error.law_at_least ? "at least " : "", force_text(load.law));
  if (load.chaos) text += fmt::format(", chance in this ice {}", force_text(*load.chaos));
  text += load.chaos ? ". The effect of the time step is not known"
                     : ". The effects of chance and the time step are not known";
  if (load.chaos && !error.from_twins)
    text +=
        ". One run cannot know how chaotic its ice is, and takes all fast changes of the load as chance: --twins "
        "measures it";
  if (error.law_at_least)
    text += ". A law other than contact/@law=\"coulomb\" also moves the ice differently, which is not in the +-";
  if (error.solver_at_least)
    text += fmt::format(
        ". In {} of the window's steps the solver residual was above the scene's tolerance{}; the effect on the "
        "motion of the ice is not known. {}{}",
        percent_text(error.share_short), error.ice_broke ? " or above a thousandth of the vessel's speed" : "",
        sim::k_unsolved_advice, error.ice_broke ? ", or a smaller contact/@tolerance" : "");
  return text + ". The +- does not cover other ice of the same kind: run other seeds (--seed) and compare the means.";
}

std::string tow_lines(const TowForce& tow) {
  constexpr double k_negligible = 1e-6;
  const auto is_some = [&](double newton) { return std::abs(newton) > k_negligible * std::abs(tow.mean); };
  const auto part = [&](double newton) { return force_text(is_some(newton) ? newton : 0); };
  std::string modules;
  for (const auto& [name, newton] : tow.modules) modules += fmt::format("{} {}, ", name, part(newton));
  std::string text = account_line(
      "tow force", fmt::format("{} forward: ice {}, water {}, {}inertia{} {}{}", force_text(tow.mean), part(tow.ice),
                               part(tow.water), modules, tow.on_rods ? " and rods" : "", part(tow.inertia),
                               is_some(tow.others) ? ", other contacts " + part(tow.others) : ""));
  if (tow.open_water)
    text += account_line("  less open water",
                         fmt::format("{} after deduction of {} in open water ({})", force_text(tow.net()),
                                     force_text(*tow.open_water), tow.open_water_source));
  return text;
}

}  // namespace

ForceUnit force_unit(double newton) {
  constexpr double k_kilo = 1e3, k_mega = 1e6, k_from = 10;
  if (std::abs(newton) >= k_from * k_mega) return {"MN", k_mega};
  if (std::abs(newton) >= k_from * k_kilo) return {"kN", k_kilo};
  return {"N", 1};
}

std::string force_text(double newton) {
  const ForceUnit unit = force_unit(newton);
  return fmt::format("{:.4g} {}", newton / unit.size, unit.name);
}

std::string sided_force(double newton, const LoadSides& sides) {
  return force_text(magnitude(newton, sides)) + " " + side(newton, sides);
}

std::string raw_peak_depends_on(const IceLoad& load) {
  if (load.peak_is_impulse_over_step())
    return fmt::format(
        "This peak is one impact, and its force is the impulse over the time step of {:g} s: half the step gives "
        "about twice the force. Take the filtered peak, let the ice crush, or {}.",
        load.step, load.rigid ? "make the contacts elastic" : "take a step that resolves the elastic impact");
  if (load.rigid)
    return fmt::format("This peak depends on the time step of {:g} s: a rigid impact is over within one step.",
                       load.step);
  if (load.elastic)
    return fmt::format("This peak depends on the stiffness of the contacts and on the time step of {:g} s.", load.step);
  return fmt::format(
      "This peak depends on the crushing strength, on the size of the mesh faces that the ice meets and "
      "on the time step of {:g} s.",
      load.step);
}

std::string ice_load_lines(const IceLoad& load, const LoadError& error) {
  std::string text;
  if (!load.touched) {
    text = account_line("ice load", "none: no ice pressed on the hull in the window");
    text += account_line("  window", window_text(load));
  } else {
    text = account_line("ice load", fmt::format("{}, {}{}", mean_text(load.along, k_astern, error.at_least()),
                                                mean_text(load.across, k_to_port, error.at_least()),
                                                error.from_twins ? "; means over the run and its perturbed runs" : ""));
    text += account_line("  window", window_text(load));
    text += account_line("  deviation", fmt::format("{} along, {} across", force_text(load.along.statistics.std),
                                                    force_text(load.across.statistics.std)));
    text += peak_lines(load, k_astern, k_to_port);
    text += account_line("  sources of the +-", error_text(error));
    text += account_line("  to be used", figures_to_use(load.on_step, error.at_least()));
    text += halves_line(load.along, k_astern) + halves_line(load.across, k_to_port);
  }
  if (load.tow) text += tow_lines(*load.tow);
  return text;
}

std::string structure_lines(const StructureLoad& structure) {
  const std::string label = fmt::format("load on '{}'", structure.name);
  const IceLoad& ice = structure.ice;
  if (!ice.touched) return account_line(label, "none: no ice pressed on it");
  return account_line(label, fmt::format("{}, {}, from {:g} s to {:g} s", mean_text(ice.along, k_along),
                                         mean_text(ice.across, k_across_drift), ice.window.from, ice.window.to)) +
         account_line("  deviation", fmt::format("{} along, {} across", force_text(ice.along.statistics.std),
                                                 force_text(ice.across.statistics.std))) +
         peak_lines(ice, k_along, k_across) + account_line("  to be used", figures_to_use(ice.on_step, false)) +
         halves_line(ice.along, k_along_drift) + halves_line(ice.across, k_across_drift);
}

}  // namespace nilas::output
