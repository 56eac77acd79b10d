#include "apps/compare/scenes/report/study_pictures.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>

#include "apps/compare/scenes/judge/ranking.h"
#include "core/output/text/plot.h"

namespace nilas {

namespace {

/// Both formats of one picture.
std::string both(const std::string& name, int height, const std::string& drawing) {
  std::string script;
  for (const bool vector : {true, false})
    script +=
        fmt::format("reset\nset terminal {} size {},{} font 'sans,{}' background '#ffffff'\nset output '{}.{}'\n{}",
                    vector ? "svg" : "pngcairo", vector ? 960 : 1920, vector ? height : 2 * height, vector ? 12 : 24,
                    name, vector ? "svg" : "png", (vector ? "LW=1\n" : "LW=2\n") + drawing);
  return script;
}

std::string quoted(const std::string& text) {
  std::string out = "\"";
  for (const char c : text) out += c == '"' ? "'" : std::string(1, c);
  return out + "\"";
}

/// A block of numbers that gnuplot reads; empty blocks are not drawn.
struct Block {
  std::string name, rows;
  bool empty() const { return rows.empty(); }
  std::string text() const { return empty() ? "" : "$" + name + " << EOD\n" + rows + "EOD\n"; }
};

/// The key stands beside the plot: its lines are sentences, and names at points would lie over each other.
constexpr const char* k_axes =
    "set logscale xy\nset grid lc rgb '#dddddd'\nset rmargin 40\nset key at graph 1.02, graph 1 left top vertical Left "
    "reverse samplen 1.5 spacing 1.2 noenhanced\n";

/// Labels at 1, 2 and 5 of each decade where there are few of these, else at the decades.
std::string log_tics(const char* axis, double low, double high) {
  const int first = static_cast<int>(std::floor(std::log10(low))), last = static_cast<int>(std::ceil(std::log10(high)));
  constexpr double k_few = 1e3;
  std::string list;
  for (int decade = first; decade <= last; ++decade)
    for (const int digit : high > k_few * low ? std::vector{1} : std::vector{1, 2, 5})
      list += fmt::format("{}{}", list.empty() ? "" : ", ", digit * std::pow(10.0, decade));
  return fmt::format("set {0}range [{1}:{2}]\nset format {0} '%g'\nset {0}tics ({3})\n", axis, low, high, list);
}

/// Time against error: what nothing beats in black, the rest grey; what chaos hides hollow, at the level up to which it
/// does; the chosen setting in a ring. Every point has its number; the key names those that nothing beats.
std::string front(const Findings& found, const std::vector<std::string>& labels) {
  constexpr double k_out_of_sight = 1e-3;  // logarithms know no 0
  double fastest = 1e300, slowest = 0, least = 1e300, most = 0;
  Block best{"best", {}}, beaten{"beaten", {}}, hidden{"hidden", {}}, chosen{"chosen", {}}, named{"named", {}},
      others{"others", {}};
  std::vector<std::string> layers, names;
  std::vector<std::pair<double, std::string>> level;
  std::array<Block, 4> stacked{Block{"level0", {}}, Block{"level1", {}}, Block{"level2", {}}, Block{"level3", {}}};
  for (const auto& m : found.merits) {
    const double error = m.told ? m.error : m.floor;
    if (!(m.time > 0) || !(error > 0) || !std::isfinite(error) || m.done == 0 || m.partial) continue;
    const double spread = found.measure == "load" && m.load_difference.count > 1 ? m.load_difference.standard_error : 0;
    const std::string row =
        fmt::format("{} {} {} {}\n", m.time, error, std::max(error - spread, k_out_of_sight * error), error + spread);
    (!m.told ? hidden : m.dominated ? beaten : best).rows += row;
    if (found.chosen == m.setting) chosen.rows += row;
    slowest = std::max(slowest, m.time);
    fastest = std::min(fastest, m.time);
    least = std::min(least, error);
    most = std::max(most, error + spread);
    const bool in_key = !m.dominated || found.chosen == m.setting || m.setting == 0;
    const std::string number = fmt::format("{} {} \"{}\"\n", m.time, error, m.setting + 1);
    if (m.told)
      (in_key ? named : others).rows += number;
    else
      level.emplace_back(m.time, number);
    if (in_key)
      names.push_back(fmt::format("keyentry with points pt 0 title {}",
                                  quoted(fmt::format("{}  {}", m.setting + 1, labels[m.setting]))));
  }
  if (least > most) return "";
  // they stand at one height, where numbers side by side would lie over each other
  std::sort(level.begin(), level.end());
  for (std::size_t k = 0; k < level.size(); ++k) stacked[k % stacked.size()].rows += level[k].second;
  if (found.reference_moves) most = std::max(most, *found.reference_moves);
  std::string drawing = best.text() + beaten.text() + hidden.text() + chosen.text() + named.text() + others.text();
  for (const auto& block : stacked) drawing += block.text();
  drawing += k_axes;
  constexpr double k_room = 1.6;
  drawing += log_tics("x", fastest / k_room, slowest * k_room) + log_tics("y", least / k_room, most * k_room);
  drawing += fmt::format("set xlabel 'computing time per simulated second [s/s]'\nset ylabel 'error of the {} [{}]'\n",
                         found.measure == "load"   ? "mean ice load"
                         : found.measure == "turn" ? "attitude"
                                                   : "positions (rms)",
                         found.unit);
  const auto layer = [&](const Block& block, const std::string& how) {
    if (!block.empty()) layers.push_back("$" + block.name + " " + how);
  };
  layer(beaten,
        "using 1:2:3:4 with yerrorbars pt 7 ps 1 lw LW lc rgb '#aaaaaa' title 'another is faster and better, or a run "
        "failed'");
  layer(best, "using 1:2:3:4 with yerrorbars pt 7 ps 1.3 lw LW lc rgb '#000000' title 'nothing is faster and better'");
  layer(hidden,
        "using 1:2 with points pt 10 ps 1.3 lw LW lc rgb '#0072b2' title 'cannot be told from chaos or rounding'");
  layer(chosen, "using 1:2 with points pt 6 ps 3 lw 2*LW lc rgb '#d55e00' title 'chosen'");
  for (std::size_t k = 0; k < stacked.size(); ++k)
    layer(stacked[k], fmt::format("using 1:2:3 with labels center offset char 0,{} tc rgb '#0072b2' noenhanced notitle",
                                  0.9 + 0.9 * static_cast<double>(k)));
  layer(named, "using 1:2:3 with labels left offset char 0.8,0.4 noenhanced notitle");
  layer(others, "using 1:2:3 with labels left offset char 0.8,0.4 tc rgb '#888888' noenhanced notitle");
  if (found.reference_moves && *found.reference_moves > least / k_room)  // else it lies below all that is shown
    layers.push_back(fmt::format("{} with lines dt 2 lw LW lc rgb '#009e73' title 'the reference moves by'",
                                 *found.reference_moves));
  if (layers.empty()) return "";
  layers.insert(layers.end(), names.begin(), names.end());
  std::string plot;
  for (const auto& one : layers) plot += (plot.empty() ? "plot " : ", \\\n  ") + one;
  return drawing + plot + "\n";
}

/// Over the step, a line per way to solve.
std::string steps(const Plan& plan, const Findings& found) {
  struct Line {
    std::string rows;
    std::vector<double> errors;
  };
  std::map<std::string, Line> lines;
  double finest = 1e300, coarsest = 0, least = 1e300, most = 0;
  const CompareSetting& own = plan.settings.front();
  for (const auto& m : found.merits) {
    CompareSetting setting = plan.settings[m.setting];
    if (!(m.error > 0) || m.failed > 0 || m.partial) continue;
    finest = std::min(finest, setting.step);
    coarsest = std::max(coarsest, setting.step);
    setting.step = own.step;
    Line& line = lines[label_of(setting, own)];
    line.rows += fmt::format("{} {}\n", plan.settings[m.setting].step, m.error);
    line.errors.push_back(m.error);
  }
  std::erase_if(lines, [](const auto& line) { return line.second.errors.size() < 3; });
  if (lines.empty()) return "";
  for (const auto& [name, line] : lines) {
    least = std::min(least, *std::min_element(line.errors.begin(), line.errors.end()));
    most = std::max(most, *std::max_element(line.errors.begin(), line.errors.end()));
  }
  constexpr double k_room = 1.6;
  constexpr double k_far = 1e-2;  // so far below all errors it would only flatten them
  const bool floor = found.measure == "load" && found.common_floor > k_far * least && std::isfinite(found.common_floor);
  if (floor) {
    least = std::min(least, found.common_floor);
    most = std::max(most, found.common_floor);
  }
  std::string drawing = k_axes, plot;
  drawing += log_tics("x", finest / k_room, coarsest * k_room) + log_tics("y", least / k_room, most * k_room);
  drawing += fmt::format("set xlabel 'step [s]'\nset ylabel 'error [{}]'\nset colorsequence podo\n", found.unit);
  int k = 0;
  for (const auto& [name, line] : lines) {
    ++k;
    drawing += Block{fmt::format("l{}", k), line.rows}.text();
    plot += fmt::format("{}$l{} using 1:2 smooth unique with linespoints lt {} dt {} pt {} lw LW title {}",
                        plot.empty() ? "plot " : ", \\\n  ", k, k, 1 + (k - 1) % 5, k, quoted(name));
  }
  if (floor)
    plot += fmt::format(", \\\n  {} with lines dt 3 lc rgb '#888888' lw LW title 'below: chaos'", found.common_floor);
  return drawing + plot + "\n";
}

/// Bars with standard errors: what each simplification changes, and what it saves.
std::string ablation(const Findings& found, const std::vector<std::string>& labels) {
  Block changes{"changes", {}}, saved{"saved", {}};
  const Merit& full = found.merits.front();
  for (const auto& m : found.merits) {
    if (m.setting == 0 || m.done == 0 || m.partial || std::isnan(m.error)) continue;
    const bool load = found.measure == "load";
    const double change = load ? m.load_difference.mean : m.error, error = load ? m.load_difference.standard_error : 0;
    changes.rows +=
        fmt::format("{} {} {} {}\n", m.setting, change, std::isfinite(error) ? error : 0, quoted(labels[m.setting]));
    saved.rows += fmt::format("{} {} {}\n", m.setting, 1e3 * (full.time - m.time),
                              1e3 * (std::isfinite(m.time_spread) ? m.time_spread : 0));
  }
  if (changes.empty()) return "";
  const auto panel = [&](const std::string& label, const std::string& data, const std::string& using_) {
    return fmt::format(
        "set xlabel '{}'\nplot {} using {} with boxxyerror fs solid 0.35 lc rgb '#0072b2' lw LW notitle, {} with "
        "xerrorbars pt 0 lc rgb '#000000' lw LW notitle\n",
        label, data, using_, data + " using 2:1:3");
  };
  const std::string measure = found.measure == "load" ? "change of the mean ice load [N]"
                                                      : "error of " + found.measure + " [" + found.unit + "]";
  return changes.text() + saved.text() +
         fmt::format(
             "set multiplot layout 1,2\nset yrange [{}:0.4]\nset ytics noenhanced\nset xzeroaxis\nset xtics rotate by "
             "-30\nset arrow from 0, "
             "graph 0 to 0, graph 1 nohead lc rgb '#888888'\nset grid x lc rgb '#dddddd'\nset lmargin 24\n",
             static_cast<double>(found.merits.size()) - 0.4) +
         panel(measure, "$changes", "(0.5*$2):1:(0.5*abs($2)):(0.3):ytic(4)") + "set format y ''\nset lmargin 4\n" +
         panel("time saved [ms per simulated second]", "$saved", "(0.5*$2):1:(0.5*abs($2)):(0.3)") +
         "unset multiplot\n";
}

/// One row of the picture of differences: over the setting's realisations, and their mean.
struct DifferenceRow {
  std::string label;
  std::vector<double> values;
  double half_width = 0;
  Certainty certainty = Certainty::unknown;
};

std::vector<DifferenceRow> difference_rows(const Findings& found, const std::vector<std::string>& labels) {
  constexpr double k_nan = std::numeric_limits<double>::quiet_NaN();
  std::vector<DifferenceRow> rows;
  DifferenceRow twin{"its twin: chance alone", {}, k_nan}, reference{"the reference", {}, k_nan};
  if (!found.merits.empty()) reference.certainty = found.merits.front().from_reference.certainty;
  for (const int r : found.shared) {
    const RunRow *twin_run = done_run(found, RunKind::twin, 0, r), *judge = reference_of(found, r);
    if (twin_run != nullptr && twin_run->own_difference) twin.values.push_back(*twin_run->own_difference);
    if (judge != nullptr && judge->own_difference && judge->run.kind != RunKind::grid)
      reference.values.push_back(*judge->own_difference);
  }
  for (auto* row : {&twin, &reference})
    if (!row->values.empty()) rows.push_back(*row);
  for (const auto& m : found.merits) {
    const PairedDifference& d = m.from_own;
    if (!d.values.empty())
      rows.push_back({fmt::format("{}  {}", m.setting + 1, labels[m.setting]), d.values, d.half_width, d.certainty});
  }
  return rows;
}

/// Run by run on the same ice, how far settings are from the scene's own: small points are realisations, large ones
/// their mean, full where it is sure; the band is what chance alone does to two runs of one realisation.
std::string differences(const std::vector<DifferenceRow>& rows, double limit) {
  Block runs{"runs", {}}, sure{"sure", {}}, here{"here", {}}, unsure{"unsure", {}};
  double low = 0, high = 0;
  std::string tics;
  const auto reach = [&](double from, double to) {
    low = std::min(low, from);
    high = std::max(high, to);
  };
  for (std::size_t k = 0; k < rows.size(); ++k) {
    const DifferenceRow& row = rows[k];
    const double mean = mean_of(row.values);
    constexpr std::size_t k_least = 3;  // of two the interval is too wide to be drawn
    const double width = row.values.size() >= k_least && std::isfinite(row.half_width) ? row.half_width : 0;
    Block& block = row.certainty == Certainty::everywhere        ? sure
                   : row.certainty == Certainty::in_realisations ? here
                                                                 : unsure;
    block.rows += fmt::format("{} {} {}\n", mean, k, width);
    for (const double value : row.values) {
      runs.rows += fmt::format("{} {}\n", value, k);
      reach(value, value);
    }
    reach(mean - width, mean + width);
    tics += fmt::format("{}{} {}", tics.empty() ? "" : ", ", quoted(row.label), k);
  }
  constexpr double k_room = 0.1;
  const double room = high > low ? k_room * (high - low) : 1;
  reach(low - room, high + room);
  std::string drawing = runs.text() + sure.text() + here.text() + unsure.text();
  drawing += fmt::format(
      "set xrange [{}:{}]\nset yrange [{}:-0.7]\nset ytics noenhanced ({})\nset grid lc rgb '#dddddd'\n"
      "set xtics rotate by -30\nset xlabel \"mean ice load less that of the scene's own setting, on the same ice "
      "[N]\"\n"
      "set rmargin 6\nset key outside top center horizontal noenhanced\nset arrow from 0, graph 0 to 0, graph 1 nohead "
      "lc rgb "
      "'#888888'\n",
      low, high, static_cast<double>(rows.size()) - 0.3, tics);
  if (std::isfinite(limit) && limit > 0)
    drawing +=
        fmt::format("set object rectangle from {}, graph 0 to {}, graph 1 behind fc rgb '#eeeeee' fs solid noborder\n",
                    std::max(-limit, low), std::min(limit, high));
  std::string plot;
  const auto layer = [&](const Block& block, const std::string& how) {
    if (!block.empty()) plot += (plot.empty() ? "plot $" : ", \\\n  $") + block.name + " " + how;
  };
  layer(sure, "using 1:2:3 with xerrorbars pt 7 ps LW lw LW lc rgb '#d55e00' title 'sure'");
  layer(here,
        "using 1:2:3 with xerrorbars pt 5 ps LW lw LW lc rgb '#e69f00' title 'sure in these realisations, not in the "
        "mean'");
  layer(unsure, "using 1:2:3 with xerrorbars pt 6 ps LW lw LW lc rgb '#0072b2' title 'may be chance'");
  layer(runs, "using 1:2 with points pt 7 ps 0.4*LW lc rgb '#000000' title 'each realisation'");
  return drawing + plot + "\n";
}

/// The widest of what chance alone does, as far as it was measured; infinite where it was not.
double chance_band(const Findings& found) {
  double widest = std::numeric_limits<double>::infinity();
  for (const auto& m : found.merits)
    for (const double limit : m.from_own.limits)
      if (std::isfinite(limit)) widest = std::isfinite(widest) ? std::max(widest, limit) : limit;
  return widest;
}

/// The front once more, with the distance from the reference as the error.
Findings by_motion(Findings found) {
  found.measure = "distance";
  found.unit = "m";
  found.reference_moves.reset();
  found.chosen.reset();
  if (!found.horizon_known) found.merits.clear();
  std::erase_if(found.merits, [](const Merit& m) { return m.done == 0 || std::isnan(m.motion.mean); });
  for (auto& m : found.merits) {
    m.error = m.motion.mean;
    m.floor = found.horizon_ends ? found.horizon_threshold_m : k_rounding_share;
    m.told = m.error > m.floor;
  }
  rank(found);
  return found;
}

}  // namespace

Drawings draw_study(const std::filesystem::path& folder, const Study& study, const Findings& found,
                    const std::vector<std::string>& labels) {
  Drawings drawings;
  const auto draw = [&](const std::string& name, int height, const std::string& drawing) {
    if (drawing.empty()) return;
    try {
      plot(folder, both(name, height, drawing));
      drawings.drawn.push_back(name);
    } catch (const PlotError& e) {
      drawings.trouble = e.what();
    }
  };
  if (study.ablation) {
    draw("ablation", 120 + 45 * static_cast<int>(found.merits.size()), ablation(found, labels));
    return drawings;
  }
  const auto rows = found.measure == "load" ? difference_rows(found, labels) : std::vector<DifferenceRow>{};
  if (!rows.empty())
    draw("differences", 140 + 22 * static_cast<int>(rows.size()), differences(rows, chance_band(found)));
  draw("front", 560, front(found, labels));
  const bool moves =
      std::any_of(found.merits.begin(), found.merits.end(), [](const Merit& m) { return m.motion.mean > 0; });
  if (found.measure == "load" && moves) draw("motion", 560, front(by_motion(found), labels));
  draw("steps", 420, steps(study.plan, found));
  return drawings;
}

}  // namespace nilas
