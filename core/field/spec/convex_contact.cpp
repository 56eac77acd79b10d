#include "core/field/spec/convex_contact.h"

#include <limits>

namespace nilas::field {

namespace {

int size_of(const ConvexOutline& outline) { return static_cast<int>(outline.corners.size()); }

/// Smallest signed distance of the corners of `other` from edge `edge` of `owner`.
double edge_gap(const ConvexOutline& owner, const ConvexOutline& other, std::size_t edge) {
  const double nx = owner.normals[edge].x(), ny = owner.normals[edge].y();
  double lowest = std::numeric_limits<double>::infinity();
  for (const Vec2& corner : other.corners) lowest = std::min(lowest, nx * corner.x() + ny * corner.y());
  return lowest - (nx * owner.corners[edge].x() + ny * owner.corners[edge].y());
}

/// Tries every edge normal of `owner`. The deepest corner of `other` turns with the normal, so it is followed, not
/// searched.
void keep_better_axis(const ConvexOutline& owner, const ConvexOutline& other, bool of_first, SeparatingAxis& best) {
  const std::size_t edges = owner.corners.size(), corners = other.corners.size();
  const auto height = [&](std::size_t edge, std::size_t corner) {
    return owner.normals[edge].x() * other.corners[corner].x() + owner.normals[edge].y() * other.corners[corner].y();
  };
  std::size_t deepest = 0;
  double depth = height(0, 0);
  for (std::size_t k = 1; k < corners; ++k) {
    const double h = height(0, k);
    if (h < depth) {
      depth = h;
      deepest = k;
    }
  }
  for (std::size_t edge = 0; edge < edges; ++edge) {
    depth = height(edge, deepest);
    for (std::size_t turns = 0; turns < corners; ++turns) {
      const std::size_t next = deepest + 1 == corners ? 0 : deepest + 1;
      const double h = height(edge, next);
      if (h >= depth) break;
      depth = h;
      deepest = next;
    }
    const Vec2& start = owner.corners[edge];
    const double gap = depth - (owner.normals[edge].x() * start.x() + owner.normals[edge].y() * start.y());
    if (gap > best.gap) best = {gap, static_cast<int>(edge), of_first};
  }
}

/// The edge of `other` that faces the normal most directly.
int incident_edge(const ConvexOutline& other, const Vec2& normal) {
  int best = 0;
  double lowest = std::numeric_limits<double>::infinity();
  for (int i = 0; i < size_of(other); ++i) {
    const double facing = other.normals[i].dot(normal);
    if (facing < lowest) {
      lowest = facing;
      best = i;
    }
  }
  return best;
}

}  // namespace

void fill_normals(ConvexOutline& outline) {
  const std::size_t n = outline.corners.size();
  outline.normals.resize(n);
  for (std::size_t i = 0; i < n; ++i) {
    const Vec2 edge = outline.corners[(i + 1) % n] - outline.corners[i];
    outline.normals[i] = Vec2(edge.y(), -edge.x()) / edge.norm();
  }
}

double gap_on_axis(const ConvexOutline& first, const ConvexOutline& second, int edge, bool of_first) {
  return of_first ? edge_gap(first, second, edge) : edge_gap(second, first, edge);
}

SeparatingAxis best_axis(const ConvexOutline& first, const ConvexOutline& second) {
  SeparatingAxis best;
  best.gap = -std::numeric_limits<double>::infinity();
  keep_better_axis(first, second, true, best);
  keep_better_axis(second, first, false, best);
  return best;
}

Touching touching_points(const ConvexOutline& first, const ConvexOutline& second, const SeparatingAxis& axis,
                         double reach) {
  const ConvexOutline& owner = axis.of_first ? first : second;
  const ConvexOutline& other = axis.of_first ? second : first;
  const Vec2& normal = owner.normals[axis.edge];
  const Vec2 along(-normal.y(), normal.x());
  const Vec2& start = owner.corners[axis.edge];
  const double length = along.dot(owner.corners[(axis.edge + 1) % size_of(owner)] - start);

  const int edge = incident_edge(other, normal);
  const Vec2 ends[2] = {other.corners[edge], other.corners[(edge + 1) % size_of(other)]};
  const double t[2] = {along.dot(ends[0] - start), along.dot(ends[1] - start)};
  const double low = std::min(t[0], t[1]), high = std::max(t[0], t[1]);

  const auto height = [&](const Vec2& point) { return normal.dot(point - start); };
  const int deepest = height(ends[0]) <= height(ends[1]) ? 0 : 1;

  Touching touching;
  touching.normal = axis.of_first ? normal : Vec2(-normal);
  for (int k = 0; k < 2; ++k) {
    if (low == high && k != deepest) continue;
    const double cut = std::clamp(std::clamp(t[k], 0.0, length), low, high);
    const Vec2 point = cut == t[k] ? ends[k] : ends[k] + (ends[1 - k] - ends[k]) * ((cut - t[k]) / (t[1 - k] - t[k]));
    // An overlap must not be missed when its deepest corner is outside the span of the reference edge.
    const double gap = k == deepest && axis.gap < 0 ? axis.gap : height(point);
    if (gap >= reach) continue;
    touching.point[touching.count] = point;
    touching.gap[touching.count] = gap;
    ++touching.count;
  }
  return touching;
}

}  // namespace nilas::field
