#include "core/output/run/closing_account.h"

#include <fmt/format.h>

#include <numeric>

#include "core/output/loads/ice_load_text.h"
#include "core/output/text/console.h"

namespace nilas::output {

namespace {

constexpr double k_percent = 100, k_ms_per_s = 1000;

std::string phase_line(const std::string& name, double ms, long steps, double total_ms) {
  return fmt::format("  {:<14}{:>12.4f}{:>9.1f}\n", name, steps > 0 ? ms / static_cast<double>(steps) : 0,
                     total_ms > 0 ? k_percent * ms / total_ms : 0);
}

/// Processor time, and whether the run had to wait for it. On a free machine at least one thread computes at any time,
/// whatever the number of threads, so the processor time is then at least the wall-clock time.
std::string processor_lines(const RunEnding& ending) {
  constexpr double k_busy_from = 1.5, k_shortest_told_s = 2;  // shorter runs mostly read files
  std::string text = fmt::format("{:<22}{}, {:.3g} x wall-clock\n", "processor time", duration_text(ending.processor_s),
                                 ending.wall_s > 0 ? ending.processor_s / ending.wall_s : 0);
  if (ending.wall_s > k_shortest_told_s && ending.wall_s > k_busy_from * ending.processor_s)
    text += account_line("  busy machine", fmt::format("Other work on this machine, or a slow disk, made the run wait. "
                                                       "Without the waiting it takes about {} at most.",
                                                       duration_text(ending.processor_s)));
  return text;
}

/// Wall time per phase. `resuming` is that in which later sessions built the scene again, and `other` the rest outside
/// of the steps: building the scene, drawing progress.
std::string phase_table(const RunStatistics& statistics, const RunEnding& ending) {
  const auto& ms = statistics.total_ms();
  const double in_steps = std::accumulate(ms.begin(), ms.end(), 0.0), resuming = ending.resuming_s * k_ms_per_s;
  const double total = std::max(ending.wall_s * k_ms_per_s, in_steps + resuming);
  std::string text = fmt::format("  {:<14}{:>12}{:>9}\n", "phase", "ms per step", "percent");
  for (std::size_t p = 0; p < ms.size(); ++p)
    if (ms[p] > 0) text += phase_line(sim::to_string(static_cast<sim::Phase>(p)), ms[p], statistics.steps(), total);
  if (resuming > 0) text += phase_line("resuming", resuming, statistics.steps(), total);
  text += phase_line("other", total - in_steps - resuming, statistics.steps(), total);
  return text + phase_line("all", total, statistics.steps(), total);
}

std::string worst_line(const char* label, const RunStatistics& statistics, const char* column, const char* unit) {
  const Worst& worst = statistics.worst(column);
  return fmt::format("{:<22}{:.3g} {} at {:g} s\n", label, worst.value, unit, worst.time);
}

/// The shares of the methods that settled pairs of convex pieces; empty where no pair came near.
std::string detection_lines(const detect::DetectorCounts& counts) {
  if (counts.candidate_pairs == 0) return {};
  const long kept = counts.cached_separations + counts.kept_axes;
  const long others =
      counts.candidate_pairs - kept - counts.by_fcl - counts.corrected;  // includes pairs of crushing ice
  const auto share = [&](long count) {
    return k_percent * static_cast<double>(count) / static_cast<double>(counts.candidate_pairs);
  };
  return fmt::format(
      "{:<22}{} in all: {:.3g} % by a stored axis, {:.3g} % by FCL,\n{:<22}{:.3g} % corrected after FCL, {:.3g} % by "
      "other searches\n",
      "pairs of pieces", counts.candidate_pairs, share(kept), share(counts.by_fcl), "", share(counts.corrected),
      share(others));
}

/// One line for each method that missed its goal; empty in a healthy run.
std::string shortfall_lines(const Shortfalls& shortfalls, const detect::DetectorCounts& detection, long steps) {
  std::string text;
  const auto of_the_run = [&](long count, const char* label, const char* rest) {
    if (count == 0) return;
    const std::string share = percent_text(static_cast<double>(count) / static_cast<double>(steps));
    text += account_line(label, fmt::format("{} of {} steps of the whole run ({}) {}", count, steps, share, rest));
  };
  of_the_run(shortfalls.unconverged_steps, "solver not converged", "above the scene's tolerance");
  of_the_run(shortfalls.uncorrected_steps, "position correction", "above its tolerance");
  if (detection.fallbacks > 0)
    text += account_line("collision library",
                         fmt::format("{} queries without a usable answer; the exact search decided them, so no action "
                                     "is needed",
                                     detection.fallbacks));
  return text;
}

/// Penetration of rigid contacts and, where ice crushes, of crushed ice inside the hull.
std::string penetration_lines(const RunStatistics& statistics, bool crushes) {
  if (!crushes) return worst_line("worst penetration", statistics, "penetration_max_m", "m");
  const Worst &rigid = statistics.worst("penetration_max_m"), &crushed = statistics.worst("crushed_overlap_max_m");
  return fmt::format("{:<22}{:.3g} m of rigid contacts at {:g} s\n{:<22}{:.3g} m inside the hull at {:g} s\n",
                     "worst penetration", rigid.value, rigid.time, "crushed ice, at most", crushed.value, crushed.time);
}

/// The first structures, those that ice touched before the others. All are in the summary.
std::vector<StructureLoad> told_structures(const RunStatistics& statistics) {
  constexpr std::size_t k_most = 8;
  std::vector<StructureLoad> told = statistics.structure_loads();
  std::stable_partition(told.begin(), told.end(), [](const StructureLoad& s) { return s.ice.touched; });
  if (told.size() > k_most) told.erase(told.begin() + k_most, told.end());
  return told;
}

std::string twin_lines(const TwinStatistics& twins) {
  std::string text =
      fmt::format("{:<22}{}, {}", "perturbed runs", twins.count,
                  twins.horizon ? fmt::format("predictable until {:g} s", *twins.horizon) : "predictable to the end");
  if (twins.e_folding) text += fmt::format(", e-folding time {:.2g} s", *twins.e_folding);
  text += "\n";
  for (const FailedTwin& f : twins.failed)
    text += fmt::format("{:<22}{} failed at {:g} s\n", "perturbed run", f.twin, f.time);
  return text;
}

}  // namespace

std::string closing_account(const RunStatistics& statistics, const RunEnding& ending,
                            const std::filesystem::path& outputs, const std::optional<BrokenIce>& ice,
                            const TwinStatistics* twins, const std::optional<IceLoad>& ice_load) {
  const double simulated = statistics.end_time() - statistics.start_time(), wall_s = ending.wall_s;
  std::string text;
  if (!ending.interrupted.empty()) text += account_line("interrupted", ending.interrupted);
  text += fmt::format("{:<22}{:g} s in {} steps\n", "simulated", simulated, statistics.steps());
  text += fmt::format("{:<22}{}, {:.3g} x real time\n", "wall-clock", duration_text(wall_s),
                      wall_s > 0 ? simulated / wall_s : 0);
  text += processor_lines(ending);
  text += phase_table(statistics, ending);
  text += detection_lines(statistics.detection());
  text += worst_line("worst law residual", statistics, "law_map_m_s", "m/s");
  text += penetration_lines(statistics, ice.has_value() && ice->crushes);
  const Worst& imbalance = statistics.worst("imbalance_J");
  text += fmt::format("{:<22}{:.3g} J at {:g} s, {:.2g} of the energy put in\n", "worst energy error", imbalance.value,
                      imbalance.time, statistics.relative_imbalance());
  text += reaction_lines(statistics.reactions());
  if (ice_load) text += ice_load_lines(*ice_load, statistics.load_error(twins).value());
  for (const StructureLoad& structure : told_structures(statistics)) text += structure_lines(structure);
  text += step_load_lines(statistics.step_load_error());
  for (const auto& [module, figures] : ending.figures)
    for (const bodies::RunFigure& figure : figures)
      if (!figure.label.empty()) text += account_line(figure.label, figure.text);
  if (twins != nullptr) text += twin_lines(*twins);
  if (ice)
    text += fmt::format("{:<22}{} at the start, {} at the end\n{:<22}{:.3g} kg crushed, {:.3g} kg brash\n", "floes",
                        ice->floes, ice->floes_end, "ice lost", ice->crushed_mass, ice->brash_mass);
  if (ice && ice->extruded_mass > 0)
    text += fmt::format("{:<22}{:.3g} kg of the crushed ice\n", "cut out", ice->extruded_mass);
  text += shortfall_lines(statistics.shortfalls(), statistics.detection(), statistics.steps());
  if (const std::string slower = statistics.slowdown(); !slower.empty()) text += account_line("slower", slower);
  return text + fmt::format("{:<22}{}\n", "outputs", outputs.string());
}

}  // namespace nilas::output
