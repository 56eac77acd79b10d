#include "apps/report/page/headline.h"

#include <fmt/format.h>

#include <cmath>

#include "apps/report/page/words.h"
#include "core/base/error.h"
#include "core/output/loads/step_load.h"

namespace nilas::report {

namespace {

/// What the ice did: "the ice pushed the vessel back with 41 kN on average".
std::string push_text(const RunFindings& found) {
  const double mean = found.load->along.statistics.mean;
  if (found.load->is_vessel())
    return fmt::format("the ice pushed the vessel {} with {} on average", mean < 0 ? "forward" : "back",
                       output::force_text(std::abs(mean)));
  return fmt::format("the ice pushed '{}' {} the drift with {} on average", found.load->name,
                     mean < 0 ? "against" : "along", output::force_text(std::abs(mean)));
}

std::string sureness(const BodyLoad& load) {
  if (!load.along.half_width) return "; how exact this mean is cannot be said, since the window has too few steps";
  const std::string error = error_force(*load.along.half_width, load.along.statistics.mean);
  if (load.is_unsteady()) return ", uncertain by more than " + error + " since it was not steady";
  if (load.error_at_least) return ", known to within " + error + " at best";
  if (load.chance_alone) return ", which chance alone makes uncertain by " + error;
  return ", known to within " + error;
}

std::string largest(const RunFindings& found) {
  const output::Peak& peak = found.load->along.peak;
  const auto sides = sides_along(found.load->is_vessel());
  std::string text = fmt::format("the largest load of one step was {} at {}", output::sided_force(peak.raw, sides),
                                 time_text(peak.raw_time, found.run.step()));
  if (!found.cause) return text;
  constexpr double k_half = 0.5;
  const PeakCause& cause = *found.cause;
  const char* part = cause.floes == 1 ? "by" : cause.share >= k_half ? "mostly by" : "most of all by";
  text += fmt::format(", {} {} {}", part, found.floe_made_peak ? "floe" : "body", cause.floe);
  return text;
}

/// Which body made the largest load, and how much of it.
std::string who_text(const RunFindings& found) {
  constexpr double k_percent = 100;
  const PeakCause& cause = *found.cause;
  const char* kind = found.floe_made_peak ? "Floe" : "Body";
  if (cause.floes == 1) return fmt::format("{} {} alone made this load", kind, cause.floe);
  if (cause.share > 1)
    return fmt::format("{} {} made this load: it pushed with {:.0f} % of it, and others pushed the other way", kind,
                       cause.floe, k_percent * cause.share);
  return fmt::format("{} {} made {:.0f} % of this load, to which {} {} contributed", kind, cause.floe,
                     k_percent * cause.share, cause.floes, found.floe_made_peak ? "floes" : "bodies");
}

/// The load across the course in the step of the largest load, which may be the larger part.
std::string across_text(const RunFindings& found) {
  const RunData& run = found.run;
  const RunTable& table = found.load->is_vessel() ? run.vessel : run.structures;
  const std::string column = found.load->is_vessel() ? "ice_side_N" : found.load->name + "_ice_side_N";
  if (!table.has(column)) return "";
  const std::vector<double>& across = table[column];
  for (std::size_t k = 0; k < across.size(); ++k)
    if (std::abs(run.times()[k] - found.load->along.peak.raw_time) < 0.5 * run.step())
      return fmt::format("In the same step the ice pushed with {} across the course.",
                         output::force_text(std::abs(across[k])));
  return "";
}

std::string cause_text(const RunFindings& found) {
  const PeakCause& cause = *found.cause;
  if (!found.body->is_vessel)
    return fmt::format("{}. It acted at {}.", who_text(found), horizontal_place_text(cause.place));
  return fmt::format("{}. It acted {} ({} in the frame of the hull).", who_text(found),
                     place_on_vessel(cause.place, found.body->mesh), place_text(cause.place));
}

/// How many steps the solver did not solve, and whether the largest load is from one of them; empty where it solved all
/// or was asked for no tolerance.
std::string unsolved_text(const RunFindings& found) {
  const RunData& run = found.run;
  if (!run.scene || !(run.scene->contact.tolerance > 0) || !run.summary.contains("shortfalls")) return "";
  const long count = run.summary.at("shortfalls").value("unconverged_steps", 0L);
  if (count == 0) return "";
  bool has_peak = false;
  if (run.steps.has("law_map_m_s"))
    for (std::size_t k = 0; k < run.steps.rows(); ++k)
      if (std::abs(run.steps["time_s"][k] - found.load->along.peak.raw_time) < 0.5 * run.step())
        has_peak = run.steps["law_map_m_s"][k] > run.scene->contact.tolerance;
  const std::string steps = fmt::format("In {} of {} steps", count, run.steps.rows());
  return has_peak ? steps +
                        ", that of the largest load among them, the solver ended above its tolerance. Do not use "
                        "this peak."
                  : steps + " the solver ended above its tolerance, but not in that of the largest load.";
}

std::vector<std::string> limits(const RunFindings& found) {
  const BodyLoad& load = *found.load;
  std::vector<std::string> text;
  const double mean = load.along.statistics.mean;
  if (load.along.half_width && *load.along.half_width > std::abs(mean))
    text.emplace_back("The mean cannot be told from zero: its error is larger than itself. Run longer.");
  if (load.is_unsteady())
    text.push_back(fmt::format(
        "The load is not steady: its mean was {} over the first half of the window and {} over the second. Either it "
        "still changes or the window holds too little ice. Run longer.",
        sided_mean(load.along.halves->first.mean, load.along.halves->first.half_width, sides_along(load.is_vessel())),
        sided_mean(load.along.halves->second.mean, load.along.halves->second.half_width,
                   sides_along(load.is_vessel()))));
  text.push_back(
      fmt::format("The window is {:.4g} s to {:.4g} s: {}.", load.window.from, load.window.to, load.window.reason));
  if (std::string unsolved = unsolved_text(found); !unsolved.empty()) text.push_back(std::move(unsolved));
  const output::StepLoadError step = output::step_load_error_of(found.run.summary);
  if (step.is_doubted()) text.push_back(output::step_load_text(step));
  if (!load.peak_depends.empty()) text.push_back(load.peak_depends);
  if (load.on_step) text.push_back(output::figures_to_use(*load.on_step, load.error_at_least));
  text.emplace_back(
      "The error does not cover other ice of the same kind. Run other seeds (--seed) and compare the means.");
  return text;
}

std::string without_load(const RunFindings& found) {
  if (found.loads.empty())
    return "The run has no vessel and no fixed body in its tables, so it has no ice load. The report shows energy, "
           "solver and time.";
  return fmt::format("No ice pressed on {} from {:.4g} s to {:.4g} s.", found.subject(), found.load->window.from,
                     found.load->window.to);
}

/// Empty for a run that did not end before its time.
std::string ending_text(const RunData& run) {
  const std::string status = run.summary.is_object() ? run.summary.value("status", "") : "";
  if (run.steps.rows() == 0 || (status != "interrupted" && status != "failed")) return "";
  const std::string when = run.scene ? fmt::format("at {:.6g} s of {:.6g} s", run.times().back(), run.scene->time.end)
                                     : fmt::format("at {:.6g} s", run.times().back());
  if (status == "failed")
    return "The run failed " + when + ", and all figures are those up to there. nilas.log says why.";
  return "The run was interrupted " + when +
         ", and all figures are those up to there. nilas run --resume with its folder continues it.";
}

std::string tow_text(const RunFindings& found) {
  const auto& tow = found.run.summary.at("tow_force");
  return fmt::format("The carriage pulled with {} on average, at {:.4g} m/s.",
                     output::force_text(tow.at("mean_N").get<double>()), tow.at("speed_m_s").get<double>());
}

}  // namespace

std::vector<std::string> headline(const RunFindings& found) {
  std::vector<std::string> text;
  if (std::string ending = ending_text(found.run); !ending.empty()) text.push_back(std::move(ending));
  if (found.load == nullptr || !found.load->touched) {
    text.push_back(without_load(found));
  } else {
    const output::LoadWindow& window = found.load->window;
    text.push_back(fmt::format("Over {:.4g} to {:.4g} s {}{}; {}.", window.from, window.to, push_text(found),
                               sureness(*found.load), largest(found)));
    if (found.cause) text.push_back(cause_text(found));
    if (std::string across = across_text(found); !across.empty()) text.push_back(std::move(across));
    for (std::string& limit : limits(found)) text.push_back(std::move(limit));
  }
  if (found.run.summary.contains("tow_force")) text.push_back(tow_text(found));
  return text;
}

std::string peak_address(const RunFindings& found) {
  if (found.load == nullptr || !found.load->touched) return "";
  std::string address = fmt::format("replay.html#t={:.9g}", found.load->along.peak.raw_time);
  if (found.cause) address += fmt::format("&pick={}", found.cause->floe);
  return address;
}

}  // namespace nilas::report
