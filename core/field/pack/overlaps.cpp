#include "core/field/pack/overlaps.h"

#include <algorithm>
#include <limits>
#include <numeric>

namespace nilas::field {

namespace {}  // namespace

std::vector<NearPair> near_pairs(const std::vector<LooseFloe>& floes, double scale, double distance) {
  std::vector<double> left(floes.size());
  for (std::size_t i = 0; i < floes.size(); ++i) left[i] = floes[i].centre.x() - scale * floes[i].radius;
  std::vector<int> order(floes.size());
  std::iota(order.begin(), order.end(), 0);
  std::sort(order.begin(), order.end(), [&](int i, int j) { return left[i] != left[j] ? left[i] < left[j] : i < j; });
  std::vector<NearPair> pairs;
  for (std::size_t k = 0; k < order.size(); ++k) {
    const LooseFloe& a = floes[order[k]];
    const double right = a.centre.x() + scale * a.radius + distance;
    for (std::size_t l = k + 1; l < order.size() && left[order[l]] < right; ++l) {
      const LooseFloe& b = floes[order[l]];
      const double reach = scale * (a.radius + b.radius) + distance;
      if ((a.centre - b.centre).squaredNorm() < reach * reach) pairs.push_back({order[k], order[l]});
    }
  }
  return pairs;
}

double beyond_edge(const ConvexOutline& outline, const FieldBounds& bounds) {
  double beyond = -std::numeric_limits<double>::infinity();
  for (const Vec2& corner : outline.corners)
    beyond = std::max({beyond, (corner - bounds.high).maxCoeff(), (bounds.low - corner).maxCoeff()});
  return beyond;
}

double deepest_overlap(const std::vector<LooseFloe>& floes, const FieldBounds& bounds) {
  const std::vector<ConvexOutline> outlines = placed_outlines(floes);
  double deepest = 0;
  for (const NearPair& pair : near_pairs(floes, 1, 0))
    deepest = std::max(deepest, -best_axis(outlines[pair.a], outlines[pair.b]).gap);
  for (std::size_t i = 0; i < floes.size(); ++i) {
    deepest = std::max(deepest, beyond_edge(outlines[i], bounds));
    for (const Obstacle& o : bounds.obstacles)
      if (is_near(o, floes[i].centre, floes[i].radius, 0))
        deepest = std::max(deepest, -best_axis(outlines[i], o.outline).gap);
  }
  return deepest;
}

}  // namespace nilas::field
