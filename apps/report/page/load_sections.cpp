#include "apps/report/page/load_sections.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "apps/report/figures/exceedance.h"
#include "apps/report/figures/spectrum.h"
#include "apps/report/figures/thin.h"
#include "apps/report/page/mooring_plot.h"
#include "apps/report/page/words.h"

namespace nilas::report {

namespace {

/// The unit that suits the largest value of a series.
output::ForceUnit unit_of(const std::vector<double>& series) {
  double size = 0;
  for (const double value : series)
    if (std::isfinite(value)) size = std::max(size, std::abs(value));
  return output::force_unit(size);
}

const std::vector<double>& across_series(const RunFindings& found) {
  return found.load->is_vessel() ? found.run.vessel["ice_side_N"]
                                 : found.run.structures[found.load->name + "_ice_side_N"];
}

Plot load_plot(const RunFindings& found, const char* id, const std::string& title, const std::vector<double>& series,
               const output::ComponentLoad& load) {
  const output::ForceUnit unit = unit_of(series);
  Plot plot{.id = id,
            .title = title,
            .x_label = "time [s]",
            .y_label = fmt::format("load [{}]", unit.name),
            .over_time = true};
  plot.curves.push_back(thinned("load", found.run.times(), series, 1 / unit.size));
  const std::string name = load.half_width ? "mean and its error" : "mean";
  if (found.load->touched)
    plot.levels.push_back({name, load.statistics.mean / unit.size, load.half_width.value_or(0) / unit.size});
  return plot;
}

/// The horizontal forces of a group of columns of vessel.csv, such as `mooring_fx_N` and `mooring_fy_N`.
std::optional<Plot> group_plot(const RunTable& table, const std::string& group, const std::string& who) {
  const std::string x = group + "_fx_N", y = group + "_fy_N";
  if (!table.has(x) || !table.has(y)) return std::nullopt;
  const output::ForceUnit unit =
      unit_of(table[x]).size > unit_of(table[y]).size ? unit_of(table[x]) : unit_of(table[y]);
  Plot plot{.id = "force-" + group,
            .title = "Force of " + who + " on the vessel",
            .x_label = "time [s]",
            .y_label = fmt::format("force [{}]", unit.name),
            .over_time = true};
  plot.curves.push_back(thinned("along x", table.time(), table[x], 1 / unit.size));
  plot.curves.push_back(thinned("along y", table.time(), table[y], 1 / unit.size));
  return plot;
}

/// The time from which the ramp at the start has died away [s].
double settled_from(const RunFindings& found) {
  constexpr double k_share = 0.25;
  const double start = found.run.start(), end = found.run.times().back();
  return std::max(found.load->window.from, start + k_share * (end - start));
}

/// Gives a plot the range of its values after `from`, where those before would make these flat. Returns a sentence on
/// what is beyond it; empty where nothing is.
std::string show_after(double from, Plot& plot) {
  constexpr double k_much = 2, k_margin = 0.08, k_infinity = std::numeric_limits<double>::infinity();
  std::array<double, 2> all{k_infinity, -k_infinity}, late = all;
  const auto take = [](std::array<double, 2>& range, double low, double high) {
    range = {std::min(range[0], low), std::max(range[1], high)};  // a gap is NaN and changes nothing
  };
  for (const Curve& curve : plot.curves)
    for (std::size_t k = 0; k < curve.x.size(); ++k) {
      const double low = curve.low.empty() ? curve.y[k] : curve.low[k];
      const double high = curve.high.empty() ? curve.y[k] : curve.high[k];
      take(all, low, high);
      if (curve.x[k] > from) take(late, low, high);
    }
  const double height = late[1] - late[0];
  if (!(height > 0) || all[1] - all[0] < k_much * height) return "";
  plot.y_range = {late[0] - k_margin * height, late[1] + k_margin * height};
  return fmt::format(
      "The graph \"{}\" is scaled to the time after {:.4g} s. Before, values reach from {:.4g} to {:.4g}; enlarge that "
      "time to see them.",
      plot.title, from, all[0], all[1]);
}

Plot motion_plot(const RunTable& vessel) {
  Plot plot{.id = "motion",
            .title = "Way of the centre of mass since the start",
            .x_label = "time [s]",
            .y_label = "way [m]",
            .over_time = true};
  for (const char* axis : {"x", "y", "z"}) {
    std::vector<double> way = vessel[std::string(axis) + "_m"];
    const double first = way.empty() ? 0 : way.front();
    for (double& value : way) value -= first;
    plot.curves.push_back(thinned(std::string("along ") + axis, vessel.time(), way));
  }
  return plot;
}

std::vector<std::string> component_row(const std::string& name, const output::ComponentLoad& load, bool at_least) {
  const output::Peak& peak = load.peak;
  return {name,
          mean_with_error(load.statistics.mean, load.half_width, at_least),
          output::force_text(load.statistics.std),
          output::force_text(load.statistics.p99),
          fmt::format("{} at {:.5g} s", output::force_text(peak.filtered), peak.filtered_time),
          fmt::format("{} at {:.5g} s", output::force_text(peak.raw), peak.raw_time)};
}

PageTable load_table(const RunFindings& found) {
  PageTable table;
  table.head = {
      "load", "mean", "standard deviation", "99 % of steps below, by size", "largest filtered", "largest of one step"};
  table.caption = fmt::format("Filtered values are means over {:.2g} s. The window is {:.5g} to {:.5g} s: {}.",
                              found.load->along.peak.filter, found.load->window.from, found.load->window.to,
                              found.load->window.reason);
  for (const BodyLoad& load : found.loads) {
    const std::string who = load.is_vessel() ? "" : load.name + ", ";
    const char* along = load.is_vessel() ? "along the course, positive astern" : "along the drift";
    const char* across = load.is_vessel() ? "across the course, positive to port" : "across the drift";
    table.rows.push_back(component_row(who + along, load.along, load.error_at_least));
    table.rows.push_back(component_row(who + across, load.across, load.error_at_least));
  }
  return table;
}

/// The statistics of all load channels, from the summary.
PageTable channel_table(const nlohmann::ordered_json& loads) {
  PageTable table;
  table.head = {
      "channel", "mean", "standard deviation", "99 % of steps below", "largest filtered", "largest of one step"};
  table.caption = "Columns of vessel.csv over the same window, in N and N m. Absolute values but for the mean.";
  for (const auto& [name, load] : loads.items()) {
    std::vector<std::string> row{name};
    for (const char* key : {"mean", "std", "p99", "max_filtered", "max"})
      row.push_back(load.contains(key) ? number_text(load.at(key).get<double>()) : "");
    table.rows.push_back(std::move(row));
  }
  return table;
}

Plot exceedance_plot(const RunFindings& found) {
  const BodyLoad& load = *found.load;
  const std::vector<double> part = load.window.of(load.series);
  const output::ForceUnit unit = unit_of(part);
  const double side = load.along.statistics.mean < 0 ? -1 : 1, factor = 1 / unit.size;
  std::vector<double> sided = part;
  for (double& value : sided) value *= side;
  Plot plot{.id = "exceedance",
            .title = "How often the load along the course reaches a level",
            .x_label = fmt::format("{} [{}]", side < 0 ? "load, its sign turned" : "load", unit.name),
            .y_label = "share of steps or peaks [%]",
            .log_y = true};
  plot.curves.push_back(step_exceedance("steps", sided, factor));
  plot.curves.push_back(
      peak_exceedance("peaks above the mean", local_peaks(sided, side * load.along.statistics.mean), factor));
  return plot;
}

std::string peaks_text(const RunFindings& found) {
  const BodyLoad& load = *found.load;
  const double side = load.along.statistics.mean < 0 ? -1 : 1;
  std::vector<double> sided = load.window.of(load.series);
  for (double& value : sided) value *= side;
  const auto peaks = local_peaks(sided, side * load.along.statistics.mean);
  return fmt::format(
      "The load rose above its mean {} in {:.4g} s. A peak is the largest step between such a rise and the fall "
      "that follows. Its share is k / (n + 1) for the k-th largest of n peaks.",
      peaks.size() == 1 ? "once" : fmt::format("{} times", peaks.size()), load.window.to - load.window.from);
}

}  // namespace

Curve along_curve(const RunFindings& found, const std::string& name, double factor) {
  return thinned(name, found.run.times(), found.load->series, factor);
}

std::optional<Curve> spectrum_curve(const std::vector<double>& series, const BodyLoad& load, double step,
                                    const std::string& name, double factor) {
  const auto spectrum = spectrum_of(load.window.of(series), step);
  if (!spectrum) return std::nullopt;
  Curve curve{.name = name};
  for (std::size_t k = 1; k < spectrum->density.size(); ++k) {
    curve.x.push_back(spectrum->frequency[k]);
    curve.y.push_back(factor * factor * spectrum->density[k]);
  }
  return curve;
}

Section loads_section(const RunFindings& found) {
  Section section{.id = "loads", .title = "Loads over time"};
  if (found.load == nullptr) {
    section.gaps.emplace_back("The run has no vessel and no fixed body in its tables, so there is no load to draw.");
    return section;
  }
  const bool vessel = found.load->is_vessel();
  section.text.push_back(fmt::format(
      "The load on {} by ice, a mean over each step. Drag over a graph to enlarge a time; a double click shows all. "
      "Where a run has more steps than the graph has points, a band shows the range that each point stands for.",
      found.subject()));
  section.plots.push_back(load_plot(
      found, "load-along",
      vessel ? "Ice load along the course, positive astern" : "Ice load along the drift on " + found.load->name,
      found.load->series, found.load->along));
  section.plots.push_back(load_plot(
      found, "load-across",
      vessel ? "Ice load across the course, positive to port" : "Ice load across the drift on " + found.load->name,
      across_series(found), found.load->across));
  if (!vessel) return section;
  for (const auto& [group, who] : {std::pair{"carriage", "the carriage"},
                                   {"mooring", "the mooring"},
                                   {"thruster", "the thrusters"},
                                   {"wind", "the wind"},
                                   {"manoeuvring", "propeller and rudder"}})
    if (auto plot = group_plot(found.run.vessel, group, who)) {
      std::string beyond = show_after(settled_from(found), *plot);
      if (!beyond.empty()) section.text.push_back(std::move(beyond));
      section.plots.push_back(std::move(*plot));
    }
  if (auto mooring = mooring_plot(found)) {
    section.text.push_back(std::move(mooring->text));
    section.plots.push_back(std::move(mooring->plot));
  }
  if (!found.run.vessel.has("carriage_fx_N") && found.run.vessel.has("x_m"))
    section.plots.push_back(motion_plot(found.run.vessel));
  return section;
}

Section spectra_section(const RunFindings& found) {
  Section section{.id = "spectra", .title = "Spectra"};
  if (found.load == nullptr || !found.load->touched) {
    section.gaps.emplace_back("No ice pressed, so the load has no spectrum.");
    return section;
  }
  const auto spectrum = spectrum_of(found.load->window.of(found.load->series), found.run.step());
  if (!spectrum) {
    section.gaps.emplace_back("The window has fewer than 72 steps, which is too short for a spectrum.");
    return section;
  }
  const output::ForceUnit unit = unit_of(found.load->series);
  section.text.push_back(fmt::format(
      "The spectral density of the loads by Welch's method: {} segments of {:.4g} s that overlap by half, each with a "
      "Hann window. The area under a curve is the variance. The true density lies between {:.2f} and {:.2f} times each "
      "value (95 %).",
      spectrum->segments, static_cast<double>(spectrum->segment) * found.run.step(), spectrum->low, spectrum->high));
  Plot plot{.id = "spectrum",
            .title = "Spectral density of the ice load",
            .x_label = "frequency [Hz]",
            .y_label = fmt::format("density [{}²/Hz]", unit.name),
            .log_x = true,
            .log_y = true};
  const std::array<std::pair<const char*, const std::vector<double>*>, 2> series{
      {{"along the course", &found.load->series}, {"across the course", &across_series(found)}}};
  for (const auto& [name, values] : series)
    if (auto curve = spectrum_curve(*values, *found.load, found.run.step(), name, 1 / unit.size))
      plot.curves.push_back(std::move(*curve));
  section.plots.push_back(std::move(plot));
  return section;
}

Section statistics_section(const RunFindings& found) {
  Section section{.id = "statistics", .title = "Statistics and exceedance"};
  if (found.load == nullptr) {
    section.gaps.emplace_back("The run has no vessel and no fixed body in its tables.");
    return section;
  }
  if (!found.load->told)
    section.text.emplace_back(
        "There is no summary, so these figures were computed from the tables. The error of a mean holds the effect of "
        "chance alone; those of solver and contact law are not known.");
  section.tables.push_back(load_table(found));
  if (found.load->touched && found.load->window.steps() > 1) {
    section.text.push_back(peaks_text(found));
    section.plots.push_back(exceedance_plot(found));
  }
  if (found.run.summary.contains("loads") && !found.run.summary.at("loads").empty())
    section.tables.push_back(channel_table(found.run.summary.at("loads")));
  return section;
}

}  // namespace nilas::report
