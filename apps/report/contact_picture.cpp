#include "apps/report/contact_picture.h"

#include <fmt/format.h>

#include <algorithm>

#include "apps/report/axis_ticks.h"
#include "apps/report/hull_lines.h"
#include "core/output/loads/ice_load_text.h"

namespace nilas {

namespace {

std::string point(const View& view, const Vec3& p) { return fmt::format("{:.6g} {:.6g}", p[view.across], p[view.up]); }

std::string block(const std::string& name, const std::string& lines) {
  return "$" + name + " << EOD\n" + lines + "EOD\n";
}

/// In single quotes, within which gnuplot reads nothing but the quote.
std::string quoted(const std::string& text) {
  std::string out = "'";
  for (const char c : text) out += c == '\'' ? std::string("''") : std::string(1, c);
  return out + "'";
}

std::string segments(const View& view, const std::vector<Segment>& lines) {
  std::string text;
  for (const auto& [a, b] : lines) text += point(view, a) + "\n" + point(view, b) + "\n\n";
  return text;
}

std::string outlines(const View& view, const std::vector<std::vector<Vec3>>& floes) {
  std::string text;
  for (const auto& floe : floes) {
    for (std::size_t k = 0; k <= floe.size(); ++k) text += point(view, floe[k % floe.size()]) + "\n";
    text += "\n\n";
  }
  return text;
}

/// A mark that faces sideways, as one on the centre plane of a hull, belongs to both sides.
bool shows(const View& view, const ContactMark& mark) {
  constexpr double k_sideways = -1e-6;
  return view.is_plan() || mark.side.dot(view.from) >= k_sideways;
}

std::string marks(const View& view, const ContactWindow& window, double unit) {
  std::string text;
  for (const auto& mark : window.marks)
    if (shows(view, mark)) text += fmt::format("{} {:.6g}\n", point(view, mark.p), mark.force.norm() / unit);
  return text;
}

/// Strongest contact of all rows; 1 N where there is none.
double strongest(const ContactPictureInput& input) {
  double force = 0;
  for (const auto& row : input.rows)
    for (const auto& mark : row.window.marks) force = std::max(force, mark.force.norm());
  return force > 0 ? force : 1;
}

constexpr int k_width = 1440, k_head = 96, k_foot = 160, k_above_row = 96;  // [px]
constexpr double k_left = 0.055, k_right = 0.985, k_gap = 0.055;            // of the width
constexpr double k_panel_width = k_width * (k_right - k_left - 2 * k_gap) / 3;

/// So that the longest axis across fills its panel, within limits.
double panel_height(const ContactPictureInput& input) {
  constexpr double k_lowest = 120, k_highest = 420;
  double height = k_lowest;
  for (const View& view : input.views) {
    const auto &across = input.frame.axes[static_cast<std::size_t>(view.across)],
               &up = input.frame.axes[static_cast<std::size_t>(view.up)];
    height = std::max(height, k_panel_width * up.width() / across.width());
  }
  return std::min(height, k_highest);
}

/// Numbers along an axis that is `pixels` long, `room` for each, and not too many.
double step_of_ticks(double length, double pixels, double room) {
  constexpr double k_most = 8;
  return tick_step(length, static_cast<int>(std::clamp(pixels / room, 2.0, k_most)));
}

/// Lines that all rows share, and the marks of each.
std::string data_of(const ContactPictureInput& input, double unit) {
  std::string data;
  for (std::size_t v = 0; v < input.views.size(); ++v) {
    const View& view = input.views[v];
    std::string lines;
    for (const auto& mesh : input.bodies) lines += segments(view, visible_lines(mesh, view.from));
    data += block(fmt::format("bodies_{}", v), lines);
    for (std::size_t w = 0; w < input.rows.size(); ++w) {
      const PictureRow& row = input.rows[w];
      data += block(fmt::format("marks_{}_{}", v, w), marks(view, row.window, unit));
      std::string water;
      for (const auto& mesh : input.bodies)
        water += segments(view, waterline(mesh, input.water_level - row.window.floating_level));
      data += block(fmt::format("water_{}_{}", v, w), water);
      if (view.is_plan()) data += block(fmt::format("floes_{}", w), outlines(view, row.floes));
    }
  }
  return data;
}

std::string panel(const ContactPictureInput& input, std::size_t v, std::size_t w, double height, double scale_end) {
  const View& view = input.views[v];
  const PictureRow& row = input.rows[w];
  const Range &across = input.frame.axes[static_cast<std::size_t>(view.across)],
              &up = input.frame.axes[static_cast<std::size_t>(view.up)];
  const double pixels_per_metre = std::min(k_panel_width / across.width(), height / up.width());
  const double beside = 0.5 * (k_panel_width / pixels_per_metre - across.width());  // room that the panel has left
  constexpr double k_room_across = 45, k_room_up = 18;                              // of a number [px]
  constexpr const char* k_axes = "xyz";
  std::string text = fmt::format("set xrange [{}:{}]\nset yrange [{}:{}]\n",
                                 view.reversed ? across.high + beside : across.low - beside,
                                 view.reversed ? across.low - beside : across.high + beside, up.low, up.high);
  text += fmt::format("set xtics {}\nset ytics {}\n",
                      step_of_ticks(across.width() + 2 * beside, k_panel_width, k_room_across),
                      step_of_ticks(up.width(), pixels_per_metre * up.width(), k_room_up));
  const std::string said = view.is_plan() ? fmt::format("t = {:g} ± {:g} s: {} contacts\\n{}", row.window.t,
                                                        row.window.half_width, row.window.marks.size(), row.loads)
                                          : view.name;
  text += fmt::format("set title \"{}\" noenhanced offset 0,-0.6\n", said);
  text += fmt::format("set xlabel '{}'\nset ylabel '{} [m]' offset 0.5,0\n",
                      w + 1 == input.rows.size() ? fmt::format("{} [m]", k_axes[view.across]) : "", k_axes[view.up]);
  text += "plot ";
  if (view.is_plan() && !row.floes.empty()) {
    text += fmt::format("$floes_{} using 1:2 with filledcurves closed fc rgb '#dbeaf5' notitle, ", w);
    text += fmt::format("$floes_{} using 1:2 with lines lc rgb '#7fa6c4' lw 0.7 notitle, ", w);
  }
  text += fmt::format("$bodies_{} using 1:2 with lines lc rgb '#333333' lw 1 notitle, ", v);
  text += fmt::format("$water_{}_{} using 1:2 with lines lc rgb '#2b6ca3' lw 1 dt 2 notitle", v, w);
  if (!row.window.marks.empty())
    text +=
        fmt::format(", $marks_{}_{} using 1:2:(0.35+0.9*sqrt($3/{})):3 with points pt 7 ps variable lc palette notitle",
                    v, w, scale_end);
  return text + "\n";
}

}  // namespace

std::string contact_picture_script(const ContactPictureInput& input) {
  constexpr double k_decades = 1e-3;
  const ForceUnit unit = force_unit(strongest(input));
  const double scale_end = strongest(input) / unit.size, row_height = panel_height(input);
  const auto rows = static_cast<double>(input.rows.size());
  const double height = k_head + k_foot + rows * row_height + (rows - 1) * k_above_row;
  std::string script = data_of(input, unit.size);
  script += "set size ratio -1\nset tics font ',9' nomirror out\nset border 3 lc rgb '#888888'\nset key off\n";
  script += "set palette defined (0 '#440154', 1 '#3b528b', 2 '#21918c', 3 '#5ec962', 4 '#fde725')\n";
  script +=
      fmt::format("set logscale cb\nset cbrange [{:g}:{:g}]\nset cblabel 'force of a contact [{}]' offset 0,0.5\n",
                  k_decades * scale_end, scale_end, unit.name);
  for (const char* kind : {"svg", "png"}) {
    const bool vector = kind == std::string("svg");
    script += fmt::format("set terminal {} size {},{:.0f} font 'sans,{}' {}\nset output 'contacts.{}'\n",
                          vector ? "svg" : "pngcairo", k_width, height, 11, vector ? "background '#ffffff'" : "", kind);
    script +=
        fmt::format("set multiplot layout {},{} title {} noenhanced margins {},{},{:.4f},{:.4f} spacing {},{:.4f}\n",
                    input.rows.size(), input.views.size(), quoted(input.title), k_left, k_right, k_foot / height,
                    1 - k_head / height, k_gap, k_above_row / height);
    if (!input.frame.left_out.empty())
      script += fmt::format("set label 1 \"{}\" at screen 0.5,{:.4f} center font ',9' noenhanced\n",
                            input.frame.left_out, 12 / height);
    for (std::size_t w = 0; w < input.rows.size(); ++w)
      for (std::size_t v = 0; v < input.views.size(); ++v) {
        const bool scale = w + 1 == input.rows.size() && input.views[v].is_plan();
        script += scale ? fmt::format("set colorbox horizontal user origin 0.36,{:.4f} size 0.28,{:.4f}\n",
                                      82.0 / height, 9.0 / height)
                        : "unset colorbox\n";
        script += panel(input, v, w, row_height, scale_end);
        if (w == 0 && v == 0) script += "unset label 1\n";  // every panel would draw it again
      }
    script += "unset multiplot\nunset output\n";
  }
  return script;
}

}  // namespace nilas
