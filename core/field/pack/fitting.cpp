#include "core/field/pack/fitting.h"

#include <algorithm>
#include <cmath>

#include "core/field/pack/overlaps.h"
#include "core/field/spec/keep_out.h"
#include "core/geometry/mass_properties.h"

namespace nilas::field {

namespace {

constexpr double k_largest_growth = 0.5;  ///< largest growth of the scale before a floe is cut to its cell
constexpr int k_halvings = 12;  ///< bisections for the scale; the remaining error of 1e-4 is corrected by with_area
constexpr double k_area_tolerance = 1e-9;   ///< relative: a floe that its cell cuts by less keeps its outline
constexpr double k_smallest_corner = 1e-3;  ///< smallest area of a corner, as a share of the floe
constexpr double k_smallest_rest = 0.5;     ///< smallest share of a floe's area that a round of cuts may leave
constexpr double k_largest_radius = 1;      ///< radius limit of a fitted floe, in floe sizes: a side ratio of 1 : 3.7
constexpr double k_chamfer = 0.25;          ///< share of the shorter edge that a new corner takes

/// Area of the triangle of corner i and its neighbours.
double corner_area(const std::vector<Vec2>& outline, std::size_t i) {
  const std::size_t n = outline.size();
  const Vec2 in = outline[i] - outline[(i + n - 1) % n], out = outline[(i + 1) % n] - outline[i];
  return 0.5 * (in.x() * out.y() - in.y() * out.x());
}

std::size_t flattest_corner(const std::vector<Vec2>& outline) {
  std::size_t flattest = 0;
  for (std::size_t i = 1; i < outline.size(); ++i)
    if (corner_area(outline, i) < corner_area(outline, flattest)) flattest = i;
  return flattest;
}

std::size_t sharpest_corner(const std::vector<Vec2>& outline) {
  const std::size_t n = outline.size();
  const auto cosine_of_turn = [&](std::size_t i) {
    return (outline[i] - outline[(i + n - 1) % n]).normalized().dot((outline[(i + 1) % n] - outline[i]).normalized());
  };
  std::size_t sharpest = 0;
  for (std::size_t i = 1; i < n; ++i)
    if (cosine_of_turn(i) < cosine_of_turn(sharpest)) sharpest = i;
  return sharpest;
}

void drop_corners(std::vector<Vec2>& outline, double area, const FittingLimits& limits) {
  while (true) {
    const std::size_t i = flattest_corner(outline);
    const int count = static_cast<int>(outline.size());
    const bool needless = count > limits.vertices_min && corner_area(outline, i) < k_smallest_corner * area;
    if (count <= limits.vertices_max && !needless) return;
    outline.erase(outline.begin() + static_cast<std::ptrdiff_t>(i));
  }
}

void add_corners(std::vector<Vec2>& outline, const FittingLimits& limits) {
  while (static_cast<int>(outline.size()) < limits.vertices_min) {
    const std::size_t i = sharpest_corner(outline), n = outline.size();
    const Vec2 corner = outline[i];
    const Vec2 back = outline[(i + n - 1) % n] - corner, ahead = outline[(i + 1) % n] - corner;
    const double length = k_chamfer * std::min(back.norm(), ahead.norm());
    outline[i] = corner + length * back.normalized();
    outline.insert(outline.begin() + static_cast<std::ptrdiff_t>(i) + 1, corner + length * ahead.normalized());
  }
}

/// The side of a line on which a floe stays: normal . x <= offset.
struct HalfPlane {
  Vec2 normal;
  double offset;
};

class Fitter {
 public:
  Fitter(std::vector<LooseFloe>& floes, const FieldBounds& bounds, const FittingLimits& limits)
      : floes_(floes), bounds_(bounds), limits_(limits), outlines_(placed_outlines(floes)), cells_(floes.size()) {}

  std::vector<std::size_t> run() {
    double largest = 0;
    for (const LooseFloe& floe : floes_) largest = std::max(largest, floe.radius);
    for (const NearPair& pair : near_pairs(floes_, 1, k_largest_growth * largest)) divide(pair.a, pair.b);
    for (std::size_t i = 0; i < floes_.size(); ++i) bound(static_cast<int>(i));
    std::vector<std::size_t> changed;
    for (std::size_t i = 0; i < floes_.size(); ++i)
      if (fit(i)) changed.push_back(i);
    return changed;
  }

 private:
  double size(int floe) const { return std::sqrt(floes_[floe].area); }

  /// Adds the line between two floes, on the axis of their largest separation. It divides the gap or overlap in
  /// proportion to their sizes.
  void divide(int a, int b) {
    const SeparatingAxis axis = best_axis(outlines_[a], outlines_[b]);
    if (axis.gap > k_largest_growth * (size(a) + size(b))) return;
    const int below = axis.of_first ? a : b, above = axis.of_first ? b : a;
    const ConvexOutline& owner = outlines_[below];
    const Vec2 normal = owner.normals[axis.edge];
    const double share = size(below) / (size(below) + size(above));
    const double line = normal.dot(owner.corners[axis.edge]) + (axis.gap - limits_.gap) * share;
    cells_[below].push_back({normal, line});
    cells_[above].push_back({-normal, -line - limits_.gap});
  }

  void bound(int a) {
    auto& cell = cells_[a];
    cell.push_back({Vec2::UnitX(), bounds_.high.x() - limits_.gap});
    cell.push_back({-Vec2::UnitX(), -bounds_.low.x() - limits_.gap});
    cell.push_back({Vec2::UnitY(), bounds_.high.y() - limits_.gap});
    cell.push_back({-Vec2::UnitY(), -bounds_.low.y() - limits_.gap});
    const LooseFloe& floe = floes_[a];
    for (const Obstacle& o : bounds_.obstacles) {
      if (!is_near(o, floe.centre, floe.radius, k_largest_growth * size(a))) continue;
      const SeparatingAxis axis = best_axis(outlines_[a], o.outline);
      const ConvexOutline& owner = axis.of_first ? outlines_[a] : o.outline;
      const Vec2 normal = owner.normals[axis.edge];
      const double edge = normal.dot(owner.corners[axis.edge]);
      if (axis.of_first)
        cell.push_back({normal, edge + axis.gap - limits_.gap});
      else
        cell.push_back({-normal, -edge - limits_.gap});
    }
  }

  /// The floe scaled about its centroid and cut to its cell, with a number of corners in range.
  std::vector<Vec2> grown(std::size_t i, double scale) const {
    std::vector<Vec2> outline = outlines_[i].corners;
    for (Vec2& corner : outline) corner = floes_[i].centre + scale * (corner - floes_[i].centre);
    for (const HalfPlane& side : cells_[i]) outline = cut_outline(outline, side.normal, side.offset);
    if (outline.empty()) return outline;
    limit_corners(outline, floes_[i].area, limits_);
    return outline;
  }

  bool fit(std::size_t i) {
    LooseFloe& floe = floes_[i];
    const auto area = [](const std::vector<Vec2>& outline) {
      return outline.empty() ? 0 : geometry::polygon_moments(outline).area;
    };
    double low = 1, high = 1 + k_largest_growth;
    if (area(grown(i, low)) >= floe.area * (1 - k_area_tolerance)) return false;
    for (int k = 0; k < k_halvings; ++k) {
      const double middle = 0.5 * (low + high);
      (area(grown(i, middle)) < floe.area ? low : high) = middle;
    }
    std::vector<Vec2> outline = grown(i, high);
    // a small floe that would lose most of its area keeps its outline in this round
    if (area(outline) < k_smallest_rest * floe.area) return false;
    const LooseFloe fitted = with_area(loose_floe(std::move(outline)), floe.area);
    // a floe pressed from two sides only would become a needle
    if (fitted.radius > std::max(floe.radius, k_largest_radius * std::sqrt(floe.area))) return false;
    floe = fitted;
    return true;
  }

  std::vector<LooseFloe>& floes_;
  const FieldBounds& bounds_;
  const FittingLimits& limits_;
  std::vector<ConvexOutline> outlines_;
  std::vector<std::vector<HalfPlane>> cells_;  ///< region that each floe may fill; the cells do not overlap
};

}  // namespace

void limit_corners(std::vector<Vec2>& outline, double area, const FittingLimits& limits) {
  drop_corners(outline, area, limits);
  add_corners(outline, limits);
}

std::vector<std::size_t> fit_outlines(std::vector<LooseFloe>& floes, const FieldBounds& bounds,
                                      const FittingLimits& limits) {
  return Fitter(floes, bounds, limits).run();
}

}  // namespace nilas::field
