#include "apps/compare/scenes/report/outlook.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "apps/compare/scenes/judge/floors.h"
#include "apps/compare/scenes/report/scene_report.h"
#include "apps/compare/workshop/json_store.h"
#include "core/output/text/console.h"

namespace nilas::compare {

namespace {

constexpr double k_time_reserve = 1.15;  // runs may take a little longer than others did

/// A wall time [s] as a budget: with a reserve, rounded up to two digits.
double budget_for(double seconds) { return rounded_budget(k_time_reserve * seconds + k_closing_s); }

int missing_runs(const Findings& found) {
  return static_cast<int>(std::count_if(found.rows.begin(), found.rows.end(),
                                        [](const RunRow& row) { return !row.result.done() && !row.result.failed(); }));
}

/// The least number of realisations, at least `from`, that makes differences of k_target significant.
std::optional<int> realisations_for_target(const Findings& found, int from) {
  constexpr int k_most = 1000;
  for (int n = from; n <= k_most; ++n)
    if (const auto least = smallest_difference(found, n); least && *least <= k_target * found.measure.scale) return n;
  return std::nullopt;
}

std::string share_text(double newton, const Findings& found) {
  return fmt::format("{} ({:.2g} %)", quantity_text(newton, "N"), 100 * newton / found.measure.scale);
}

}  // namespace

std::optional<double> smallest_difference(const Findings& found, int realisations) {
  const PooledVariance& chance = found.chance.variance;
  const auto now = static_cast<double>(found.shared.size());
  if (!found.measure.is_load() || !(chance.degrees > 0)) return std::nullopt;
  const double degrees = chance.by_settings ? chance.degrees * (realisations - 1) / (now - 1)
                                            : std::max(chance.degrees, static_cast<double>(realisations));
  const double reference = found.judges.one_run ? 0.5 * chance.value : 0;
  return floor_of(chance.value - reference, degrees, realisations, reference);
}

Outlook outlook(const SceneStudy& study, const Findings& found, const std::filesystem::path& folder, double left_s,
                double realisation_s) {
  Outlook view;
  const int planned = study.plan.realisations;
  if (!study.plan.omissions.empty() && study.budget_s > 0) view.whole_s = budget_for(study.plan.whole_s);
  if (study.plan.settings.size() < 2) return view;  // more runs would show nothing new
  MoreTime more;
  more.missing_runs = missing_runs(found);
  more.realisations = planned;
  more.seconds = left_s;
  std::string seeds;
  if (more.missing_runs == 0) {
    if (!found.measure.is_load() || !(found.common_floor > k_target * found.measure.scale)) return view;
    constexpr int k_least = 3, k_times = 2;
    more.realisations = std::max(k_least, k_times * planned);
    more.seconds = (more.realisations - planned) * realisation_s;
    seeds = fmt::format(" --seeds {}", more.realisations);
  }
  more.smallest_difference = smallest_difference(found, more.realisations);
  more.command =
      fmt::format("nilas compare --resume {}{} --budget {:g}", folder.string(), seeds, budget_for(more.seconds));
  if (more.smallest_difference && *more.smallest_difference > k_target * found.measure.scale) {
    view.for_target = realisations_for_target(found, more.realisations + 1);
    if (view.for_target) view.for_target_s = left_s + (*view.for_target - planned) * realisation_s;
  }
  view.next = more;
  return view;
}

/// A sentence about the differences that would then be significant.
static std::string gain_text(const MoreTime& more, const Findings& found) {
  const bool known = std::isfinite(found.common_floor) && found.measure.scale > 0;
  if (!found.measure.is_load() || (known && found.common_floor <= k_target * found.measure.scale)) return "";
  if (!more.smallest_difference)
    return " Which differences would then be significant is not known before a perturbed run is done.";
  return fmt::format(" Differences of the mean ice load above about {} would then be significant{}.",
                     share_text(*more.smallest_difference, found),
                     known && found.common_floor > *more.smallest_difference
                         ? ", now only those above " + share_text(found.common_floor, found)
                         : "");
}

std::vector<std::string> outlook_lines(const Outlook& view, const SceneStudy& study, const Findings& found) {
  std::vector<std::string> lines;
  if (view.next) {
    const MoreTime& more = *view.next;
    const std::string now = more.missing_runs > 0 ? "" : fmt::format(" instead of {}", study.plan.realisations);
    lines.push_back(fmt::format("With about {} more, all {} settings would have {} realisation{}{}.{}",
                                output::duration_text(more.seconds), study.plan.settings.size(), more.realisations,
                                more.realisations == 1 ? "" : "s", now, gain_text(more, found)));
    lines.emplace_back("To continue:");
    lines.push_back("  " + more.command);
  }
  if (view.for_target)
    lines.push_back(fmt::format("About {} realisations, {} more, would make differences of {:g} % significant.",
                                *view.for_target, output::duration_text(view.for_target_s), 100 * k_target));
  if (view.least_s > 0)
    lines.push_back(fmt::format("To compare two settings on a machine as busy as now, use about --budget {:g} ({}).",
                                view.least_s, output::duration_text(view.least_s)));
  if (view.whole_s > 0)
    lines.push_back(
        fmt::format("A new comparison that leaves nothing out of what was asked for needs about --budget {:g} ({}).",
                    view.whole_s, output::duration_text(view.whole_s)));
  return lines;
}

nlohmann::ordered_json outlook_json(const Outlook& view) {
  Json json = Json::object();
  json["next"] = nullptr;
  if (view.next)
    json["next"] = {{"missing_runs", view.next->missing_runs},
                    {"realisations", view.next->realisations},
                    {"seconds", view.next->seconds},
                    {"smallest_difference_N",
                     view.next->smallest_difference ? Json(*view.next->smallest_difference) : Json(nullptr)},
                    {"command", view.next->command}};
  json["realisations_for_2_percent"] = view.for_target ? Json(*view.for_target) : Json(nullptr);
  json["seconds_for_2_percent"] = view.for_target ? Json(view.for_target_s) : Json(nullptr);
  json["budget_for_one_difference_s"] = view.least_s > 0 ? Json(view.least_s) : Json(nullptr);
  json["budget_for_all_s"] = view.whole_s > 0 ? Json(view.whole_s) : Json(nullptr);
  return json;
}

}  // namespace nilas::compare
