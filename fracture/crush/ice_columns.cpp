#include "fracture/crush/ice_columns.h"

#include <algorithm>
#include <cmath>

#include "core/geometry/mass_properties.h"
#include "core/geometry/polygon.h"

namespace nilas::fracture {

namespace {

/// The normals of a face and of a piece of it agree within this sine of the angle between them [-].
constexpr double k_same_normal = 1e-6;
/// A normal counts as vertical where its horizontal part is below this: the rounding of a turned frame [-].
constexpr double k_level = 1e-12;

/// The part of a polygon where n . x <= offset. Pairs of opposite edges join it where it has several pieces.
std::vector<Vec2> clipped(const std::vector<Vec2>& polygon, const Vec2& n, double offset) {
  std::vector<Vec2> kept;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const Vec2 &a = polygon[i], &b = polygon[(i + 1) % polygon.size()];
    const double above_a = n.dot(a) - offset, above_b = n.dot(b) - offset;
    if (above_a <= 0) kept.push_back(a);
    if ((above_a < 0 && above_b > 0) || (above_a > 0 && above_b < 0))
      kept.emplace_back(a + above_a / (above_a - above_b) * (b - a));
  }
  return kept;
}

/// The common part of an outline and a convex polygon.
std::vector<Vec2> common_part(std::vector<Vec2> outline, const std::vector<Vec2>& convex) {
  for (std::size_t i = 0; i < convex.size() && !outline.empty(); ++i) {
    const Vec2 edge = convex[(i + 1) % convex.size()] - convex[i];
    const Vec2 n(edge.y(), -edge.x());
    outline = clipped(outline, n, n.dot(convex[i]));
  }
  return outline;
}

double common_area(const std::vector<std::vector<Vec2>>& polygons, const std::vector<Vec2>& outline) {
  double area = 0;
  for (const auto& polygon : polygons) area += geometry::polygon_moments(common_part(outline, polygon)).area;
  return area;
}

}  // namespace

/// Counts the overlap of two polygons once. Where more than two overlap, the sum is a little too small.
ColumnArea column_area(const std::vector<std::vector<Vec2>>& columns, const std::vector<Vec2>& outline) {
  ColumnArea sum;
  const auto add = [&](const std::vector<Vec2>& column, double sign) {
    const geometry::PolygonMoments within = geometry::polygon_moments(common_part(outline, column));
    sum.area += sign * within.area;
    sum.outside += sign * (geometry::polygon_moments(column).area - within.area);
    sum.centroid += sign * within.area * within.centroid;
  };
  for (std::size_t k = 0; k < columns.size(); ++k) {
    add(columns[k], 1);
    for (std::size_t j = 0; j < k; ++j)
      if (const auto both = common_part(columns[k], columns[j]); both.size() >= 3) add(both, -1);
  }
  if (sum.area > 0) sum.centroid /= sum.area;
  return sum;
}

std::vector<std::vector<std::vector<Vec2>>> connected(const std::vector<std::vector<Vec2>>& columns) {
  std::vector<std::vector<std::vector<Vec2>>> groups;
  for (const auto& column : columns) {
    std::vector<std::vector<Vec2>> joined{column};
    for (auto& group : groups) {
      if (std::none_of(group.begin(), group.end(),
                       [&](const auto& other) { return geometry::convex_overlap(column, other) > 0; }))
        continue;
      joined.insert(joined.end(), group.begin(), group.end());
      group.clear();
    }
    std::erase_if(groups, [](const auto& group) { return group.empty(); });
    groups.push_back(std::move(joined));
  }
  return groups;
}

int times_inside(const std::vector<Vec2>& column, const std::vector<Vec2>& outline) {
  int times = 0;
  for (std::size_t i = 0; i < outline.size(); ++i) {
    const Vec2 &a = outline[i], along = outline[(i + 1) % outline.size()] - a;
    double from = 0, to = 1;
    for (std::size_t k = 0; k < column.size(); ++k) {
      const Vec2 edge = column[(k + 1) % column.size()] - column[k];
      const Vec2 n(edge.y(), -edge.x());
      const double above = n.dot(a - column[k]), rises = n.dot(along);
      if (rises == 0 && above >= 0) to = 0;
      if (rises > 0) to = std::min(to, -above / rises);
      if (rises < 0) from = std::max(from, -above / rises);
    }
    if (from > 0 && from < to) ++times;
  }
  return times;
}

bool trim_corners(std::vector<Vec2>& outline, std::vector<bool>& is_new, double least, double size) {
  constexpr double k_straight = 1e-9;
  std::vector<Vec2> kept = outline;
  std::vector<bool> fresh = is_new;
  for (std::size_t i = 0, unseen = kept.size(); unseen > 0 && kept.size() > 3;) {
    const std::size_t n = kept.size(), last = (i + n - 1) % n, next = (i + 1) % n;
    const Vec2 chord = kept[next] - kept[last], arm = kept[i] - kept[last];
    const double out =
        (arm.x() * chord.y() - arm.y() * chord.x()) / chord.norm();  // distance by which the corner sticks out [m]
    if (!(fresh[last] || fresh[i]) || !(std::abs(out) <= k_straight * size || (out > 0 && out < least))) {
      i = next;
      --unseen;
      continue;
    }
    fresh[last] = true;
    kept.erase(kept.begin() + static_cast<std::ptrdiff_t>(i));
    fresh.erase(fresh.begin() + static_cast<std::ptrdiff_t>(i));
    i = (i + kept.size() - 1) % kept.size();  // the corner before it has a new edge, so that it is judged again
    unseen = kept.size();
  }
  if (kept.size() == outline.size() || !geometry::is_simple(kept)) return false;
  outline = std::move(kept);
  is_new = std::move(fresh);
  return true;
}

bool is_squeezed_out(const CrushedIce& ice, const std::vector<Vec2>& piece) {
  constexpr double k_most = 0.5, k_all = 1 - 1e-6;  // thresholds for a piece that is in or out as a whole
  const double area = geometry::polygon_moments(piece).area;
  return common_area(ice.columns, piece) > k_most * area || common_area(ice.sections, piece) > k_all * area;
}

std::vector<Vec2> columns_inside(const geometry::ConvexPolytope& part, const std::vector<char>& is_outer,
                                 const Placement& hull_in_floe, double thickness, double strip, const Vec2& low,
                                 const Vec2& high) {
  std::vector<Vec2> polygon{low, {high.x(), low.y()}, high, {low.x(), high.y()}};
  for (std::size_t f = 0; f < part.normals.size() && polygon.size() >= 3; ++f) {
    const Vec3 n = hull_in_floe.R * part.normals[f];
    const Vec2 plan = n.head<2>();
    // The end of the column that is nearest to an outer face decides.
    const double middle = part.offsets[f] + n.dot(hull_in_floe.p), half = 0.5 * thickness * std::abs(n.z());
    if (plan.norm() <= k_level) {
      if (middle < half) return {};
      continue;
    }
    polygon =
        clipped(polygon, plan, is_outer[f] ? middle - half - strip * plan.norm() : middle + half + strip * plan.norm());
  }
  return polygon.size() >= 3 ? polygon : std::vector<Vec2>();
}

std::vector<std::vector<char>> outer_faces(const std::vector<geometry::ConvexPolytope>& parts,
                                           const std::vector<HullFace>& faces) {
  std::vector<std::vector<char>> outer;
  for (const geometry::ConvexPolytope& part : parts) outer.emplace_back(part.normals.size(), 0);
  for (const HullFace& face : faces) {
    const auto k = static_cast<std::size_t>(face.part);
    for (std::size_t f = 0; f < parts[k].normals.size(); ++f)
      if (parts[k].normals[f].cross(face.normal).norm() < k_same_normal && parts[k].normals[f].dot(face.normal) > 0)
        outer[k][f] = 1;
  }
  return outer;
}

}  // namespace nilas::fracture
