#include "core/field/pack/place_floes.h"

#include <algorithm>
#include <limits>

#include "core/field/pack/centre_grid.h"

namespace nilas::field {

namespace {

constexpr int k_candidates = 20;
/// Largest number of tries to find a place outside the obstacles; more would only be needed with almost no free area.
constexpr int k_most_tries = 10000;

bool is_inside(const Obstacle& obstacle, const Vec2& point) {
  const auto& [corners, normals] = obstacle.outline;
  for (std::size_t i = 0; i < corners.size(); ++i)
    if (normals[i].dot(point - corners[i]) > 0) return false;
  return true;
}

double circle_overlap(const std::vector<LooseFloe>& floes, const CentreGrid& grid, const Vec2& place, double radius) {
  double sum = 0;
  grid.visit_near(place, radius + floes.front().radius, [&](int j) {
    const LooseFloe& other = floes[j];
    const double depth = radius + other.radius - (place - other.centre).norm();
    if (depth > 0) sum += depth * depth;
  });
  return sum;
}

}  // namespace

Vec2 random_place(const FieldBounds& bounds, RandomStream& random) {
  Vec2 place = bounds.low;
  for (int k = 0; k < k_most_tries; ++k) {
    place = {random.uniform(bounds.low.x(), bounds.high.x()), random.uniform(bounds.low.y(), bounds.high.y())};
    const auto inside = [&](const Obstacle& o) { return is_inside(o, place); };
    if (std::none_of(bounds.obstacles.begin(), bounds.obstacles.end(), inside)) break;
  }
  return place;
}

void place_floes(std::vector<LooseFloe>& floes, const FieldBounds& bounds, RandomStream& random) {
  if (floes.empty()) return;
  CentreGrid grid(bounds.low, bounds.high, 2 * floes.front().radius);
  for (std::size_t i = 0; i < floes.size(); ++i) {
    LooseFloe& floe = floes[i];
    floe.angle = random.uniform(-k_pi, k_pi);
    double least = std::numeric_limits<double>::infinity();
    for (int k = 0; k < k_candidates; ++k) {
      const Vec2 place = random_place(bounds, random);
      const double overlap = circle_overlap(floes, grid, place, floe.radius);
      if (overlap >= least) continue;
      least = overlap;
      floe.centre = place;
    }
    grid.insert(static_cast<int>(i), floe.centre);
  }
}

}  // namespace nilas::field
