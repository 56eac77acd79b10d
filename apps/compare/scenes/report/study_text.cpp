/// What a comparison says in words.
#include <fmt/format.h>

#include <algorithm>

#include "apps/compare/scenes/judge/ranking.h"
#include "apps/compare/scenes/report/paired_text.h"
#include "apps/compare/scenes/report/study_outputs.h"
#include "core/output/loads/ice_load_text.h"
#include "core/output/text/console.h"

namespace nilas {

namespace {

/// "6.1 times faster", "1.3 times slower", "as fast".
std::string speed_text(double ratio) {
  constexpr double k_alike = 1.05;
  if (ratio > k_alike) return fmt::format("{:.2g} times faster than", ratio);
  if (ratio < 1 / k_alike) return fmt::format("{:.2g} times slower than", 1 / ratio);
  return "about as fast as";
}

/// "+1.2 N +- 0.3 N, surely", and why not where it is not sure.
std::string change_text(const PairedDifference& d) {
  std::string text = force_text(d.mean);
  if (std::isfinite(d.half_width)) text += " +- " + force_text(d.half_width);
  switch (d.certainty) {
    case Certainty::everywhere:
      return text + ", surely (95 %)";
    case Certainty::in_realisations:
      return text + (d.realisations.size() == 1 ? ", more than chance does in the one realisation that was run"
                                                : fmt::format(", more than chance does in {} of {} realisations",
                                                              d.beyond_chance, d.realisations.size()));
    case Certainty::none:
      return text + ", as much as chaos alone can";
    case Certainty::unknown:
      break;
  }
  return text + "; what chaos alone does is not known";
}

std::string percent(double share) { return fmt::format("{:.3g} %", 100 * share); }

}  // namespace

std::string quantity_text(double value, const std::string& unit) {
  if (!std::isfinite(value)) return "not known";
  if (unit == "N") return force_text(value);
  const double size = std::abs(value);
  if (unit == "m" && size > 0 && size < 0.1)
    return size < 1e-4 ? fmt::format("{:.3g} um", 1e6 * value) : fmt::format("{:.3g} mm", 1e3 * value);
  return fmt::format("{:.3g} {}", value, unit);
}

StudyOutputs::StudyOutputs(const Study& study, const Findings& findings, const StudyTiming& timing,
                           const std::vector<std::string>& late, std::string trouble, std::string ended_by,
                           Outlook view)
    : study_(study),
      found_(findings),
      timing_(timing),
      late_(late),
      trouble_(std::move(trouble)),
      ended_by_(std::move(ended_by)),
      outlook_(std::move(view)) {}

std::string StudyOutputs::label(std::size_t setting) const {
  return label_of(study_.plan.settings[setting], study_.plan.settings.front());
}

std::vector<std::string> StudyOutputs::labels() const {
  std::vector<std::string> all;
  for (std::size_t k = 0; k < study_.plan.settings.size(); ++k) all.push_back(label(k));
  return all;
}

/// What the labels leave out.
std::string StudyOutputs::own_setting() const {
  if (study_.plan.settings.empty()) return "";
  return (study_.ablation ? "Without simplifications: " : "Own setting: ") + full_label(study_.plan.settings.front()) +
         (study_.ablation ? "." : "; the others are named by what they change.");
}

/// What the fastest good enough setting buys, and what can be told at all.
void StudyOutputs::say_price(std::vector<std::string>& lines) const {
  const Merit& own = found_.merits.front();
  if (own.done == 0) {
    lines.emplace_back("The scene's own setting is not done.");
    return;
  }
  const std::string of = found_.measure == "load"
                             ? fmt::format("the mean ice load ({} along the course)", force_text(found_.reference_load))
                         : found_.measure == "turn"
                             ? "the attitude (1 rad)"
                             : fmt::format("the longest path of a body ({})", quantity_text(found_.scale, "m"));
  if (found_.chosen) {
    const Merit& best = found_.merits[*found_.chosen];
    const bool same = best.setting == own.setting, hidden = !best.told && best.floor > k_target * found_.scale;
    const std::string own_name = full_label(study_.plan.settings.front());
    const std::string near =
        hidden ? fmt::format("As far as {} can be told,", of) : fmt::format("Within {} of {},", percent(k_target), of);
    if (same)
      lines.push_back(fmt::format("{} no setting is surely faster than the scene's own ({}){}.", near, own_name,
                                  found_.deeper ? " and lets bodies no deeper into each other" : ""));
    else
      lines.push_back(
          fmt::format("{} \"{}\" is {} the scene's own setting (\"{}\"): {:.3g} s of computing per "
                      "simulated second in place of {:.3g} s.",
                      near, label(best.setting), speed_text(own.time / best.time), own_name, best.time, own.time));
    say_peaks(best, lines);
    if (hidden)
      lines.push_back(fmt::format(
          "That is not far: {} of {:g} s tell{} differences above {} ({}) of means over {}, and no smaller ones. "
          "So much mean loads differ by chance.",
          best.realisations.size() == 1 ? "one realisation" : fmt::format("{} realisations", best.realisations.size()),
          study_.plan.end - study_.plan.start, best.realisations.size() == 1 ? "s" : "",
          quantity_text(best.floor, found_.unit), percent(best.floor / found_.scale), such_ice()));
  } else if (untouched()) {
    lines.push_back(
        fmt::format("The ice did not touch the vessel in the {:g} s that were simulated: nothing is "
                    "recommended, and motions are compared.",
                    study_.plan.end - study_.plan.start));
  } else if (!std::isfinite(found_.common_floor)) {
    lines.push_back("No setting is recommended: what chaos does is not known, for which a twin" +
                    std::string(found_.measure == "load" ? " or two realisations" : "") + " must be done.");
  } else {
    lines.push_back(fmt::format("No setting comes within {} of {}.", percent(k_target), of));
  }
  if (found_.deeper) {
    const Merit& deep = found_.merits[*found_.deeper];
    lines.push_back(fmt::format(
        "\"{}\" is as good and {} the scene's own, but lets bodies {} deep into each other (the scene's own {}).",
        label(deep.setting), speed_text(own.time / deep.time), quantity_text(deep.penetration_max_m, "m"),
        quantity_text(own.penetration_max_m, "m")));
  }
  const Merit* worst = nullptr;
  for (const auto& m : found_.merits)
    if (m.told && (worst == nullptr || m.error > worst->error)) worst = &m;
  if (worst != nullptr)
    lines.push_back(fmt::format("The largest error told is that of \"{}\": {} ({}).", label(worst->setting),
                                quantity_text(worst->error, found_.unit), percent(worst->error / found_.scale)));
  else if (std::isfinite(found_.common_floor))
    lines.push_back(fmt::format("No setting's error, over {}, can be told from chaos or rounding.", such_ice()));
  if (found_.measure != "load") return;
  for (const auto& line : difference_lines(found_, &Merit::from_reference, "the reference", labels()))
    lines.push_back(line);
  // where the own setting is as good as the reference, differences from it say the same once more
  const PairedDifference& off = own.from_reference;
  const bool as_good = off.certainty != Certainty::unknown && std::abs(off.mean) <= k_target * found_.scale;
  if (as_good || own.judges) return;
  for (const auto& line : difference_lines(found_, &Merit::from_own, "the scene's own setting", labels()))
    lines.push_back(line);
}

/// How long runs go the same way is one thing, how well means over other ice are known another.
void StudyOutputs::say_horizon(std::vector<std::string>& lines) const {
  if (!found_.horizon_ends) return;
  lines.push_back(fmt::format(
      "The motions of single bodies can be predicted until {:.3g} s of {:g} s: two runs that begin 1e-12 m apart are "
      "then {} apart.{}",
      found_.horizon_s, study_.plan.end, quantity_text(found_.horizon_threshold_m, "m"),
      found_.measure == "load" && found_.shared.size() > 1 ? " The chance in mean loads is another thing: it is told "
                                                             "from realisations, whose ice differs from the start."
                                                           : ""));
}

std::string StudyOutputs::such_ice() const { return found_.same_ice ? "this ice" : "all such ice"; }

bool StudyOutputs::untouched() const { return found_.measure != "load" && !found_.headline.empty(); }

/// Ships are built by the peaks of a load.
void StudyOutputs::say_peaks(const Merit& m, std::vector<std::string>& lines) const {
  if (found_.measure != "load") return;
  const auto beside = [](const Estimate& of, const Estimate& reference) {
    return fmt::format("{:+.2g} %", 100 * (of.mean / reference.mean - 1));
  };
  if (found_.reference_std.mean > 0 && found_.reference_p99.mean > 0)
    lines.push_back(
        fmt::format("Its standard deviation differs by {} from the reference's, the 99 % load by {}, the largest by "
                    "{}; these are not judged.",
                    beside(m.load_std, found_.reference_std), beside(m.load_p99, found_.reference_p99),
                    beside(m.load_max, found_.reference_max)));
}

/// What changes most comes first.
void StudyOutputs::say_ablation(std::vector<std::string>& lines) const {
  const Merit& full = found_.merits.front();
  if (untouched())
    lines.push_back(
        fmt::format("The ice did not touch the vessel in the {:g} s that were simulated: motions are "
                    "compared.",
                    study_.plan.end - study_.plan.start));
  std::vector<Merit> by_error = found_.merits;
  std::stable_sort(by_error.begin(), by_error.end(),
                   [](const Merit& a, const Merit& b) { return (a.told ? a.error : 0) > (b.told ? b.error : 0); });
  for (const auto& m : by_error) {
    if (m.setting == 0) continue;
    const std::string name = label(m.setting);
    if (m.done == 0 || std::isnan(m.error)) {
      lines.push_back(fmt::format("{}: no run ended ({}).", name, m.trouble));
      continue;
    }
    const double saved = full.time - m.time;
    std::string change;
    if (found_.measure == "load")
      change = m.load_difference.mean == 0
                   ? "does not change the mean ice load"
                   : fmt::format("changes the mean ice load by {}", change_text(m.from_reference));
    else
      change = m.told ? fmt::format("moves bodies by {} (rms) and turns them by {:.2g} rad",
                                    quantity_text(m.motion.mean, "m"), m.turn.mean)
                      : "does not change the motion by more than rounding or chaos";
    constexpr double k_sure = 3;
    const double scatter =
        std::isnan(found_.time_spread) ? 0 : k_sure * std::sqrt(2.0) * found_.time_spread * full.time;
    const std::string time =
        std::abs(saved) <= scatter
            ? "no difference in computing time can be told"
            : fmt::format("{} {:.3g} ms per simulated second ({:.3g} ms per step)", saved >= 0 ? "saves" : "costs",
                          1e3 * std::abs(saved), std::abs(full.ms_per_step - m.ms_per_step));
    lines.push_back(fmt::format("{}: {}; {}.", name, change, time));
  }
}

bool StudyOutputs::compared() const { return anything_told(found_); }

/// Why nothing could be judged.
std::string StudyOutputs::blocked() const {
  if (!trouble_.empty()) return trouble_;
  for (const auto& row : found_.rows)
    if (row.result.failed()) return row.run.id + ": " + row.result.status + ", " + row.result.cause;
  const bool any =
      std::any_of(found_.rows.begin(), found_.rows.end(), [](const auto& row) { return row.result.done(); });
  if (any && found_.horizon_ends && found_.horizon_s <= study_.plan.start)
    return "twins part before the first states that are stored";
  return ended_by_.empty() ? "the budget ended before" : ended_by_;
}

std::vector<std::string> StudyOutputs::sentences() const {
  std::vector<std::string> lines;
  if (!compared()) {
    lines.emplace_back("Nothing can be compared: " + blocked() + ".");
    return lines;
  }
  if (study_.ablation)
    say_ablation(lines);
  else
    say_price(lines);
  if (lines.empty()) lines.emplace_back("The budget left no simplification to run.");
  say_horizon(lines);
  if (found_.coverage)
    lines.push_back(fmt::format(
        "The load error estimate, with what the other runs tell, covers the measured error in {} of {} runs "
        "and is {:.2g} times as wide in the median; what each run says by itself covers {} and is {:.2g} "
        "times as wide.",
        percent(found_.coverage->share), found_.coverage->runs, found_.coverage->width,
        percent(found_.coverage_alone->share), found_.coverage_alone->width));
  for (const auto& order : found_.orders)
    lines.push_back(fmt::format(
        "Over {} steps the error of \"{}\" {}.", order.steps, order.rest,
        order.order > 0 ? fmt::format("falls with order {:.2f}", order.order) : "does not fall with the step"));
  return lines;
}

std::vector<std::string> StudyOutputs::warnings() const {
  std::vector<std::string> lines;
  if (!ended_by_.empty())
    lines.push_back("Not at its end (" + ended_by_ + "): what is shown is what was done until then; --resume goes on.");
  const auto partial =
      std::count_if(found_.merits.begin(), found_.merits.end(), [](const Merit& m) { return m.partial; });
  if (found_.shared.size() < static_cast<std::size_t>(study_.plan.realisations) && !found_.shared.empty())
    lines.push_back(
        fmt::format("Means are over {} alone, which the settings share; runs of others stand in compare.csv.",
                    realisations_text(found_.shared)));
  if (partial > 0)
    lines.push_back(fmt::format("{} setting{} (marked *) lack{} a run in {} {}, and {} not ranked.", partial,
                                partial == 1 ? "" : "s", partial == 1 ? "s" : "",
                                found_.shared.size() == 1 ? "the shared" : "one of the shared",
                                realisations_text(found_.shared), partial == 1 ? "is" : "are"));
  if (study_.plan.end < study_.plan.scene_end)
    lines.push_back(fmt::format("Only {:g} of {:g} s of the scene were simulated: the budget does not reach farther.",
                                study_.plan.end - study_.plan.start, study_.plan.scene_end - study_.plan.start));
  if (timing_.jobs > timing_.cores)
    lines.push_back(fmt::format("{} jobs on {} core{}: they wait for each other, and what that costs is not measured.",
                                timing_.jobs, timing_.cores, timing_.cores == 1 ? "" : "s"));
  if (!late_.empty())
    lines.push_back(
        fmt::format("The budget was used up before {} of {} runs were done.", late_.size(), study_.plan.runs.size()));
  if (!found_.stand_in.empty())
    lines.push_back(fmt::format(
        "No run of the reference is done ({}): settings are judged by {} in its place, whose own error is not known.",
        found_.reference_trouble.empty() ? "not run" : found_.reference_trouble, found_.stand_in));
  else if (!found_.reference_trouble.empty())
    lines.push_back(fmt::format("{} of {} realisations are judged: the others lack a run of the reference ({}).",
                                found_.references_done, study_.plan.realisations, found_.reference_trouble));
  if (found_.stand_in.empty() && !found_.reference_moves && !study_.ablation && study_.reference == "auto" &&
      !study_.event_driven)
    lines.emplace_back("How far the reference still moves with its step is not known: the run that tells is not done.");
  if (!found_.horizon_known) lines.emplace_back("How long motions can be predicted is not known: no twin is done.");
  if (found_.reference_coarse)
    lines.push_back(
        fmt::format("The reference itself moves by {} when its step is doubled, more than the smallest error shown: "
                    "small errors are not to be trusted.",
                    quantity_text(*found_.reference_moves, found_.unit)));
  double reference_short = 0;
  for (const auto& row : found_.rows) {
    if (row.run.kind != RunKind::reference || !row.result.done()) continue;
    reference_short =
        std::max(reference_short, row.result.number("/shortfalls/unconverged_steps") / row.result.number("/steps"));
  }
  if (reference_short > 0 && study_.reference == "auto")
    lines.push_back(fmt::format("The reference missed its tolerance of {:.0e} m/s in {} of its steps.",
                                study_.plan.reference.tolerance, percent(reference_short)));
  for (const auto& m : found_.merits)
    if (m.failed > 0)
      lines.push_back(
          fmt::format("\"{}\": {} of {} runs failed ({}).", label(m.setting), m.failed, m.planned, m.trouble));
  if (timing_.slowdown > 1 + std::max(0.1, 2 * found_.time_spread))
    lines.push_back(
        fmt::format("Runs beside each other took {:.2f} times as long as alone: all times here are larger by about "
                    "that, alike for all settings.",
                    timing_.slowdown));
  return lines;
}

std::string StudyOutputs::text() const {
  std::string text;
  for (const auto& lines : {sentences(), warnings(), outlook_lines(outlook_, study_, found_)})
    for (const auto& line : lines) text += line + "\n";
  if (timing_.jobs > 1 && timing_.jobs <= timing_.cores && std::isfinite(timing_.busy))
    text += std::isfinite(timing_.slowdown)
                ? fmt::format(
                      "{} jobs: {:.2f} at work on average, each {:.2f} times as slow as alone: parallel "
                      "efficiency {:.2f}\n",
                      timing_.jobs, timing_.busy, timing_.slowdown, timing_.efficiency())
                : fmt::format(
                      "{} jobs: {:.2f} at work on average: parallel efficiency at most {:.2f} (runs are too "
                      "short to tell what neighbours cost)\n",
                      timing_.jobs, timing_.busy, timing_.busy / timing_.jobs);
  if (std::isfinite(found_.time_spread))
    text += fmt::format("times of alike runs scatter by {} (standard deviation)\n", percent(found_.time_spread));
  if (!text.empty()) text.pop_back();
  return text;
}

}  // namespace nilas
