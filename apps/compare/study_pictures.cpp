#include "apps/compare/study_pictures.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>

#include "apps/compare/ranking.h"
#include "core/output/plot.h"

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

constexpr const char* k_axes =
    "set logscale xy\nset format x '10^{%L}'\nset format y '10^{%L}'\nset grid lc rgb '#dddddd'\nset key outside "
    "bottom center horizontal noenhanced\n";

/// Labels at 1, 2 and 5 of each decade where there are few of these, else at the decades.
std::string log_tics(const char* axis, double low, double high) {
  const int first = static_cast<int>(std::floor(std::log10(low))), last = static_cast<int>(std::ceil(std::log10(high)));
  constexpr int k_few = 3;
  std::string list;
  for (int decade = first; decade <= last; ++decade)
    for (const int digit : last - first > k_few ? std::vector{1} : std::vector{1, 2, 5})
      list += fmt::format("{}{}", list.empty() ? "" : ", ", digit * std::pow(10.0, decade));
  return fmt::format("set {0}range [{1}:{2}]\nset format {0} '%g'\nset {0}tics ({3})\n", axis, low, high, list);
}

/// Time against error: what nothing beats in black, the rest grey; what chaos hides hollow, at the level up to which it
/// does; the chosen setting in a ring.
std::string front(const Findings& found, const std::vector<std::string>& labels) {
  double fastest = 1e300, slowest = 0, least = 1e300, most = 0;
  int place = 0;
  Block best{"best", {}}, beaten{"beaten", {}}, hidden{"hidden", {}}, chosen{"chosen", {}}, names{"names", {}},
      numbers{"numbers", {}}, below{"below", {}};
  for (const auto& m : found.merits) {
    const double error = m.told ? m.error : m.floor;
    if (!(m.time > 0) || !(error > 0) || !std::isfinite(error) || m.done == 0) continue;
    const double spread = found.measure == "load" && m.load_difference.count > 1 ? m.load_difference.standard_error : 0;
    const std::string row =
        fmt::format("{} {} {} {}\n", m.time, error, std::max(error - spread, 0.3 * error), error + spread);
    (!m.told ? hidden : m.dominated ? beaten : best).rows += row;
    if (found.chosen == m.setting) chosen.rows += row;
    slowest = std::max(slowest, m.time);
    fastest = std::min(fastest, m.time);
    least = std::min(least, error);
    most = std::max(most, error + spread);
    const bool named = !m.dominated || found.chosen == m.setting || m.setting == 0;
    // names of neighbours above and below in turn
    (!named             ? numbers
     : ++place % 2 == 0 ? below
                        : names)
        .rows += fmt::format(
        "{} {} {}\n", m.time, error,
        quoted(named ? fmt::format("{}  {}", m.setting + 1, labels[m.setting]) : std::to_string(m.setting + 1)));
  }
  if (least > most) return "";
  std::string drawing = best.text() + beaten.text() + hidden.text() + chosen.text() + names.text() + below.text() +
                        numbers.text() + k_axes;
  constexpr double k_room = 1.6, k_for_names = 4;
  drawing += log_tics("x", fastest / k_room, slowest * k_for_names) + log_tics("y", least / k_room, most * k_room);
  drawing += fmt::format("set xlabel 'computing time per simulated second [s/s]'\nset ylabel 'error of the {} [{}]'\n",
                         found.measure == "load"   ? "mean ice load"
                         : found.measure == "turn" ? "attitude"
                                                   : "positions (rms)",
                         found.unit);
  std::vector<std::string> layers;
  const auto layer = [&](const Block& block, const std::string& how) {
    if (!block.empty()) layers.push_back("$" + block.name + " " + how);
  };
  layer(beaten,
        "using 1:2:3:4 with yerrorbars pt 7 ps 1 lw LW lc rgb '#aaaaaa' title 'another is faster and better, or not "
        "all done'");
  layer(best, "using 1:2:3:4 with yerrorbars pt 7 ps 1.3 lw LW lc rgb '#000000' title 'nothing is faster and better'");
  layer(hidden, "using 1:2 with points pt 10 ps 1.3 lw LW lc rgb '#0072b2' title 'below what can be told from chaos'");
  layer(chosen, "using 1:2 with points pt 6 ps 3 lw 2*LW lc rgb '#d55e00' title 'chosen'");
  layer(names, "using 1:2:3 with labels left offset char 1,0.6 noenhanced notitle");
  layer(below, "using 1:2:3 with labels left offset char 1,-0.6 noenhanced notitle");
  layer(numbers, "using 1:2:3 with labels left offset char 0.6,0.3 tc rgb '#888888' noenhanced notitle");
  if (found.reference_moves && *found.reference_moves > 0)
    layers.push_back(fmt::format("{} with lines dt 2 lw LW lc rgb '#009e73' title 'the reference moves by'",
                                 *found.reference_moves));
  std::string plot;
  for (const auto& one : layers) plot += (plot.empty() ? "plot " : ", \\\n  ") + one;
  return layers.empty() ? "" : drawing + plot + "\n";
}

/// Over the step, a line per way to solve.
std::string steps(const Plan& plan, const Findings& found) {
  std::map<std::string, std::string> lines;
  const CompareSetting& own = plan.settings.front();
  for (const auto& m : found.merits) {
    CompareSetting setting = plan.settings[m.setting];
    if (!(m.error > 0) || m.done < m.planned) continue;
    setting.step = own.step;
    lines[label_of(setting, own)] += fmt::format("{} {}\n", plan.settings[m.setting].step, m.error);
  }
  std::erase_if(lines, [](const auto& line) { return std::count(line.second.begin(), line.second.end(), '\n') < 3; });
  if (lines.empty()) return "";
  std::string drawing = k_axes, plot;
  drawing += fmt::format("set format x '%g'\nset xlabel 'step [s]'\nset ylabel 'error [{}]'\nset colorsequence podo\n",
                         found.unit);
  int k = 0;
  for (const auto& [name, rows] : lines) {
    ++k;
    drawing += Block{fmt::format("l{}", k), rows}.text();
    plot += fmt::format("{}$l{} using 1:2 smooth unique with linespoints lt {} dt {} pt {} lw LW title {}",
                        plot.empty() ? "plot " : ", \\\n  ", k, k, 1 + (k - 1) % 5, k, quoted(name));
  }
  if (found.measure == "load") {
    double floor = 0;
    for (const auto& m : found.merits) floor = std::max(floor, m.floor);
    if (floor > 0) plot += fmt::format(", \\\n  {} with lines dt 3 lc rgb '#888888' lw LW title 'below: chaos'", floor);
  }
  return drawing + plot + "\n";
}

/// Bars with standard errors: what each simplification changes, and what it saves.
std::string ablation(const Findings& found, const std::vector<std::string>& labels) {
  Block changes{"changes", {}}, saved{"saved", {}};
  const Merit& full = found.merits.front();
  for (const auto& m : found.merits) {
    if (m.setting == 0 || m.done == 0 || std::isnan(m.error)) continue;
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
             "set multiplot layout 1,2\nset yrange [{}:0.4]\nset ytics noenhanced\nset xzeroaxis\nset arrow from 0, "
             "graph 0 to 0, graph 1 nohead lc rgb '#888888'\nset grid x lc rgb '#dddddd'\nset lmargin 24\n",
             static_cast<double>(found.merits.size()) - 0.4) +
         panel(measure, "$changes", "(0.5*$2):1:(0.5*abs($2)):(0.3):ytic(4)") + "set format y ''\nset lmargin 4\n" +
         panel("time saved [ms per simulated second]", "$saved", "(0.5*$2):1:(0.5*abs($2)):(0.3)") +
         "unset multiplot\n";
}

/// The front once more, with the distance from the reference as the error.
Findings by_motion(Findings found) {
  found.measure = "distance";
  found.unit = "m";
  found.reference_moves.reset();
  found.chosen.reset();
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

std::vector<std::string> draw_study(const std::filesystem::path& folder, const Study& study, const Findings& found,
                                    const std::vector<std::string>& labels) {
  std::vector<std::string> drawn;
  const auto draw = [&](const std::string& name, int height, const std::string& drawing) {
    if (drawing.empty()) return;
    plot(folder, both(name, height, drawing));
    drawn.push_back(name);
  };
  if (study.ablation) {
    draw("ablation", 120 + 45 * static_cast<int>(found.merits.size()), ablation(found, labels));
    return drawn;
  }
  draw("front", 560, front(found, labels));
  const bool moves =
      std::any_of(found.merits.begin(), found.merits.end(), [](const Merit& m) { return m.motion.mean > 0; });
  if (found.measure == "load" && moves) draw("motion", 560, front(by_motion(found), labels));
  draw("steps", 420, steps(study.plan, found));
  return drawn;
}

}  // namespace nilas
