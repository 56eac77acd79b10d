#include "apps/report/contact_picture.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "apps/report/axis_ticks.h"
#include "apps/report/hull_lines.h"
#include "apps/report/templates.h"
#include "core/output/loads/ice_load_text.h"
#include "core/output/text/fill_template.h"

namespace nilas::report {

namespace {

std::string point(const View& view, const Vec3& p) { return fmt::format("{:.6g} {:.6g}", p[view.across], p[view.up]); }

using Json = nlohmann::ordered_json;

Json block(const std::string& name, const std::string& rows) { return {{"name", name}, {"rows", rows}}; }

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

/// Whether a view shows a mark. A mark that faces sideways, such as one on a hull's centre plane, shows on both sides.
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

/// The force of the strongest contact of all rows [N]; 1 N without contacts.
double strongest(const ContactPictureInput& input) {
  double force = 0;
  for (const auto& row : input.rows)
    for (const auto& mark : row.window.marks) force = std::max(force, mark.force.norm());
  return force > 0 ? force : 1;
}

constexpr int k_width = 1440, k_head = 96, k_foot = 160, k_above_row = 96;  // [px]
constexpr double k_left = 0.055, k_right = 0.985, k_gap = 0.055;            // of the width
constexpr double k_panel_width = k_width * (k_right - k_left - 2 * k_gap) / 3;

/// The height of a panel [px] at which the views fill their panels across, within limits.
double panel_height(const ContactPictureInput& input) {
  constexpr double k_lowest = 120, k_highest = 420;
  double height = k_lowest;
  for (const View& view : input.views) {
    const auto &across = input.frame.axes[view.across], &up = input.frame.axes[view.up];
    height = std::max(height, k_panel_width * up.width() / across.width());
  }
  return std::min(height, k_highest);
}

/// The step between the numbers of an axis that is `pixels` long. Each has `room` [px], and there are not too many.
double step_of_ticks(double length, double pixels, double room) {
  constexpr double k_most = 8;
  return tick_step(length, static_cast<int>(std::clamp(pixels / room, 2.0, k_most)));
}

/// The names of the data blocks of view v and row w.
std::string bodies_name(std::size_t v) { return fmt::format("bodies_{}", v); }
std::string marks_name(std::size_t v, std::size_t w) { return fmt::format("marks_{}_{}", v, w); }
std::string water_name(std::size_t v, std::size_t w) { return fmt::format("water_{}_{}", v, w); }
std::string floes_name(std::size_t w) { return fmt::format("floes_{}", w); }

/// The data blocks: the lines that all rows share, and the marks, waterlines and floes of each.
Json data_of(const ContactPictureInput& input, double unit) {
  Json data = Json::array();
  for (std::size_t v = 0; v < input.views.size(); ++v) {
    const View& view = input.views[v];
    std::string lines;
    for (const auto& mesh : input.bodies) lines += segments(view, visible_lines(mesh, view.from));
    data.push_back(block(bodies_name(v), lines));
    for (std::size_t w = 0; w < input.rows.size(); ++w) {
      const PictureRow& row = input.rows[w];
      data.push_back(block(marks_name(v, w), marks(view, row.window, unit)));
      std::string water;
      for (const auto& mesh : input.bodies)
        water += segments(view, waterline(mesh, input.water_level - row.window.floating_level));
      data.push_back(block(water_name(v, w), water));
      if (view.is_plan()) data.push_back(block(floes_name(w), outlines(view, row.floes)));
    }
  }
  return data;
}

/// The ranges, tics and labels of a panel's axes.
Json axes_of(const ContactPictureInput& input, std::size_t v, bool lowest, double height) {
  const View& view = input.views[v];
  const AxisExtent &across = input.frame.axes[view.across], &up = input.frame.axes[view.up];
  const double pixels_per_metre = std::min(k_panel_width / across.width(), height / up.width());
  const double spare = 0.5 * (k_panel_width / pixels_per_metre - across.width());  // room that the panel has left
  constexpr double k_room_across = 45, k_room_up = 18;                             // of a number [px]
  constexpr const char* k_axes = "xyz";
  const double low = across.low - spare, high = across.high + spare;
  return {{"x_low", view.reversed ? high : low},
          {"x_high", view.reversed ? low : high},
          {"y_low", up.low},
          {"y_high", up.high},
          {"x_step", step_of_ticks(across.width() + 2 * spare, k_panel_width, k_room_across)},
          {"y_step", step_of_ticks(up.width(), pixels_per_metre * up.width(), k_room_up)},
          {"x_label", lowest ? fmt::format("{} [m]", k_axes[view.across]) : ""},
          {"y_label", std::string(1, k_axes[view.up])}};
}

Json panel(const ContactPictureInput& input, std::size_t v, std::size_t w, double row_height, double height) {
  constexpr double k_scale_from_foot = 82, k_scale_height = 9;   // [px]
  constexpr double k_note_from_foot = 12, k_key_from_foot = 20;  // [px]
  const View& view = input.views[v];
  const PictureRow& row = input.rows[w];
  const bool lowest = w + 1 == input.rows.size();
  Json panel = axes_of(input, v, lowest, row_height);
  panel["heading"] = view.is_plan() ? fmt::format("t = {:g} ± {:g} s: {} contacts", row.window.t, row.window.half_width,
                                                  row.window.marks.size())
                                    : view.name;
  panel["loads"] = view.is_plan() ? row.loads : "";
  panel["floes"] = view.is_plan() && !row.floes.empty() ? floes_name(w) : "";
  panel["marks"] = row.window.marks.empty() ? "" : marks_name(v, w);
  panel["bodies"] = bodies_name(v);
  panel["water"] = water_name(v, w);
  panel["colour_scale"] = nullptr;
  if (lowest && view.is_plan())
    panel["colour_scale"] = {
        {"origin", k_scale_from_foot / height}, {"size", k_scale_height / height}, {"key", k_key_from_foot / height}};
  panel["left_out"] = nullptr;
  if (w == 0 && v == 0 && !input.frame.left_out.empty())  // every panel would draw it again
    panel["left_out"] = {{"text", input.frame.left_out}, {"place", k_note_from_foot / height}};
  return panel;
}

}  // namespace

std::string contact_picture_script(const ContactPictureInput& input) {
  constexpr double k_decades = 1e-3;
  const output::ForceUnit unit = output::force_unit(strongest(input));
  const double scale_end = strongest(input) / unit.size, row_height = panel_height(input);
  const auto rows = static_cast<double>(input.rows.size());
  const double height = k_head + k_foot + rows * row_height + (rows - 1) * k_above_row;
  Json formats = Json::array(), panels = Json::array();
  for (const bool vector : {true, false})
    formats.push_back({{"terminal", vector ? "svg" : "pngcairo"},
                       {"background", vector ? "#ffffff" : ""},
                       {"file", vector ? "contacts.svg" : "contacts.png"}});
  for (std::size_t w = 0; w < input.rows.size(); ++w)
    for (std::size_t v = 0; v < input.views.size(); ++v) panels.push_back(panel(input, v, w, row_height, height));
  const Json data{{"blocks", data_of(input, unit.size)},
                  {"force_low", k_decades * scale_end},
                  {"force_high", scale_end},
                  {"force_unit", unit.name},
                  {"formats", formats},
                  {"width", k_width},
                  {"height", std::lround(height)},
                  {"row_count", input.rows.size()},
                  {"view_count", input.views.size()},
                  {"title", input.title},
                  {"left", k_left},
                  {"right", k_right},
                  {"bottom", k_foot / height},
                  {"top", 1 - k_head / height},
                  {"gap_across", k_gap},
                  {"gap_up", k_above_row / height},
                  {"panels", panels}};
  return output::fill_template(report_template("contacts.gnuplot"), data, output::Escape::gnuplot);
}

}  // namespace nilas::report
