/// Includes CGAL, whose kernels need directed rounding: see core/CMakeLists.txt.
#include "core/field/shapes/power_diagram.h"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Regular_triangulation_2.h>
#include <CGAL/Triangulation_vertex_base_with_info_2.h>

#include <algorithm>
#include <limits>

#include "core/geometry/mass_properties.h"

namespace nilas::field {

namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using VertexBase =
    CGAL::Triangulation_vertex_base_with_info_2<int, Kernel, CGAL::Regular_triangulation_vertex_base_2<Kernel>>;
using Triangles = CGAL::Triangulation_data_structure_2<VertexBase, CGAL::Regular_triangulation_face_base_2<Kernel>>;
using Triangulation = CGAL::Regular_triangulation_2<Kernel, Triangles>;

struct Neighbours {
  std::vector<std::vector<int>> of;  ///< sorted, so that they do not depend on the triangulation's history
  std::vector<bool> hidden;          ///< sites without a cell
};

Neighbours neighbours(const PowerSites& sites) {
  std::vector<std::pair<Triangulation::Weighted_point, int>> points;
  for (std::size_t i = 0; i < sites.points.size(); ++i) {
    const Vec2& p = sites.points[i];
    points.emplace_back(Triangulation::Weighted_point({p.x(), p.y()}, sites.weights[i]), static_cast<int>(i));
  }
  const Triangulation triangulation(points.begin(), points.end());
  Neighbours found{std::vector<std::vector<int>>(points.size()), std::vector<bool>(points.size(), true)};
  for (auto v = triangulation.finite_vertices_begin(); v != triangulation.finite_vertices_end(); ++v)
    found.hidden[v->info()] = false;
  for (auto e = triangulation.finite_edges_begin(); e != triangulation.finite_edges_end(); ++e) {
    const int a = e->first->vertex(Triangulation::ccw(e->second))->info();
    const int b = e->first->vertex(Triangulation::cw(e->second))->info();
    found.of[a].push_back(b);
    found.of[b].push_back(a);
  }
  for (auto& list : found.of) std::sort(list.begin(), list.end());
  return found;
}

/// Cuts a cell to normal . x <= offset; the new edge borders on `site`.
void cut(PowerCell& cell, const Vec2& normal, double offset, int site) {
  PowerCell kept;
  const std::size_t n = cell.outline.size();
  for (std::size_t k = 0; k < n; ++k) {
    const Vec2 &a = cell.outline[k], &b = cell.outline[(k + 1) % n];
    const double ha = normal.dot(a) - offset, hb = normal.dot(b) - offset;
    if (ha <= 0) {
      kept.outline.push_back(a);
      kept.beyond.push_back(ha == 0 && hb > 0 ? site : cell.beyond[k]);
    }
    if ((ha < 0 && hb > 0) || (ha > 0 && hb < 0)) {
      kept.outline.push_back(a + (b - a) * (ha / (ha - hb)));
      kept.beyond.push_back(ha < 0 ? site : cell.beyond[k]);
    }
  }
  if (kept.outline.size() < 3) kept = {};
  cell = std::move(kept);
}

void cut_by_obstacle(PowerCell& cell, const Vec2& point, const ConvexOutline& obstacle) {
  std::size_t edge = 0;
  double furthest = -std::numeric_limits<double>::infinity();
  for (std::size_t k = 0; k < obstacle.corners.size(); ++k) {
    const double distance = obstacle.normals[k].dot(point - obstacle.corners[k]);
    if (distance <= furthest) continue;
    furthest = distance;
    edge = k;
  }
  bool meets = false;
  const Vec2& normal = obstacle.normals[edge];
  const double offset = normal.dot(obstacle.corners[edge]);
  for (const Vec2& corner : cell.outline) meets = meets || normal.dot(corner) < offset;
  if (meets) cut(cell, -normal, -offset, -1);
}

bool boxes_meet(const std::vector<Vec2>& outline, const Obstacle& obstacle) {
  Vec2 low = outline.front(), high = low;
  for (const Vec2& corner : outline) {
    low = low.cwiseMin(corner);
    high = high.cwiseMax(corner);
  }
  return (low.array() < obstacle.high.array()).all() && (high.array() > obstacle.low.array()).all();
}

PowerCell cell_of(int i, const std::vector<int>& near, const PowerSites& sites, const FieldBounds& bounds) {
  PowerCell cell{{bounds.low, {bounds.high.x(), bounds.low.y()}, bounds.high, {bounds.low.x(), bounds.high.y()}},
                 {-1, -1, -1, -1}};
  const Vec2& p = sites.points[i];
  for (const int j : near) {
    const Vec2 way = sites.points[j] - p;
    const double distance = way.norm();
    const double shift = 0.5 * (distance + (sites.weights[i] - sites.weights[j]) / distance);
    const Vec2 normal = way / distance;
    cut(cell, normal, normal.dot(p) + shift, j);
    if (cell.outline.empty()) return cell;
  }
  for (const Obstacle& o : bounds.obstacles)
    if (!cell.outline.empty() && boxes_meet(cell.outline, o)) cut_by_obstacle(cell, p, o.outline);
  if (!cell.outline.empty()) cell.area = geometry::polygon_moments(cell.outline).area;
  return cell;
}

}  // namespace

std::vector<PowerCell> power_cells(const PowerSites& sites, const FieldBounds& bounds) {
  const Neighbours near = neighbours(sites);
  std::vector<PowerCell> cells(sites.points.size());
  for (std::size_t i = 0; i < cells.size(); ++i)
    if (!near.hidden[i]) cells[i] = cell_of(static_cast<int>(i), near.of[i], sites, bounds);
  return cells;
}

}  // namespace nilas::field
