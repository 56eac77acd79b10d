#include "apps/report/page/numerics_sections.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>

#include "apps/report/figures/thin.h"
#include "apps/report/page/words.h"
#include "core/base/statistics.h"
#include "core/output/loads/step_load.h"
#include "core/sim/account/step_record.h"

namespace nilas::report {

namespace {

constexpr double k_hundred = 100;

/// Thinned by a maximum, so that no bad step is lost.
Curve largest_over(const std::string& name, const RunTable& table, const std::string& column) {
  Curve curve = thinned(name, table.time(), table[column]);
  if (curve.high.empty()) return curve;
  curve.y = curve.high;
  curve.low.clear();
  curve.high.clear();
  return curve;
}

/// Zeros have no logarithm: they leave gaps.
void drop_zeros(Curve& curve) {
  for (double& y : curve.y)
    if (!(y > 0)) y = std::nan("");
}

Plot steps_plot(const RunFindings& found, const char* id, const char* title, const char* label,
                std::initializer_list<std::pair<const char*, const char*>> columns) {
  Plot plot{.id = id, .title = title, .x_label = "time [s]", .y_label = label, .over_time = true};
  for (const auto& [name, column] : columns)
    if (found.run.steps.has(column)) plot.curves.push_back(largest_over(name, found.run.steps, column));
  return plot;
}

std::string spaced(std::string name) {
  std::replace(name.begin(), name.end(), '_', ' ');
  return name;
}

/// How many steps ended with each status of the solver.
PageTable status_table(const RunTable& steps) {
  std::map<std::string, long> counts;
  for (const std::string& status : steps.texts("status")) ++counts[status];
  PageTable table{.head = {"status of the solver", "steps", "share"}};
  for (const auto& [status, count] : counts)
    table.rows.push_back(
        {spaced(status), std::to_string(count),
         fmt::format("{:.3g} %", k_hundred * static_cast<double>(count) / static_cast<double>(steps.rows()))});
  return table;
}

PageTable worst_table(const nlohmann::ordered_json& worst) {
  PageTable table{.head = {"worst value of the run", "value", "at"}};
  for (const auto& [name, entry] : worst.items())
    if (entry.contains("value") && entry.at("value").is_number())
      table.rows.push_back({name, fmt::format("{:.3g}", entry.at("value").get<double>()),
                            fmt::format("{:.5g} s", entry.at("time_s").get<double>())});
  return table;
}

bool is_energy(const std::string& column) { return column.ends_with("_J"); }

/// A time of the summary for each step [ms]; 0 where it is not known.
double per_step(const RunData& run, const char* key) {
  if (!run.summary.contains(key) || !run.summary.at(key).is_number() || run.steps.rows() == 0) return 0;
  constexpr double k_ms = 1e3;
  return k_ms * run.summary.at(key).get<double>() / static_cast<double>(run.steps.rows());
}

Section without_steps(Section section) {
  section.gaps.emplace_back("The table steps.csv is missing or empty, so this is not shown.");
  return section;
}

}  // namespace

Section breaks_section(const RunFindings& found) {
  Section section{.id = "breaks", .title = "Breaks over time"};
  const RunTable& events = found.run.events;
  if (!events.has("kind")) {
    section.text.emplace_back("No ice of this scene can break, or its table of breaks is not there.");
    return section;
  }
  if (events.rows() == 0) {
    section.text.emplace_back("The ice can break, and did not.");
    return section;
  }
  const auto kinds = events.texts("kind");
  std::map<std::string, Curve> curves;
  for (std::size_t k = 0; k < kinds.size(); ++k) {
    Curve& curve = curves[kinds[k]];
    if (curve.x.empty()) curve = {.name = kinds[k], .x = {found.run.start()}, .y = {0}, .is_steps = true};
    const double count = curve.y.back() + 1;
    if (curve.x.back() < events.time()[k]) {
      curve.x.push_back(events.time()[k]);
      curve.y.push_back(count);
    } else {
      curve.y.back() = count;  // several floes broke in this step
    }
  }
  Plot plot{.id = "breaks",
            .title = "Number of floes that broke so far",
            .x_label = "time [s]",
            .y_label = "floes",
            .over_time = true};
  PageTable table{.head = {"kind of break", "floes", "energy", "length of cracks"}};
  for (auto& [kind, curve] : curves) {
    double energy = 0, length = 0;
    for (std::size_t k = 0; k < kinds.size(); ++k)
      if (kinds[k] == kind) {
        energy += events["energy_J"][k];
        length += events["length_m"][k];
      }
    table.rows.push_back({kind, fmt::format("{:.0f}", curve.y.back()), fmt::format("{:.3g} J", energy),
                          fmt::format("{:.3g} m", length)});
    curve.x.push_back(found.run.times().back());
    curve.y.push_back(curve.y.back());
    Curve thin = thinned(kind, curve.x, curve.y);
    if (!thin.high.empty()) thin.y = thin.high;  // counts rise, so the last of a stretch is its largest
    thin.low.clear();
    thin.high.clear();
    thin.is_steps = true;
    plot.curves.push_back(std::move(thin));
  }
  section.text.push_back(fmt::format("{} breaks, each at the end of its step.", events.rows()));
  section.plots.push_back(std::move(plot));
  section.tables.push_back(std::move(table));
  return section;
}

Section energy_section(const RunFindings& found) {
  Section section{.id = "energy", .title = "Energy ledger"};
  const RunTable& steps = found.run.steps;
  if (steps.rows() == 0 || !steps.has("imbalance_J")) return without_steps(std::move(section));
  Plot plot{.id = "energy",
            .title = "Works and losses since the start, and energies",
            .x_label = "time [s]",
            .y_label = "energy [J]",
            .over_time = true};
  PageTable table{.head = {"entry", "at the end"}};
  const auto& potential = steps["potential_J"];
  for (const std::string& column : steps.names()) {
    if (!is_energy(column) || column == "complementarity_J" || column == "bipotential_J") continue;
    std::vector<double> values = steps[column];
    // Only changes of the potential energy matter, and its level depends on the origin.
    if (column == "potential_J")
      for (double& value : values) value -= potential.front();
    const bool is_zero = std::all_of(values.begin(), values.end(), [](double value) { return value == 0; });
    if (is_zero) continue;
    const std::string name = spaced(column.substr(0, column.size() - 2)) + (column == "potential_J" ? " (change)" : "");
    table.rows.push_back({name, fmt::format("{:.4g} J", values.back())});
    plot.curves.push_back(thinned(name, steps.time(), values));
  }
  section.text.emplace_back(
      "Losses are positive when energy leaves the bodies. The imbalance is what the entries do not explain; it should "
      "be rounding.");
  const auto& worst = found.run.summary.contains("worst") ? found.run.summary.at("worst") : found.run.summary;
  if (worst.is_object() && worst.contains("imbalance_J") &&
      worst.at("imbalance_J").contains("relative_to_energy_put_in"))
    section.text.push_back(fmt::format("The largest imbalance is {:.2g} of the energy put in.",
                                       worst.at("imbalance_J").at("relative_to_energy_put_in").get<double>()));
  section.plots.push_back(std::move(plot));
  section.tables.push_back(std::move(table));
  return section;
}

Section solver_section(const RunFindings& found) {
  Section section{.id = "solver", .title = "Solver health"};
  const RunTable& steps = found.run.steps;
  if (steps.rows() == 0) return without_steps(std::move(section));
  Plot residual =
      steps_plot(found, "residual", "Residual of each step", "residual [m/s]",
                 {{"of the contact law asked for", "law_map_m_s"}, {"of exact Coulomb friction", "natural_map_m_s"}});
  residual.log_y = true;
  for (Curve& curve : residual.curves) drop_zeros(curve);
  if (found.run.scene) residual.levels.push_back({"tolerance", found.run.scene->contact.tolerance, 0});
  section.plots.push_back(std::move(residual));
  section.plots.push_back(
      steps_plot(found, "iterations", "Iterations of the solver", "iterations", {{"iterations", "iterations"}}));
  section.plots.push_back(steps_plot(found, "contacts", "Size of the problem", "number",
                                     {{"contact points", "contacts"}, {"floes", "floes"}, {"islands", "islands"}}));
  section.text.emplace_back(
      "Where a graph has fewer points than the run has steps, each point is the worst of its steps.");
  if (found.run.summary.contains("shortfalls")) {
    const long count = found.run.summary.at("shortfalls").value("unconverged_steps", 0L);
    section.text.push_back(
        count == 0 ? "Every step was solved to the tolerance of the scene."
                   : fmt::format("In {} of {} steps the solver ended above its tolerance.", count, steps.rows()));
  }
  if (std::string text = output::step_load_text(output::step_load_error_of(found.run.summary)); !text.empty())
    section.text.push_back(std::move(text));
  if (steps.has("status")) section.tables.push_back(status_table(steps));
  if (found.run.summary.contains("worst")) section.tables.push_back(worst_table(found.run.summary.at("worst")));
  return section;
}

Section time_section(const RunFindings& found) {
  Section section{.id = "time", .title = "Where the time went"};
  const RunTable& steps = found.run.steps;
  if (steps.rows() == 0) return without_steps(std::move(section));
  Plot plot{.id = "step-time",
            .title = "Wall time of each step by phase",
            .x_label = "time [s]",
            .y_label = "wall time [ms]",
            .over_time = true};
  PageTable table{.head = {"phase", "ms per step", "share"}};
  double all = 0;
  std::vector<std::pair<std::string, double>> means;
  for (int p = 0; p < sim::k_num_phases; ++p) {
    const std::string name = sim::to_string(static_cast<sim::Phase>(p)), column = "ms_" + name;
    if (!steps.has(column)) continue;
    const double mean = mean_of(steps[column]);
    if (!(mean > 0)) continue;
    means.emplace_back(name, mean);
    all += mean;
    plot.curves.push_back(thinned(name, steps.time(), steps[column]));
  }
  // What the steps do not explain is the time outside of them: building the scene, drawing progress.
  const double resuming = per_step(found.run, "resuming_s");
  const double whole = std::max(per_step(found.run, "wall_s"), all + resuming), other = whole - all - resuming;
  if (resuming > 0) means.emplace_back("resuming", resuming);
  if (other > 0) means.emplace_back("other", other);
  for (const auto& [name, mean] : means)
    table.rows.push_back({name, number_text(mean), fmt::format("{:.1f} %", k_hundred * mean / whole)});
  table.rows.push_back({"all", number_text(whole), "100 %"});
  if (found.run.summary.contains("wall_s"))
    section.text.push_back(
        fmt::format("The run took {:.4g} s of wall time and {:.4g} s of processor time for {} steps.",
                    found.run.summary.at("wall_s").get<double>(), found.run.summary.value("processor_s", std::nan("")),
                    steps.rows()));
  if (resuming > 0)
    section.text.emplace_back("Resuming is the time in which later sessions of the run built the scene again.");
  if (other > 0)
    section.text.emplace_back("Other is the time outside of the steps, such as that for building the scene.");
  if (found.run.summary.contains("slowdown")) section.text.push_back(found.run.summary.at("slowdown"));
  section.plots.push_back(std::move(plot));
  section.tables.push_back(std::move(table));
  return section;
}

}  // namespace nilas::report
