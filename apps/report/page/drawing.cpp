#include "apps/report/page/drawing.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "core/output/text/html.h"

namespace nilas::report {

namespace {

constexpr double k_pixels = 1000;  ///< width of a drawing in its own units
constexpr std::size_t k_most_floes = 4000;

class Canvas {
 public:
  explicit Canvas(const DrawnArea& area) : area_(area), scale_(k_pixels / (area.high.x() - area.low.x())) {}

  double height() const { return scale_ * (area_.high.y() - area_.low.y()); }
  double scale() const { return scale_; }
  std::string point(const Vec2& p) const {
    return fmt::format("{:.1f} {:.1f}", scale_ * (p.x() - area_.low.x()), scale_ * (area_.high.y() - p.y()));
  }
  bool shows(const std::vector<Vec2>& outline) const {
    Vec2 low = outline.front(), high = low;
    for (const Vec2& p : outline) {
      low = low.cwiseMin(p);
      high = high.cwiseMax(p);
    }
    return (high.array() >= area_.low.array()).all() && (low.array() <= area_.high.array()).all();
  }
  std::string closed(const std::vector<Vec2>& outline) const {
    std::string path;
    for (const Vec2& p : outline) path += (path.empty() ? "M" : "L") + point(p);
    return path + "Z";
  }
  std::string line(const std::array<Vec2, 2>& segment) const {
    return "M" + point(segment[0]) + "L" + point(segment[1]);
  }

 private:
  DrawnArea area_;
  double scale_;
};

std::string path_element(const char* kind, const std::string& path) {
  return path.empty() ? "" : fmt::format("<path class=\"{}\" d=\"{}\"/>", kind, path);
}

double size_of(const std::vector<Vec2>& outline) {
  double twice = 0;
  for (std::size_t k = 0; k < outline.size(); ++k) twice += cross2(outline[k], outline[(k + 1) % outline.size()]);
  return std::abs(twice);
}

/// A length of 1, 2 or 5 times a power of ten, at most a quarter of the width [m].
double scale_length(double width) {
  const double power = std::pow(10, std::floor(std::log10(0.25 * width)));
  double length = power;
  for (const double step : {2.0, 5.0})
    if (step * power <= 0.25 * width) length = step * power;
  return length;
}

}  // namespace

std::string svg_drawing(const DrawnShapes& shapes, const DrawnArea& area, const std::string& label) {
  const Canvas canvas(area);
  std::vector<const std::vector<Vec2>*> floes;
  for (const auto& outline : shapes.ice)
    if (outline.size() > 1 && canvas.shows(outline)) floes.push_back(&outline);
  if (floes.size() > k_most_floes) {
    std::stable_sort(floes.begin(), floes.end(),
                     [](const auto* a, const auto* b) { return size_of(*a) > size_of(*b); });
    floes.resize(k_most_floes);
  }
  std::string ice, hull, water, tank, culprits, marks;
  for (const auto& outline : shapes.culprits) culprits += canvas.closed(outline);
  for (const auto* outline : floes) ice += canvas.closed(*outline);
  for (const auto& line : shapes.hull) hull += canvas.line(line);
  for (const auto& line : shapes.water) water += canvas.line(line);
  for (const auto& outline : shapes.tank) tank += canvas.closed(outline);
  for (const Vec2& mark : shapes.marks) {
    const std::string at = canvas.point(mark);
    const auto blank = at.find(' ');
    const std::string x = at.substr(0, blank), y = at.substr(blank + 1);
    marks += fmt::format("<circle class=\"mark\" cx=\"{}\" cy=\"{}\" r=\"9\"/>", x, y);
    if (shapes.mark_name.empty()) continue;
    // Beside the mark, on the side with more room.
    const bool is_right = mark.x() > 0.5 * (area.low.x() + area.high.x());
    marks +=
        fmt::format("<text class=\"mark-name\" x=\"{}\" y=\"{}\" dx=\"{}\" dy=\"-16\" text-anchor=\"{}\">{}</text>", x,
                    y, is_right ? -14 : 14, is_right ? "end" : "start", output::html_text(shapes.mark_name));
  }
  const double length = scale_length(area.high.x() - area.low.x()), foot = canvas.height() - 20;
  return fmt::format("<svg class=\"drawing\" viewBox=\"0 0 {:.0f} {:.0f}\" role=\"img\" aria-label=\"{}\">", k_pixels,
                     canvas.height(), output::html_text(label)) +
         path_element("tank", tank) + path_element("ice", ice) + path_element("culprit", culprits) +
         path_element("waterline", water) + path_element("hull", hull) + marks +
         fmt::format("<path class=\"scale\" d=\"M20 {:.1f}h{:.1f}\"/><text x=\"20\" y=\"{:.1f}\">{:g} m</text></svg>",
                     foot, canvas.scale() * length, foot - 14, length);
}

}  // namespace nilas::report
