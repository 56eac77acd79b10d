#include "apps/compare/scenes/report/front_picture.h"

#include <fmt/format.h>

#include <map>

#include "apps/compare/scenes/report/front_points.h"
#include "apps/compare/scenes/report/label_places.h"
#include "apps/compare/scenes/report/scene_report.h"
#include "apps/compare/workshop/json_store.h"

namespace nilas::compare {

namespace {

/// The plot within the picture, which front.gnuplot sets too: shares of its width and height.
constexpr double k_left = 0.097, k_right = 0.5625, k_bottom = 0.107, k_top = 0.967;
constexpr double k_letter_px = 7.6;  // width of a digit at the size of the picture's letters

/// The bars of the times that are known to scatter, and their ends.
std::string time_bars(const std::vector<FrontPoint>& points) {
  std::string rows;
  for (const auto& point : points)
    if (point.time_scatters())
      rows += fmt::format("{} {} {} {}\n", point.merit->time, point.error, point.shortest(), point.longest());
  return rows;
}

/// The order in which labels get their places: the recommended setting, those that none beats, and the others.
int label_rank(const FrontPoint& point, const Findings& found) {
  const Merit& m = *point.merit;
  if (found.choice.chosen == m.setting) return 0;
  if (m.significant && in_key(m, found)) return 1;
  return m.significant ? 3 : 2;
}

/// The numbers at their places, in layers by their colours, and the lines to those far from their marks.
Json number_layers(const Front& front, const Findings& found, const Picture& picture) {
  const double width = (k_right - k_left) * picture.width / k_letter_px,
               height = (k_top - k_bottom) * picture.height / k_letter_px;
  std::vector<const FrontPoint*> order;
  for (const auto& point : front.points) order.push_back(&point);
  std::stable_sort(order.begin(), order.end(), [&](const FrontPoint* a, const FrontPoint* b) {
    return label_rank(*a, found) < label_rank(*b, found);
  });
  std::vector<LabelledMark> marks;
  const auto across = [&](double time) { return width * front.time.share(time); };
  const auto up = [&](double error) { return height * front.error.share(error); };
  for (const auto* point : order) {
    LabelledMark mark{across(point->merit->time), up(point->error), std::to_string(point->merit->setting + 1).size()};
    if (point->time_scatters()) {
      mark.left = across(point->shortest());
      mark.right = across(point->longest());
    }
    mark.low = up(point->lowest());
    mark.high = up(point->highest());
    marks.push_back(mark);
  }
  const auto places = place_labels(marks, width, height);
  std::map<std::string, std::string> rows{{"#000000", ""}, {"#888888", ""}, {"#0072b2", ""}};
  std::string leaders;
  for (std::size_t k = 0; k < order.size(); ++k) {
    const Merit& m = *order[k]->merit;
    const auto at_x = [&](double x) { return front.time.at_share(x / width); };
    const auto at_y = [&](double y) { return front.error.at_share(y / height); };
    rows[!m.significant     ? "#0072b2"
         : in_key(m, found) ? "#000000"
                            : "#888888"] +=
        fmt::format("{} {} \"{}\"\n", at_x(places[k].x), at_y(places[k].y), m.setting + 1);
    if (places[k].far)
      leaders += fmt::format("{} {}\n{} {}\n\n", m.time, order[k]->error, at_x(places[k].end_x), at_y(places[k].end_y));
  }
  Json layers = Json::array();
  for (const auto& [colour, text] : rows)
    if (!text.empty())
      layers.push_back({{"name", fmt::format("numbers{}", layers.size())}, {"rows", text}, {"colour", colour}});
  return {{"numbers", layers}, {"leaders", leaders}};
}

}  // namespace

Json number_if(bool known, double value) { return known ? Json(value) : Json(nullptr); }

void add_axis(const std::string& name, const LogAxis& axis, Json& data) {
  std::string tics;
  for (const double tic : axis.tics) tics += fmt::format("{}{}", tics.empty() ? "" : ", ", tic);
  data[name + "_low"] = axis.low;
  data[name + "_high"] = axis.high;
  data[name + "_tics"] = tics;
}

std::optional<Picture> front_picture(const std::string& name, const Findings& found,
                                     const std::vector<std::string>& labels) {
  const std::optional<Front> front = front_of(found);
  if (!front) return std::nullopt;
  std::map<std::string, std::string> blocks{{"best", ""}, {"beaten", ""}, {"hidden", ""}, {"chosen", ""}};
  Json names = Json::array();
  for (const auto& point : front->points) {
    const Merit& m = *point.merit;
    const std::string row = fmt::format("{} {} {} {}\n", m.time, point.error, point.lowest(), point.highest());
    blocks[!m.significant ? "hidden" : m.dominated ? "beaten" : "best"] += row;
    if (found.choice.chosen == m.setting) blocks["chosen"] += row;
    if (in_key(m, found)) names.push_back(fmt::format("{}  {}", m.setting + 1, labels[m.setting]));
  }
  Picture picture{.name = name, .script = "front.gnuplot", .data = Json(blocks)};
  Json& data = picture.data;
  data["left"] = k_left;
  data["right"] = k_right;
  data["bottom"] = k_bottom;
  data["top"] = k_top;
  data["bars"] = time_bars(front->points);
  data["time_scatter"] = percent_text(found.time_spread);
  add_axis("x", front->time, data);
  add_axis("y", front->error, data);
  data.update(number_layers(*front, found, picture));
  data["names"] = names;
  data["quantity"] = quantity_of(found.measure);
  data["unit"] = found.measure.unit;
  data["reference_moves"] = number_if(front->reference_moves.has_value(), front->reference_moves.value_or(0));
  return picture;
}

}  // namespace nilas::compare
