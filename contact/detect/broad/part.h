#pragma once
/// Convex parts of bodies, prepared for contact search. The geometry is that of core/geometry/shape.h, laid out for
/// what a search reads repeatedly.
#include <array>
#include <memory>
#include <span>
#include <vector>

#include "contact/detect/broad/part_cover.h"
#include "core/base/math.h"
#include "core/bodies/bodies.h"
#include "core/geometry/shape.h"

namespace nilas::detect {

enum class PartKind { polytope, cylinder, sphere, plane };

/// Edge of a polytope with the faces on its two sides.
struct PartEdge {
  int v0 = 0, v1 = 0;  ///< vertices, in an order that a mirrored part shares, except for an edge that is its own image
  int f0 = 0, f1 = 0;
};

/// A corner of a face: its vertex, and the edge that begins there.
struct FaceCorner {
  int vertex = 0, edge = 0;
};

/// Lists of items, one after the other in memory.
template <class Item>
class ItemLists {
 public:
  void add(const std::vector<Item>& list) {
    items_.insert(items_.end(), list.begin(), list.end());
    start_.push_back(static_cast<int>(items_.size()));
  }
  /// The items of all lists.
  std::span<const Item> items() const { return items_; }
  /// Where the lists begin and end among all items.
  std::span<const int> bounds() const { return start_; }
  std::span<const Item> operator[](int i) const {
    return {items_.data() + start_[i], items_.data() + start_[static_cast<std::size_t>(i) + 1]};
  }

 private:
  std::vector<int> start_{0};
  std::vector<Item> items_;
};
using NumberLists = ItemLists<int>;

/// A polytope with one coordinate per column, so that one pass serves all vertices or all faces. Numbers that follow
/// from others are not stored: a search waits longer for the memory of a thousand floes than it computes.
struct alignas(64) FacetedGeometry {
  const geometry::ConvexPolytope* polytope = nullptr;
  // What a pair that stays apart reads stands in the first line of the cache.
  Eigen::Array<double, Eigen::Dynamic, 3> vertices;
  std::vector<int> start_vertices;  ///< support vertex per cell of directions; empty where all vertices are tried
  double roughness = 0;  ///< largest distance of vertices from the plane of their face or above a neighbour's [m]
  Eigen::Array<double, Eigen::Dynamic, 3> normals;
  Eigen::ArrayXd offsets;
  std::vector<PartEdge> edges;
  ItemLists<FaceCorner> face_corners;  ///< loops, counter-clockwise from outside
  NumberLists face_edges;              ///< edge k joins corners k and k + 1
  NumberLists vertex_faces, vertex_edges;
  NumberLists smooth_neighbours;  ///< neighbours across an edge whose normals differ by less than twice the patch angle

  Vec3 vertex(int v) const { return {vertices(v, 0), vertices(v, 1), vertices(v, 2)}; }
  Vec3 normal(int f) const { return {normals(f, 0), normals(f, 1), normals(f, 2)}; }
  /// Vector from the edge's v0 to its v1 [m].
  Vec3 along(const PartEdge& edge) const { return vertex(edge.v1) - vertex(edge.v0); }
  /// Middle of the edge, the same bits from either end [m].
  Vec3 middle(const PartEdge& edge) const { return 0.5 * (vertex(edge.v0) + vertex(edge.v1)); }
};

/// One convex part of one body. Points and directions are in the body's frame.
struct Part {
  int body = -1;  ///< index of the body
  int index = 0;  ///< index of the part within its body
  PartKind kind = PartKind::polytope;
  std::unique_ptr<const FacetedGeometry> facets;  ///< polytope only
  std::shared_ptr<const PartCover> cover;  ///< cover of a part that touches others of its body; null for the rest
  double radius = 0;                       ///< sphere, cylinder [m]
  double half_height = 0;                  ///< cylinder, axis z [m]
  Vec3 centre = Vec3::Zero();              ///< a point inside
  double bounding_radius = 0;              ///< bounding radius about `centre`; infinite for a plane [m]
  double inner_radius = 0;                 ///< radius of a ball about `centre` inside the part [m]
};

/// Faces within this angle of the contact normal belong to one patch of surface [rad]: a curved hull's facets turn by a
/// degree or two each, the faces of a floe by more.
constexpr double k_patch_angle = 5.0 * k_deg;
/// A patch grows over gentle edges up to faces that turn by this much [rad]. A floe across a curved bow touches at both
/// its ends, where the bow has other normals.
constexpr double k_grown_angle = 25.0 * k_deg;

/// Returns the contact parts of body b. The body must keep its shape for as long as the parts live.
std::vector<Part> make_parts(const bodies::Bodies& bodies, int b);

/// Returns the largest n . x over the part, for n of any length. Not for planes.
double extent(const Part& part, const Vec3& n);
/// Returns a vertex of the polytope where n . x is largest.
int support_vertex(const FacetedGeometry& facets, const Vec3& n);
/// Lists all vertices where n . x is within `tolerance` [m] of the largest, in rising order.
void support_vertices(const FacetedGeometry& facets, const Vec3& n, double tolerance, std::vector<int>& out);

/// Supporting points of a cylinder in direction n: one of a rim, both ends of a side line, or a cap's centre.
struct CylinderSupport {
  std::array<Vec3, 2> points;
  int count = 1;
};
/// Returns the supporting points in the direction of the unit vector n. Heights that differ by less than `tolerance`
/// [m] count as equal.
CylinderSupport cylinder_support(const Part& part, const Vec3& n, double tolerance);

}  // namespace nilas::detect
