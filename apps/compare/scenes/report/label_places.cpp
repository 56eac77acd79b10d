#include "apps/compare/scenes/report/label_places.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>

namespace nilas::compare {

namespace {

/// In widths of a letter: the height of a label, the half size of a mark, the distances of labels from marks.
constexpr double k_label_height = 1.8, k_half_mark = 0.8;
constexpr std::array k_rings{1.9, 2.7, 3.8, 5.2, 7.0};
/// Directions [deg], those to be preferred first.
constexpr std::array k_directions{40.0, -40.0, 0.0, 90.0, -90.0, 180.0, 140.0, -140.0, 65.0, -65.0, 115.0, -115.0};
constexpr double k_cover_cost = 10, k_bar_cost = 4, k_bar = 0.3, k_gap = 1, k_distance_cost = 0.2, k_outside_cost = 1e4;

struct Box {
  double left, right, bottom, top;
};

Box box_at(double x, double y, double width, double height) {
  return {x - width / 2, x + width / 2, y - height / 2, y + height / 2};
}

double common_area(const Box& a, const Box& b) {
  const double wide = std::min(a.right, b.right) - std::max(a.left, b.left),
               high = std::min(a.top, b.top) - std::max(a.bottom, b.bottom);
  return wide > 0 && high > 0 ? wide * high : 0;
}

}  // namespace

std::vector<LabelPlace> place_labels(const std::vector<LabelledMark>& marks, double width, double height) {
  std::vector<Box> taken, bars;
  for (const auto& mark : marks) {
    taken.push_back(box_at(mark.x, mark.y, 2 * k_half_mark, 2 * k_half_mark));
    bars.push_back({mark.left, mark.right, mark.y - k_bar / 2, mark.y + k_bar / 2});
    bars.push_back({mark.x - k_bar / 2, mark.x + k_bar / 2, mark.low, mark.high});
  }
  std::vector<LabelPlace> places;
  for (const auto& mark : marks) {
    double least = std::numeric_limits<double>::infinity();
    LabelPlace best;
    Box best_box{};
    for (const double ring : k_rings)
      for (const double direction : k_directions) {
        const double angle = direction * std::numbers::pi / 180;
        const double x = mark.x + ring * std::cos(angle), y = mark.y + ring * std::sin(angle);
        const Box box = box_at(x, y, static_cast<double>(mark.letters) + k_gap, k_label_height);
        const bool outside = box.left < 0 || box.right > width || box.bottom < 0 || box.top > height;
        double cost = k_distance_cost * ring + (outside ? k_outside_cost : 0);
        for (const Box& other : taken) cost += k_cover_cost * common_area(box, other);
        for (const Box& bar : bars) cost += k_bar_cost * common_area(box, bar);
        if (!(cost < least)) continue;
        least = cost;
        const double line = ring - k_rings[0] + k_half_mark;
        best = {x, y, ring > k_rings[1], mark.x + line * std::cos(angle), mark.y + line * std::sin(angle)};
        best_box = box;
      }
    places.push_back(best);
    taken.push_back(best_box);
  }
  return places;
}

}  // namespace nilas::compare
