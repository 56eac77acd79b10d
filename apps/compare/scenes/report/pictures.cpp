#include "apps/compare/scenes/report/pictures.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>

#include "apps/compare/scenes/judge/pairing.h"
#include "apps/compare/scenes/judge/ranking.h"
#include "apps/compare/scenes/report/front_picture.h"
#include "apps/compare/scenes/report/front_points.h"
#include "apps/compare/workshop/json_store.h"
#include "apps/compare/workshop/special_numbers.h"
#include "core/base/statistics.h"
#include "core/output/text/plot.h"

namespace nilas::compare {

namespace {

/// The text in double quotes, as gnuplot reads texts in data.
std::string quoted(const std::string& text) {
  std::string out = "\"";
  for (const char c : text) out += c == '"' ? "'" : std::string(1, c);
  return out + "\"";
}

/// The error over the step, with a line for each group of settings that differ in the step alone.
std::optional<Picture> steps(const Plan& plan, const Findings& found) {
  struct Line {
    std::string rows;
    std::vector<double> errors;
  };
  std::map<std::string, Line> lines;
  Extent step, error;
  for (const auto& m : found.merits) {
    const CompareSetting& setting = plan.settings[m.setting];
    if (!(m.error > 0) || m.failed > 0 || m.partial) continue;
    step.add(setting.step);
    Line& line = lines[label_without_step(setting, plan.settings.front())];
    line.rows += fmt::format("{} {}\n", setting.step, m.error);
    line.errors.push_back(m.error);
  }
  std::erase_if(lines, [](const auto& line) { return line.second.errors.size() < k_least_order_steps; });
  if (lines.empty()) return std::nullopt;
  Json data{{"quantity", quantity_of(found.measure)}, {"unit", found.measure.unit}, {"lines", Json::array()}};
  constexpr int k_dashes = 5;
  for (const auto& [label, line] : lines) {
    for (const double e : line.errors) error.add(e);
    const int k = static_cast<int>(data["lines"].size()) + 1;
    data["lines"].push_back({{"name", fmt::format("l{}", k)},
                             {"rows", line.rows},
                             {"number", k},
                             {"dash", 1 + (k - 1) % k_dashes},
                             {"label", label}});
  }
  constexpr double k_far = 1e-2;  // a floor this far below all errors would flatten the picture
  const bool floor =
      found.measure.is_load() && found.common_floor > k_far * error.low && std::isfinite(found.common_floor);
  if (floor) error.add(found.common_floor);
  data["floor"] = number_if(floor, found.common_floor);
  add_axis("x", log_axis(step), data);
  add_axis("y", log_axis(error), data);
  constexpr int k_height = 420;
  return Picture{.name = "steps", .script = "steps.gnuplot", .height = k_height, .data = data};
}

/// Bars with standard errors of the change by each simplification and of the time that it saves.
std::optional<Picture> ablation(const Findings& found, const std::vector<std::string>& labels) {
  std::string changes, saved;
  const Merit& full = found.merits.front();
  const bool load = found.measure.is_load();
  for (const auto& m : found.merits) {
    if (m.setting == 0 || m.done == 0 || m.partial || std::isnan(m.error)) continue;
    const double change = load ? m.load_difference.mean : m.error, error = load ? m.load_difference.standard_error : 0;
    changes +=
        fmt::format("{} {} {} {}\n", m.setting, change, std::isfinite(error) ? error : 0, quoted(labels[m.setting]));
    saved += fmt::format("{} {} {}\n", m.setting, 1e3 * (full.time - m.time),
                         1e3 * (std::isfinite(m.time_spread) ? m.time_spread : 0));
  }
  if (changes.empty()) return std::nullopt;
  const auto count = static_cast<int>(found.merits.size());
  return Picture{.name = "ablation",
                 .script = "ablation.gnuplot",
                 .height = 120 + 45 * count,
                 .data = {{"changes", changes},
                          {"saved", saved},
                          {"bottom", count - 0.4},
                          {"quantity", load ? "change of the mean ice load [N]"
                                            : fmt::format("change of the {} [{}]", quantity_of(found.measure),
                                                          found.measure.unit)}}};
}

/// One row of the picture of differences: the values of a setting, one per realisation [N], and the interval of their
/// mean.
struct DifferenceRow {
  std::string label;
  std::vector<double> values;
  double half_width = 0;
  Certainty certainty = Certainty::unknown;
  bool below_change = false;  ///< it is smaller than the change of the reference with its own step
};

std::vector<DifferenceRow> difference_rows(const Findings& found, const std::vector<std::string>& labels) {
  std::vector<DifferenceRow> rows;
  DifferenceRow perturbed{"perturbed run: chance alone", {}, k_unknown}, reference{"the reference", {}, k_unknown};
  if (!found.merits.empty()) {
    const PairedDifference& own = found.merits.front().from_reference;
    reference.certainty = own.certainty;
    reference.below_change = is_below_change(own, found.check.moves.value_or(0));
  }
  for (const int r : found.shared) {
    const RunRow *other = done_run(found.rows, RunKind::twin, 0, r), *judge = judge_of(found.rows, r);
    if (other != nullptr && other->own_difference) perturbed.values.push_back(*other->own_difference);
    if (judge != nullptr && judge->own_difference && judge->run.kind != RunKind::grid)
      reference.values.push_back(*judge->own_difference);
  }
  for (auto* row : {&perturbed, &reference})
    if (!row->values.empty()) rows.push_back(*row);
  for (const auto& m : found.merits) {
    const PairedDifference& d = m.from_own;
    if (!d.values.empty())
      rows.push_back({fmt::format("{}  {}", m.setting + 1, labels[m.setting]), d.values, d.half_width, d.certainty});
  }
  return rows;
}

/// The marks of the means, in layers by their significance.
Json mean_layers(const std::vector<DifferenceRow>& rows, const std::vector<double>& widths) {
  struct Layer {
    const char *name, *colour, *title;
    int mark;
    bool (*holds)(const DifferenceRow&);
  };
  using Row = const DifferenceRow&;
  constexpr std::array<Layer, 4> k_layers{
      {{"sure", "#d55e00", "significant", 7,
        [](Row row) { return row.certainty == Certainty::everywhere && !row.below_change; }},
       {"here", "#e69f00", "significant in these realisations, not in the mean", 5,
        [](Row row) { return row.certainty == Certainty::in_realisations && !row.below_change; }},
       {"below", "#009e73", "less than the reference's own change", 4, [](Row row) { return row.below_change; }},
       {"unsure", "#0072b2", "may be chance", 6,
        [](Row row) { return row.certainty == Certainty::none || row.certainty == Certainty::unknown; }}}};
  Json layers = Json::array();
  for (const auto& layer : k_layers) {
    std::string text;
    for (std::size_t k = 0; k < rows.size(); ++k)
      if (layer.holds(rows[k])) text += fmt::format("{} {} {}\n", mean_of(rows[k].values), k, widths[k]);
    if (!text.empty())
      layers.push_back({{"name", layer.name},
                        {"rows", text},
                        {"mark", layer.mark},
                        {"colour", layer.colour},
                        {"title", layer.title}});
  }
  return layers;
}

std::optional<Picture> differences(const Findings& found, const std::vector<std::string>& labels) {
  if (!found.measure.is_load()) return std::nullopt;
  const std::vector<DifferenceRow> rows = difference_rows(found, labels);
  if (rows.empty()) return std::nullopt;
  Extent shown;
  shown.add(0);
  std::string runs;
  Json names = Json::array();
  std::vector<double> widths;
  for (std::size_t k = 0; k < rows.size(); ++k) {
    const DifferenceRow& row = rows[k];
    constexpr std::size_t k_least = 3;  // the interval of two values is too wide to be drawn
    widths.push_back(row.values.size() >= k_least && std::isfinite(row.half_width) ? row.half_width : 0);
    const double mean = mean_of(row.values);
    for (const double end : {mean - widths.back(), mean + widths.back()}) shown.add(end);
    for (const double value : row.values) {
      runs += fmt::format("{} {}\n", value, k);
      shown.add(value);
    }
    names.push_back({{"label", row.label}, {"place", k}, {"comma", k + 1 < rows.size() ? ", " : ""}});
  }
  constexpr double k_margin = 0.1;
  const double margin = shown.high > shown.low ? k_margin * (shown.high - shown.low) : 1;
  const double low = shown.low - margin, high = shown.high + margin,
               limit = widest_limit(found.merits, &Merit::from_own);
  Json data{{"low", low},    {"high", high}, {"bottom", static_cast<double>(rows.size()) - 0.3},
            {"rows", names}, {"runs", runs}, {"layers", mean_layers(rows, widths)}};
  data["band"] = nullptr;
  if (limit > 0) data["band"] = {{"from", std::max(-limit, low)}, {"to", std::min(limit, high)}};
  return Picture{.name = "differences",
                 .script = "differences.gnuplot",
                 .height = 140 + 22 * static_cast<int>(rows.size()),
                 .data = data};
}

}  // namespace

std::vector<Picture> pictures_of(const SceneReport& report) {
  const Findings& found = report.found;
  if (found.merits.empty()) return {};
  const auto labels = report.labels();
  std::vector<Picture> pictures;
  const auto add = [&](std::optional<Picture> picture) {
    if (picture) pictures.push_back(std::move(*picture));
  };
  if (report.study.ablation) {
    add(ablation(found, labels));
    return pictures;
  }
  add(differences(found, labels));
  add(front_picture("front", found, labels));
  if (const auto moved = judged_by_motion(found)) add(front_picture("motion", *moved, labels));
  add(steps(report.study.plan, found));
  return pictures;
}

Drawings draw(const std::filesystem::path& folder, const std::vector<Picture>& pictures) {
  Drawings drawings;
  for (const auto& picture : pictures) {
    try {
      output::plot(folder, script_of(picture));
      drawings.drawn.push_back(picture.name);
    } catch (const output::PlotError& e) {
      drawings.trouble = e.what();
    }
  }
  return drawings;
}

}  // namespace nilas::compare
