#include "contact/detect/broad/part.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <tuple>
#include <utility>

#include "core/base/mirror_order.h"

namespace nilas::detect {

namespace {

using Columns = Eigen::Array<double, Eigen::Dynamic, 3>;

Columns columns(const std::vector<Vec3>& points) {
  Columns m(static_cast<Eigen::Index>(points.size()), 3);
  for (std::size_t i = 0; i < points.size(); ++i) m.row(static_cast<Eigen::Index>(i)) = points[i].transpose().array();
  return m;
}

/// One side of an edge: the two vertices of the edge, the face, and the place in the face's loop.
using EdgeSide = std::tuple<int, int, int, int>;

std::vector<EdgeSide> edge_sides(const geometry::ConvexPolytope& polytope) {
  std::vector<EdgeSide> sides;
  for (int f = 0; f < static_cast<int>(polytope.faces.size()); ++f) {
    const auto& loop = polytope.faces[f];
    for (int k = 0; k < static_cast<int>(loop.size()); ++k) {
      const int i = loop[k];
      const int j = loop[(k + 1) % loop.size()];
      sides.emplace_back(std::min(i, j), std::max(i, j), f, k);
    }
  }
  std::sort(sides.begin(), sides.end());
  return sides;
}

PartEdge edge_between(const geometry::ConvexPolytope& polytope, int i, int j, int face) {
  const bool in_order = comes_before(polytope.vertices[i], polytope.vertices[j]);
  return {in_order ? i : j, in_order ? j : i, face, face};
}

void add_edges(const geometry::ConvexPolytope& polytope, FacetedGeometry& facets) {
  std::vector<std::vector<int>> of_vertex(polytope.vertices.size()), of_face;
  for (const auto& loop : polytope.faces) of_face.emplace_back(loop.size(), -1);
  std::pair<int, int> last(-1, -1);
  for (const auto& [i, j, f, k] : edge_sides(polytope)) {
    if (last != std::pair(i, j)) {
      const int e = static_cast<int>(facets.edges.size());
      facets.edges.push_back(edge_between(polytope, i, j, f));
      of_vertex[i].push_back(e);
      of_vertex[j].push_back(e);
      last = {i, j};
    }
    facets.edges.back().f1 = f;
    of_face[f][k] = static_cast<int>(facets.edges.size()) - 1;
  }
  for (std::size_t f = 0; f < of_face.size(); ++f) {
    facets.face_edges.add(of_face[f]);
    std::vector<FaceCorner> corners;
    for (std::size_t k = 0; k < of_face[f].size(); ++k) corners.push_back({polytope.faces[f][k], of_face[f][k]});
    facets.face_corners.add(corners);
  }
  for (std::size_t v = 0; v < of_vertex.size(); ++v) {
    facets.vertex_faces.add(polytope.vertex_faces[v]);
    facets.vertex_edges.add(of_vertex[v]);
  }
}

void add_smooth_neighbours(const geometry::ConvexPolytope& polytope, FacetedGeometry& facets) {
  std::vector<std::vector<int>> neighbours(polytope.faces.size());
  const double smooth = std::cos(2.0 * k_patch_angle);
  for (const PartEdge& edge : facets.edges) {
    if (edge.f0 == edge.f1 || polytope.normals[edge.f0].dot(polytope.normals[edge.f1]) < smooth) continue;
    neighbours[edge.f0].push_back(edge.f1);
    neighbours[edge.f1].push_back(edge.f0);
  }
  for (const auto& list : neighbours) facets.smooth_neighbours.add(list);
}

double face_excess(const geometry::ConvexPolytope& polytope, int plane, int loop) {
  double excess = 0;
  for (int v : polytope.faces[loop]) {
    const double height = polytope.normals[plane].dot(polytope.vertices[v]) - polytope.offsets[plane];
    excess = std::max(excess, plane == loop ? std::abs(height) : height);
  }
  return excess;
}

double roughness(const geometry::ConvexPolytope& polytope, const FacetedGeometry& facets) {
  double most = 0;
  for (int f = 0; f < static_cast<int>(polytope.faces.size()); ++f) most = std::max(most, face_excess(polytope, f, f));
  for (const PartEdge& edge : facets.edges)
    most = std::max({most, face_excess(polytope, edge.f0, edge.f1), face_excess(polytope, edge.f1, edge.f0)});
  return most;
}

/// Directions are sorted into the cells of a cube's faces, k_cells x k_cells each.
constexpr int k_cells = 4;
constexpr int k_cube_faces = 6;
/// Number of vertices up to which trying them all is quicker than walking over the surface.
constexpr int k_few_vertices = 48;

int cell_along(double ratio) {
  const int cell = static_cast<int>(std::floor((ratio + 1.0) * 0.5 * k_cells));
  return std::clamp(cell, 0, k_cells - 1);
}

int direction_cell(const Vec3& n) {
  int axis = 0;
  const double largest = n.cwiseAbs().maxCoeff(&axis);
  const int cube_face = 2 * axis + (n[axis] > 0 ? 1 : 0);
  const int row = cell_along(n[(axis + 1) % 3] / largest);
  const int column = cell_along(n[(axis + 2) % 3] / largest);
  return (cube_face * k_cells + row) * k_cells + column;
}

Vec3 cell_direction(int cell) {
  const double column = (cell % k_cells + 0.5) * 2.0 / k_cells - 1.0;
  const double row = (cell / k_cells % k_cells + 0.5) * 2.0 / k_cells - 1.0;
  const int cube_face = cell / (k_cells * k_cells);
  const int axis = cube_face / 2;
  Vec3 n;
  n[axis] = cube_face % 2 == 1 ? 1.0 : -1.0;
  n[(axis + 1) % 3] = row;
  n[(axis + 2) % 3] = column;
  return n;
}

auto heights(const FacetedGeometry& facets, const Vec3& n) {
  return facets.vertices.col(0) * n.x() + facets.vertices.col(1) * n.y() + facets.vertices.col(2) * n.z();
}

int highest_vertex(const FacetedGeometry& facets, const Vec3& n) {
  Eigen::Index v = 0;
  heights(facets, n).maxCoeff(&v);
  return static_cast<int>(v);
}

double height(const FacetedGeometry& facets, int v, const Vec3& n) { return n.dot(facets.polytope->vertices[v]); }

/// Walks along edges to higher vertices. On a convex surface the top it finds is the highest.
int climb(const FacetedGeometry& facets, const Vec3& n) {
  int top = facets.start_vertices[direction_cell(n)];
  double highest = height(facets, top, n);
  for (int from = -1; from != top;) {
    from = top;
    for (int v : facets.polytope->vertex_neighbours[from]) {
      const double h = height(facets, v, n);
      if (h <= highest) continue;
      highest = h;
      top = v;
    }
  }
  return top;
}

std::unique_ptr<const FacetedGeometry> facet(const geometry::ConvexPolytope& polytope) {
  auto facets = std::make_unique<FacetedGeometry>();
  facets->polytope = &polytope;
  facets->vertices = columns(polytope.vertices);
  facets->normals = columns(polytope.normals);
  facets->offsets = Eigen::Map<const Eigen::ArrayXd>(polytope.offsets.data(), facets->normals.rows());
  add_edges(polytope, *facets);
  add_smooth_neighbours(polytope, *facets);
  facets->roughness = roughness(polytope, *facets);
  if (facets->vertices.rows() > k_few_vertices)
    for (int cell = 0; cell < k_cube_faces * k_cells * k_cells; ++cell)
      facets->start_vertices.push_back(highest_vertex(*facets, cell_direction(cell)));
  return facets;
}

Part polytope_part(const geometry::ConvexPolytope& polytope, int b, int index) {
  Part part;
  part.body = b;
  part.index = index;
  part.facets = facet(polytope);
  part.centre = polytope.centre;
  part.bounding_radius = polytope.radius;
  part.inner_radius = std::numeric_limits<double>::infinity();
  for (std::size_t f = 0; f < polytope.normals.size(); ++f)
    part.inner_radius = std::min(part.inner_radius, polytope.offsets[f] - polytope.normals[f].dot(polytope.centre));
  return part;
}

Part round_part(const geometry::Shape& shape, int b) {
  Part part;
  part.body = b;
  part.radius = shape.radius;
  part.half_height = shape.half_height;
  if (shape.kind == geometry::ShapeKind::plane) {
    part.kind = PartKind::plane;
    part.bounding_radius = std::numeric_limits<double>::infinity();
    return part;
  }
  const bool sphere = shape.kind == geometry::ShapeKind::sphere;
  part.kind = sphere ? PartKind::sphere : PartKind::cylinder;
  part.bounding_radius = sphere ? shape.radius : std::hypot(shape.radius, shape.half_height);
  part.inner_radius = sphere ? shape.radius : std::min(shape.radius, shape.half_height);
  return part;
}

}  // namespace

std::vector<Part> make_parts(const bodies::Bodies& bodies, int b) {
  const geometry::Shape& shape = *bodies.shape[b];
  std::vector<Part> parts;
  const bool round = shape.kind == geometry::ShapeKind::sphere || shape.kind == geometry::ShapeKind::cylinder ||
                     shape.kind == geometry::ShapeKind::plane;
  if (round) {
    parts.push_back(round_part(shape, b));
    return parts;
  }
  for (std::size_t i = 0; i < shape.parts.size(); ++i)
    parts.push_back(polytope_part(shape.parts[i], b, static_cast<int>(i)));
  cover_each_other(parts);
  return parts;
}

double extent(const Part& part, const Vec3& n) {
  switch (part.kind) {
    case PartKind::sphere:
      return part.radius * n.norm();
    case PartKind::cylinder:
      return part.radius * std::sqrt(n.x() * n.x() + n.y() * n.y()) + part.half_height * std::abs(n.z());
    default:
      break;
  }
  const FacetedGeometry& facets = *part.facets;
  if (facets.start_vertices.empty()) return heights(facets, n).maxCoeff();
  return height(facets, climb(facets, n), n);
}

int support_vertex(const FacetedGeometry& facets, const Vec3& n) {
  return facets.start_vertices.empty() ? highest_vertex(facets, n) : climb(facets, n);
}

void support_vertices(const FacetedGeometry& facets, const Vec3& n, double tolerance, std::vector<int>& out) {
  if (facets.start_vertices.empty()) {
    const Eigen::Array<double, Eigen::Dynamic, 1, 0, k_few_vertices, 1> all = heights(facets, n);
    const double least = all.maxCoeff() - tolerance;
    out.clear();
    for (int v = 0; v < static_cast<int>(all.size()); ++v)
      if (all[v] >= least) out.push_back(v);
    return;
  }
  out.assign(1, climb(facets, n));
  const double least = height(facets, out[0], n) - tolerance;
  for (std::size_t i = 0; i < out.size(); ++i)
    for (int v : facets.polytope->vertex_neighbours[out[i]])
      if (height(facets, v, n) >= least && std::find(out.begin(), out.end(), v) == out.end()) out.push_back(v);
  std::sort(out.begin(), out.end());
}

CylinderSupport cylinder_support(const Part& part, const Vec3& n, double tolerance) {
  const double across = std::sqrt(n.x() * n.x() + n.y() * n.y());
  const double cap = n.z() < 0 ? -part.half_height : part.half_height;
  CylinderSupport support;
  if (2.0 * part.radius * across <= tolerance) {
    support.points[0] = cap * Vec3::UnitZ();
    return support;
  }
  const Vec3 side = part.radius / across * Vec3(n.x(), n.y(), 0);
  support.points[0] = side + cap * Vec3::UnitZ();
  support.points[1] = side - cap * Vec3::UnitZ();
  if (2.0 * part.half_height * std::abs(n.z()) <= tolerance) support.count = 2;
  return support;
}

}  // namespace nilas::detect
