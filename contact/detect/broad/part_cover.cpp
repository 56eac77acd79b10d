#include "contact/detect/broad/part_cover.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "contact/detect/broad/part.h"

namespace nilas::detect {

namespace {

/// Parts nearer than this share of the largest one's size touch [-]: vertices of STL files are rounded to 6e-8 of it.
constexpr double k_near_share = 1e-6;
/// Share of the rotation from one face's normal to the other's, which gives the directions that stand for those next to
/// the face [-].
constexpr double k_beside_face = 1e-4;

using Loop = std::vector<Vec3>;

double area_of(const Loop& loop) {
  Vec3 twice = Vec3::Zero();
  for (std::size_t k = 2; k < loop.size(); ++k) twice += (loop[k - 1] - loop[0]).cross(loop[k] - loop[0]);
  return 0.5 * twice.norm();
}

/// Returns the length of a segment, given as a loop from one end to the other and back.
double length_of(const Loop& loop) {
  double square = 0;
  for (const Vec3& x : loop) square = std::max(square, (x - loop.front()).squaredNorm());
  return std::sqrt(square);
}

/// The pieces of a convex loop on the two sides of the plane n . x = offset.
std::pair<Loop, Loop> split(const Loop& loop, const Vec3& n, double offset) {
  std::pair<Loop, Loop> sides;
  for (std::size_t k = 0; k < loop.size(); ++k) {
    const Vec3 &p = loop[k], &q = loop[(k + 1) % loop.size()];
    const double at_p = n.dot(p) - offset, at_q = n.dot(q) - offset;
    (at_p <= 0 ? sides.first : sides.second).push_back(p);
    if ((at_p <= 0) == (at_q <= 0)) continue;
    const Vec3 cut = p + at_p / (at_p - at_q) * (q - p);
    sides.first.push_back(cut);
    sides.second.push_back(cut);
  }
  return sides;
}

/// Adds to `out` the pieces of a convex loop (or, with two points, of a segment) that lie outside the part. The loop
/// stays whole where the part takes nothing away.
void subtract(const CoveringPart& part, double tolerance, Loop loop, std::vector<Loop>& out) {
  const geometry::ConvexPolytope& polytope = *part.facets->polytope;
  const std::size_t before = out.size();
  Loop inside = loop;
  for (std::size_t f = 0; f < polytope.normals.size() && !inside.empty(); ++f) {
    auto [below, above] = split(inside, polytope.normals[f], polytope.offsets[f] + tolerance);
    if (!above.empty()) out.push_back(std::move(above));
    inside = std::move(below);
  }
  if (!inside.empty()) return;
  out.resize(before);
  out.push_back(std::move(loop));
}

/// Returns the pieces of a convex loop, at height n . x, that are not hidden for the normal n.
std::vector<Loop> shown(const PartCover& cover, const Loop& loop, const Vec3& n) {
  std::vector<Loop> left{loop}, next;
  for (const CoveringPart& part : cover.parts) {
    const geometry::ConvexPolytope& polytope = *part.facets->polytope;
    const double top = n.dot(polytope.vertices[support_vertex(*part.facets, n)]);
    if (top <= n.dot(loop.front()) + cover.tolerance) continue;
    next.clear();
    for (Loop& piece : left) subtract(part, cover.tolerance, std::move(piece), next);
    left.swap(next);
  }
  return left;
}

bool is_hidden_face(const PartCover& cover, const geometry::ConvexPolytope& polytope, std::size_t f) {
  Loop loop;
  for (const int v : polytope.faces[f]) loop.push_back(polytope.vertices[v]);
  double area = 0;
  for (const Loop& piece : shown(cover, loop, polytope.normals[f])) area += area_of(piece);
  return area <= cover.tolerance * polytope.radius;
}

bool is_hidden_edge(const PartCover& cover, const geometry::ConvexPolytope& polytope, const PartEdge& edge) {
  const Vec3 &n0 = polytope.normals[edge.f0], &n1 = polytope.normals[edge.f1];
  const Loop ends{polytope.vertices[edge.v0], polytope.vertices[edge.v1]};
  for (const double share : {k_beside_face, 0.5, 1 - k_beside_face}) {
    double length = 0;
    for (const Loop& piece : shown(cover, ends, ((1 - share) * n0 + share * n1).normalized()))
      length += length_of(piece);
    if (length > cover.tolerance) return false;
  }
  return true;
}

struct PartBox {
  Vec3 low, high;
  bool meets(const PartBox& other, double margin) const {
    return ((low - other.high).array() <= margin).all() && ((other.low - high).array() <= margin).all();
  }
};

PartBox box_of(const geometry::ConvexPolytope& polytope) {
  PartBox box{polytope.vertices.front(), polytope.vertices.front()};
  for (const Vec3& v : polytope.vertices) {
    box.low = box.low.cwiseMin(v);
    box.high = box.high.cwiseMax(v);
  }
  return box;
}

std::shared_ptr<PartCover> cover_of(const std::vector<Part>& parts, const std::vector<PartBox>& boxes, double tolerance,
                                    std::size_t of) {
  auto cover = std::make_shared<PartCover>();
  cover->tolerance = tolerance;
  for (std::size_t i = 0; i < parts.size(); ++i)
    if (i != of && boxes[i].meets(boxes[of], cover->tolerance))
      cover->parts.push_back({i, parts[i].facets.get(), parts[i].centre, parts[i].bounding_radius});
  if (cover->parts.empty()) return nullptr;
  const FacetedGeometry& facets = *parts[of].facets;
  const geometry::ConvexPolytope& polytope = *facets.polytope;
  for (std::size_t f = 0; f < polytope.faces.size(); ++f)
    cover->face_is_internal.push_back(is_hidden_face(*cover, polytope, f));
  for (const PartEdge& edge : facets.edges) cover->edge_is_internal.push_back(is_hidden_edge(*cover, polytope, edge));
  for (std::size_t v = 0; v < polytope.vertices.size(); ++v) {
    const auto edges = facets.vertex_edges[static_cast<int>(v)];
    cover->vertex_is_internal.push_back(
        std::count_if(edges.begin(), edges.end(), [&](int e) { return cover->edge_is_internal[e] == 0; }) <= 1);
  }
  return cover;
}

}  // namespace

std::vector<std::vector<Vec3>> shown_pieces(const Part& part, std::size_t face) {
  const geometry::ConvexPolytope& polytope = *part.facets->polytope;
  Loop loop;
  for (const int v : polytope.faces[face]) loop.push_back(polytope.vertices[v]);
  if (!part.cover) return {loop};
  if (part.cover->face_is_internal[face] != 0) return {};
  std::vector<Loop> pieces = shown(*part.cover, loop, polytope.normals[face]);
  std::erase_if(pieces, [&](const Loop& piece) {
    return piece.size() < 3 || area_of(piece) <= part.cover->tolerance * part.cover->tolerance;
  });
  return pieces;
}

bool CoveringPart::contains(const Vec3& x, double tolerance) const {
  if ((x - centre).squaredNorm() > (radius + tolerance) * (radius + tolerance)) return false;
  const auto heights = facets->normals.col(0) * x.x() + facets->normals.col(1) * x.y() +
                       facets->normals.col(2) * x.z() - facets->offsets;
  return heights.maxCoeff() <= tolerance;
}

bool CoveringPart::leads_out_within(double depth, const Vec3& x) const {
  const geometry::ConvexPolytope& polytope = *facets->polytope;
  for (std::size_t f = 0; f < polytope.normals.size(); ++f) {
    const double distance = polytope.offsets[f] - polytope.normals[f].dot(x);
    if (distance >= depth || own->face_is_internal[f] != 0) continue;
    if (!own->hides(x + distance * polytope.normals[f], polytope.normals[f])) return true;
  }
  return false;
}

static bool hides_at(const CoveringPart& part, const Vec3& x, const Vec3& n, double tolerance) {
  if (!part.contains(x, tolerance)) return false;
  return n.dot(part.facets->polytope->vertices[support_vertex(*part.facets, n)]) > n.dot(x) + tolerance;
}

bool PartCover::hides(const Vec3& x, const Vec3& n) const {
  return std::any_of(parts.begin(), parts.end(), [&](const auto& part) { return hides_at(part, x, n, tolerance); });
}

void PartCover::list_hiding(const Vec3& x, const Vec3& n, std::vector<const CoveringPart*>& out) const {
  out.clear();
  for (const CoveringPart& part : parts)
    if (hides_at(part, x, n, tolerance)) out.push_back(&part);
}

void cover_each_other(std::vector<Part>& parts) {
  if (parts.size() < 2) return;
  std::vector<PartBox> boxes;
  for (const Part& part : parts) boxes.push_back(box_of(*part.facets->polytope));
  double largest = 0;
  for (const Part& part : parts) largest = std::max(largest, part.bounding_radius);
  std::vector<std::shared_ptr<PartCover>> covers;
  for (std::size_t i = 0; i < parts.size(); ++i) covers.push_back(cover_of(parts, boxes, k_near_share * largest, i));
  for (std::size_t i = 0; i < parts.size(); ++i) {
    if (!covers[i]) continue;
    for (CoveringPart& part : covers[i]->parts) part.own = covers[part.index].get();
    parts[i].cover = covers[i];
  }
}

}  // namespace nilas::detect
