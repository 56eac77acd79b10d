#include "apps/compare/scenes/report/methods.h"

#include <fmt/format.h>

#include <algorithm>

namespace nilas::compare {

namespace {

void say_reference_method(const SceneReport& report, std::vector<std::string>& lines) {
  const SceneStudy& study = report.study;
  const Findings& found = report.found;
  if (!found.judges.stand_in.empty()) {
    lines.push_back("The reference is " + found.judges.stand_in +
                    ", because no run of the intended reference is done.");
  } else if (study.reference != "auto") {
    lines.push_back("The reference is the run in " + study.reference + ".");
  } else if (study.event_driven) {
    lines.emplace_back(
        "The reference integrates the same scene between impacts with a local error of 1e-15 per step, 1e-13 on closed "
        "contacts (integrator reference). nilas verify checks it against closed-form solutions.");
  } else {
    const CompareSetting& r = study.plan.reference;
    lines.push_back(fmt::format(
        "The reference is solved by {} with steps of {:g} s, half the finest that is compared, integrator {}, to a "
        "tolerance of {:.0e} m/s. {}",
        r.solver, r.step, r.integrator, r.tolerance,
        found.check.moves ? fmt::format("With steps twice as long it changes by {}.",
                                        quantity_text(*found.check.moves, found.measure.unit))
                          : "How much it changes with its step was not measured."));
  }
}

void say_ablation_method(const SceneStudy& study, std::vector<std::string>& lines) {
  lines.emplace_back(
      "Each simplification is judged by the same scene without any: exact friction cone, projection, continuous "
      "detection, gyroscopic torque, six load cells. Ice that crushes does so by its growing contact area, between "
      "floes too, and is cut out. Ice that splits does so by its fracture toughness, along curved cracks.");
  const auto of_ice = [](const Omission& one) { return one.what == name_of(Simplification::uniform_ice); };
  if (std::none_of(study.absent.begin(), study.absent.end(), of_ice))
    lines.emplace_back(
        "Where the scene draws no properties of its ice, the flexural strength varies by 25 % with a correlation "
        "length of ten thicknesses. Strengths scatter by 20 to 30 % in nature; the length is a choice, not a "
        "measurement.");
  for (const auto& setting : study.plan.settings)
    if (setting.simplifications.size() == 1)
      lines.push_back(fmt::format("\"{}\": {}.", name_of(setting.simplifications.front()),
                                  meaning_of(setting.simplifications.front())));
  for (const auto& one : study.absent) lines.push_back(fmt::format("There is no row \"{}\": {}.", one.what, one.why));
  for (const Inexpressible& one : inexpressible_simplifications())
    lines.push_back(fmt::format("There is no row \"{}\" because Nilas makes this simplification itself: {}.", one.name,
                                one.reason));
}

std::string realisations_line(const SceneReport& report) {
  const Plan& plan = report.study.plan;
  if (plan.realisations == 1) return "Each setting has one realisation, the scene itself.";
  const std::string others =
      report.found.same_ice ? "perturbed starts up to 1e-12 m away. The seed does not change the ice of this scene, so "
                              "the result holds for this ice only"
      : plan.vary_seed      ? "other seeds and perturbed starts up to 1e-12 m away, the same ones for every setting"
                            : "perturbed starts up to 1e-12 m away";
  return fmt::format("Each setting has {} realisations: the scene itself, then {}.", plan.realisations, others);
}

void say_load_method(const SceneReport& report, std::vector<std::string>& lines) {
  const Findings& found = report.found;
  if (!found.measure.is_load()) return;
  std::string windows;
  for (std::size_t r = 0; r < found.windows.size(); ++r)
    if (const auto& span = found.windows[r])
      windows += fmt::format("{}{:g} s to {:g} s in realisation {}{}", windows.empty() ? "" : "; ", span->from,
                             span->to, r, span->reason.empty() ? "" : " (" + span->reason + ")");
  lines.push_back(
      fmt::format("The ice load is the force of the ice on the vessel along its course, positive astern ({}). "
                  "Its mean is over the same time in all runs of a realisation: {}.",
                  found.headline, windows));
  if (std::isnan(found.chance.run_N)) {
    lines.emplace_back("The effect of chance on mean loads was not measured, because no perturbed run is done.");
    return;
  }
  lines.push_back(fmt::format(
      "A run's mean load over {} scatters by {} (standard deviation) by chance. This comes from perturbed runs, which "
      "begin up to 1e-12 m away, and from the realisations. An error above Student's 95 % limit of it is significant.",
      found.same_ice ? "this ice" : "ice of this kind", quantity_text(found.chance.run_N, "N")));
  lines.emplace_back(
      "Within one realisation, chance is the larger of two: the difference of its perturbed run, and the scatter of "
      "the settings that solve the same law with the same steps at least as tightly; at Student's 95 % limit.");
}

void say_time_method(const SceneReport& report, std::vector<std::string>& lines) {
  const StudyTiming& timing = report.timing;
  lines.push_back(fmt::format(
      "Computing times are processor times of one process on a core of its own with one thread, without reading, "
      "packing ice and writing; the median over the realisations. {} run{} were made at a time. {}",
      timing.jobs, timing.jobs == 1 ? "" : "s",
      std::isfinite(timing.slowdown)
          ? fmt::format("The first {} steps of the first setting took {:.2f} times as long as alone on the machine.",
                        report.study.probe_steps, timing.slowdown)
          : "How much runs slow each other down was not measured."));
  if (std::isfinite(report.found.time_spread))
    lines.push_back(fmt::format("Times of runs of one setting scatter by {} (standard deviation).",
                                percent_text(report.found.time_spread)));
}

}  // namespace

std::vector<std::string> method_lines(const SceneReport& report) {
  const SceneStudy& study = report.study;
  const Findings& found = report.found;
  std::vector<std::string> lines;
  if (study.ablation)
    say_ablation_method(study, lines);
  else
    say_reference_method(report, lines);
  lines.push_back(realisations_line(report));
  say_load_method(report, lines);
  lines.push_back(!found.horizon.known
                      ? "How long motions can be predicted was not measured, because no perturbed run is done."
                  : found.horizon.ends
                      ? fmt::format("Motions are compared until {} s. Then two runs that begin 1e-12 m "
                                    "apart first differ by {}.",
                                    moment_text(found.horizon.until_s), quantity_text(found.horizon.threshold_m, "m"))
                      : "Motions are compared over the whole time, because the perturbed runs stay close to the runs.");
  say_time_method(report, lines);
  for (const auto& list : by_reason(study.plan.omissions)) lines.push_back("Left out for " + list + ".");
  for (const auto& refused : study.refused)
    lines.push_back(fmt::format("Cannot run: {}: {}", refused.what, refused.why));
  return lines;
}

const char* plain_name_of(RunKind kind) {
  switch (kind) {
    case RunKind::twin:
      return "perturbed run of the scene's own setting";
    case RunKind::reference:
      return "reference";
    case RunKind::check:
      return "reference at twice its step";
    case RunKind::grid:
      break;
  }
  return "setting";
}

}  // namespace nilas::compare
