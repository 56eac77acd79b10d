#include "core/output/closing_account.h"

#include <fmt/format.h>

#include <numeric>

#include "core/output/console.h"

namespace nilas {

namespace {

constexpr double k_percent = 100, k_ms_per_s = 1000;

std::string phase_line(const std::string& name, double ms, long steps, double total_ms) {
  return fmt::format("  {:<14}{:>12.4f}{:>9.1f}\n", name, steps > 0 ? ms / static_cast<double>(steps) : 0,
                     total_ms > 0 ? k_percent * ms / total_ms : 0);
}

/// `other` is what no step accounts for: building the scene, drawing progress.
std::string phase_table(const RunStatistics& statistics, double wall_s) {
  const auto& ms = statistics.total_ms();
  const double in_steps = std::accumulate(ms.begin(), ms.end(), 0.0), total = std::max(wall_s * k_ms_per_s, in_steps);
  std::string text = fmt::format("  {:<14}{:>12}{:>9}\n", "phase", "ms per step", "percent");
  for (std::size_t p = 0; p < ms.size(); ++p)
    if (ms[p] > 0) text += phase_line(to_string(static_cast<Phase>(p)), ms[p], statistics.steps(), total);
  text += phase_line("other", total - in_steps, statistics.steps(), total);
  return text + phase_line("all", total, statistics.steps(), total);
}

std::string worst_line(const char* label, const RunStatistics& statistics, const char* column, const char* unit) {
  const Worst& worst = statistics.worst(column);
  return fmt::format("{:<22}{:.3g} {} at {:g} s\n", label, worst.value, unit, worst.time);
}

/// One line for each thing that fell short, none in a healthy run.
std::string shortfall_lines(const Shortfalls& shortfalls, long steps) {
  std::string text;
  const auto line = [&](long count, const char* label, const std::string& rest) {
    if (count > 0) text += fmt::format("{:<22}{} {}\n", label, count, rest);
  };
  line(shortfalls.unconverged_steps, "solver short", fmt::format("of {} steps above its tolerance", steps));
  line(shortfalls.uncorrected_steps, "correction short", fmt::format("of {} steps above its tolerance", steps));
  line(shortfalls.detection_fallbacks, "collision library", "queries without a usable answer; other axes decided");
  return text;
}

std::string load_lines(const LoadError& error) {
  const ChannelError& load = error.channels[error.headline];
  const bool towed = load.channel.starts_with("carriage");
  const char axis = load.channel[load.channel.find("_f") + 2];
  const std::string chaos = load.chaos ? fmt::format("chaos {:.2g} N; step", *load.chaos) : "N; chaos, step";
  return fmt::format("{:<22}{:.4g} N +- {:.2g} N{}\n", fmt::format("{} {}", towed ? "tow force" : "ice load", axis),
                     load.mean, load.total, error.from_twins ? ", mean over twins" : "") +
         fmt::format("{:<22}solver {:.2g}, law {:.2g}{} {} unknown\n", "  of that", load.solver, load.law,
                     load.chaos ? "," : "", chaos);
}

std::string twin_lines(const TwinStatistics& twins) {
  std::string text =
      fmt::format("{:<22}{}, {}", "twins", twins.count,
                  twins.horizon ? fmt::format("predictable until {:g} s", *twins.horizon) : "predictable to the end");
  if (twins.e_folding) text += fmt::format(", apart e-fold in {:.2g} s", *twins.e_folding);
  text += "\n";
  for (const FailedTwin& f : twins.failed) text += fmt::format("{:<22}{} failed at {:g} s\n", "twin", f.twin, f.time);
  return text;
}

}  // namespace

std::string closing_account(const RunStatistics& statistics, double wall_s, const std::filesystem::path& outputs,
                            const std::optional<BrokenIce>& ice, const TwinStatistics* twins) {
  const double simulated = statistics.end_time() - statistics.start_time();
  std::string text = fmt::format("{:<22}{:g} s in {} steps\n", "simulated", simulated, statistics.steps());
  text += fmt::format("{:<22}{}, {:.3g} x real time\n", "wall-clock", duration_text(wall_s),
                      wall_s > 0 ? simulated / wall_s : 0);
  text += phase_table(statistics, wall_s);
  text += worst_line("worst law residual", statistics, "law_map_m_s", "m/s");
  text += worst_line("worst penetration", statistics, "penetration_max_m", "m");
  const Worst& imbalance = statistics.worst("imbalance_J");
  text += fmt::format("{:<22}{:.3g} J at {:g} s, {:.2g} of the energy put in\n", "worst energy error", imbalance.value,
                      imbalance.time, statistics.relative_imbalance());
  if (const auto error = statistics.load_error(twins)) text += load_lines(*error);
  if (twins != nullptr) text += twin_lines(*twins);
  if (ice)
    text += fmt::format("{:<22}{} at the start, {} at the end\n{:<22}{:.3g} kg crushed, {:.3g} kg brash\n", "floes",
                        ice->floes, ice->floes_end, "ice lost", ice->crushed_mass, ice->brash_mass);
  if (ice && ice->extruded_mass > 0)
    text += fmt::format("{:<22}{:.3g} kg of the crushed ice\n", "cut out", ice->extruded_mass);
  text += shortfall_lines(statistics.shortfalls(), statistics.steps());
  return text + fmt::format("{:<22}{}\n", "outputs", outputs.string());
}

}  // namespace nilas
