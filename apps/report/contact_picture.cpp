#include "apps/report/contact_picture.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "apps/report/hull_lines.h"

namespace nilas {

namespace {

/// One view of the hull: the axes of the picture and where the viewer stands.
struct View {
  const char* name;
  Vec3 right, up, from;
};
const View k_port{"port side", -Vec3::UnitX(), Vec3::UnitZ(), Vec3::UnitY()};
const View k_plan{"plan", Vec3::UnitX(), Vec3::UnitY(), Vec3::UnitZ()};
const View k_starboard{"starboard side", Vec3::UnitX(), Vec3::UnitZ(), -Vec3::UnitY()};

std::string point(const View& view, const Vec3& p) {
  return fmt::format("{:.4f} {:.4f}", std::abs(view.right.x()) * p.x(), view.up.dot(p));
}

std::string block(const std::string& name, const std::string& lines) {
  return "$" + name + " << EOD\n" + lines + "EOD\n";
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

/// A mark on the centre plane belongs to both sides.
bool shows(const View& view, const ContactMark& mark) { return &view == &k_plan || mark.p_V.dot(view.from) >= 0; }

std::string marks(const View& view, const ContactWindow& window) {
  std::string text;
  for (const auto& mark : window.marks)
    if (shows(view, mark)) text += fmt::format("{} {:.6g}\n", point(view, mark.p_V), mark.force.norm());
  return text;
}

struct Range {
  double low = std::numeric_limits<double>::infinity(), high = -low;
  void add(double x) {
    low = std::min(low, x);
    high = std::max(high, x);
  }
};

/// Along the hull, as far as it was touched.
struct Frame {
  Range x, y, z;
  double weakest = 0, strongest = 1;  ///< ends of the scale [N]
};

Frame frame_of(const ContactPictureInput& input) {
  Frame frame;
  Range touched, force;
  for (const Vec3& p : input.hull.vertices) {
    frame.x.add(p.x());
    frame.y.add(p.y());
    frame.z.add(p.z());
  }
  for (const auto& window : input.windows)
    for (const auto& mark : window.marks) {
      touched.add(mark.p_V.x());
      force.add(mark.force.norm());
    }
  const double length = frame.x.high - frame.x.low, margin = 0.03 * length;
  constexpr double k_least_share = 0.4, k_decades = 1e-3;
  if (touched.low < touched.high)
    frame.x.low = std::max(frame.x.low, std::min(touched.low - margin, frame.x.high - k_least_share * length));
  if (force.high > 0) frame.strongest = force.high;
  frame.weakest = k_decades * frame.strongest;
  frame.x.low -= margin;
  frame.x.high += margin;
  for (Range* range : {&frame.y, &frame.z}) {
    const double width = range->high - range->low;
    range->low -= 0.12 * width;
    range->high += 0.12 * width;
  }
  return frame;
}

/// Lines that all rows share, and the marks of each.
std::string data_of(const ContactPictureInput& input) {
  std::string data;
  const std::vector<std::pair<const View*, std::string>> views{
      {&k_port, "port"}, {&k_plan, "plan"}, {&k_starboard, "starboard"}};
  for (const auto& [view, name] : views) {
    data += block("hull_" + name, segments(*view, visible_lines(input.hull, view->from)));
    for (std::size_t w = 0; w < input.windows.size(); ++w) {
      data += block(fmt::format("marks_{}_{}", name, w), marks(*view, input.windows[w]));
      const double level = input.water_level - input.windows[w].floating_level;
      data += block(fmt::format("water_{}_{}", name, w), segments(*view, waterline(input.hull, level)));
    }
  }
  for (std::size_t w = 0; w < input.floes.size(); ++w)
    data += block(fmt::format("floes_{}", w), outlines(k_plan, input.floes[w]));
  return data;
}

std::string panel(const ContactPictureInput& input, const Frame& frame, const std::string& name, std::size_t w) {
  const ContactWindow& window = input.windows[w];
  const bool plan = name == "plan", last = w + 1 == input.windows.size();
  const Range& up = plan ? frame.y : frame.z;
  const std::string x = name == "port" ? fmt::format("[{}:{}]", frame.x.high, frame.x.low)
                                       : fmt::format("[{}:{}]", frame.x.low, frame.x.high);
  std::string text = fmt::format("set xrange {}\nset yrange [{}:{}]\n", x, up.low, up.high);
  const std::string said =
      plan ? fmt::format("t = {:g} ± {:g} s: {} contacts; mean force x {:.2f}, y {:.2f}, z {:.2f} N", window.t,
                         window.half_width, window.marks.size(), window.mean_force.x(), window.mean_force.y(),
                         window.mean_force.z())
           : name + " side";
  text += fmt::format("set title \"{}\" offset 0,-0.6\nset xlabel '{}'\n", said, last ? "x [m]" : "");
  text += fmt::format("set ylabel '{}' offset 0.5,0\nset xtics 0.5\nset ytics 0.2\n", plan ? "y [m]" : "z [m]");
  text += "plot ";
  if (plan && !input.floes[w].empty()) {
    text += fmt::format("$floes_{} using 1:2 with filledcurves closed fc rgb '#dbeaf5' notitle, ", w);
    text += fmt::format("$floes_{} using 1:2 with lines lc rgb '#7fa6c4' lw 0.7 notitle, ", w);
  }
  text += fmt::format("$hull_{} using 1:2 with lines lc rgb '#333333' lw 1 notitle, ", name);
  text += fmt::format("$water_{}_{} using 1:2 with lines lc rgb '#2b6ca3' lw 1 dt 2 notitle", name, w);
  if (!window.marks.empty())
    text +=
        fmt::format(", $marks_{}_{} using 1:2:(0.35+0.9*sqrt($3/{})):3 with points pt 7 ps variable lc palette notitle",
                    name, w, frame.strongest);
  return text + "\n";
}

}  // namespace

std::string contact_picture_script(const ContactPictureInput& input) {
  const Frame frame = frame_of(input);
  constexpr int k_row_height = 230, k_head = 150, k_width = 1440;
  const int height = k_head + k_row_height * static_cast<int>(input.windows.size());
  std::string script = data_of(input);
  script += "set size ratio -1\nset tics font ',9' nomirror out\nset border 3 lc rgb '#888888'\nset key off\n";
  script += "set palette defined (0 '#440154', 1 '#3b528b', 2 '#21918c', 3 '#5ec962', 4 '#fde725')\n";
  script += fmt::format("set logscale cb\nset cbrange [{:g}:{:g}]\nset cblabel 'force of a contact [N]' offset 0,0.5\n",
                        frame.weakest, frame.strongest);
  for (const char* kind : {"svg", "png"}) {
    const bool vector = kind == std::string("svg");
    script += fmt::format("set terminal {} size {},{} font 'sans,{}' {}\nset output 'contacts.{}'\n",
                          vector ? "svg" : "pngcairo", k_width, height, 11, vector ? "background '#ffffff'" : "", kind);
    script += fmt::format(
        "set multiplot layout {},3 title \"{}\" noenhanced margins 0.055,0.985,{:.4f},{:.4f} spacing 0.06,{:.4f}\n",
        input.windows.size(), input.title, 125.0 / height, 1 - 60.0 / height, 60.0 / height);
    for (std::size_t w = 0; w < input.windows.size(); ++w)
      for (const char* name : {"port", "plan", "starboard"}) {
        const bool scale = w + 1 == input.windows.size() && name == std::string("plan");
        script += scale ? fmt::format("set colorbox horizontal user origin 0.36,{:.4f} size 0.28,{:.4f}\n",
                                      52.0 / height, 9.0 / height)
                        : "unset colorbox\n";
        script += panel(input, frame, name, w);
      }
    script += "unset multiplot\nunset output\n";
  }
  return script;
}

}  // namespace nilas
