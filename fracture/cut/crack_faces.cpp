/// This file includes CGAL, whose kernels need directed rounding: see fracture/CMakeLists.txt.
#include "fracture/cut/crack_faces.h"

#include <CGAL/Arr_extended_dcel.h>
#include <CGAL/Arr_non_caching_segment_basic_traits_2.h>
#include <CGAL/Arrangement_2.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <set>
#include <utility>

#include "core/geometry/mass_properties.h"

namespace nilas::fracture {

namespace {

// Lines meet at common end points only. Predicates therefore suffice, and those of this kernel are exact.
using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Traits = CGAL::Arr_non_caching_segment_basic_traits_2<Kernel>;
/// The data of vertices are the indices of their points. Those of halfedges along the outline, with the inside on their
/// left, are their places in the outline, else -1. Those of faces say whether they are inside.
using Arrangement = CGAL::Arrangement_2<Traits, CGAL::Arr_extended_dcel<Traits, int, int, bool>>;
using Halfedge = Arrangement::Halfedge_handle;
using Face = Arrangement::Face_handle;

bool is_crack(Halfedge h) { return h->data() < 0 && h->twin()->data() < 0; }

std::vector<Halfedge> around(Face face) {
  std::vector<Halfedge> edges;
  auto h = face->outer_ccb();
  const auto first = h;
  do edges.push_back(h);
  while (++h != first);
  return edges;
}

class FaceFinder {
 public:
  explicit FaceFinder(const SnappedLines& lines) : lines_(lines) {
    std::set<std::pair<int, int>> edges;
    const auto& o = lines.outline;
    for (std::size_t i = 0; i < o.size(); ++i) {
      const int a = o[i], b = o[(i + 1) % o.size()];
      edges.insert(std::minmax(a, b));
      place_[{a, b}] = static_cast<int>(i);
    }
    for (const auto& crack : lines.cracks)
      for (std::size_t i = 1; i < crack.size(); ++i) edges.insert(std::minmax(crack[i - 1], crack[i]));
    std::vector<Traits::X_monotone_curve_2> segments;
    for (const auto& [a, b] : edges) segments.emplace_back(point(a), point(b));
    CGAL::insert_non_intersecting_curves(plane_, segments.begin(), segments.end());
    label();
    remove_if([](Halfedge h) { return h->face() == h->twin()->face(); });
    mark_inside();
    remove_if([](Halfedge h) { return !h->face()->data() && !h->twin()->face()->data(); });
  }

  /// Joins one face that is thinner than `least_width` [m] to a neighbour. Returns false where there is none.
  bool join_sliver(double least_width) {
    for (Face face : inside())
      if (is_thin(face, least_width))
        if (const Face other = longest_neighbour(face); other != Face()) {
          for (Halfedge h : around(face))
            if (h->twin()->face() == other && is_crack(h)) doomed_.push_back(h);
          remove_doomed();
          remove_if([](Halfedge h) { return h->face() == h->twin()->face(); });
          mark_inside();
          return true;
        }
    return false;
  }

  std::vector<CrackFace> faces() {
    std::vector<CrackFace> all;
    for (Face face : inside()) {
      all.push_back({{}, {}, face->number_of_inner_ccbs() > 0});
      for (Halfedge h : around(face)) {
        all.back().points.push_back(h->source()->data());
        all.back().along.push_back(h->data());
      }
    }
    return all;
  }

  /// A flag per point: only two edges are left there, both outline or both crack. The outline's own vertices and the
  /// turns of a crack have none.
  std::vector<char> needless(double resolution) const {
    std::vector<char> found(lines_.points.size(), 0);
    for (auto v = plane_.vertices_begin(); v != plane_.vertices_end(); ++v) {
      if (v->degree() != 2 || v->data() < lines_.num_corners) continue;
      const auto h = v->incident_halfedges();
      const bool crack = h->data() < 0 && h->twin()->data() < 0, given = lines_.given[index(v->data())] != 0;
      const int before = h->source()->data(), after = h->next()->target()->data();
      found[index(v->data())] = !crack || !given || is_straight(before, v->data(), after, resolution);
    }
    return found;
  }

 private:
  static std::size_t index(int i) { return static_cast<std::size_t>(i); }

  bool is_straight(int a, int b, int c, double resolution) const {
    const Vec2 along = lines_.points[index(c)] - lines_.points[index(a)];
    const Vec2 to_b = lines_.points[index(b)] - lines_.points[index(a)];
    return std::abs(along.x() * to_b.y() - along.y() * to_b.x()) <= resolution * along.norm();
  }

  Kernel::Point_2 point(int i) const {
    const Vec2& p = lines_.points[index(i)];
    return {p.x(), p.y()};
  }

  void label() {
    std::map<std::pair<double, double>, int> indices;
    for (std::size_t i = 0; i < lines_.points.size(); ++i)
      indices[{lines_.points[i].x(), lines_.points[i].y()}] = static_cast<int>(i);
    for (auto v = plane_.vertices_begin(); v != plane_.vertices_end(); ++v)
      v->set_data(indices.at({v->point().x(), v->point().y()}));
    for (auto h = plane_.halfedges_begin(); h != plane_.halfedges_end(); ++h) {
      const auto place = place_.find({h->source()->data(), h->target()->data()});
      h->set_data(place == place_.end() ? -1 : place->second);
    }
  }

  /// Marks the faces inside, from the outline's edges across the cracks.
  void mark_inside() {
    for (auto f = plane_.faces_begin(); f != plane_.faces_end(); ++f) f->set_data(false);
    std::vector<Halfedge> open;
    for (auto h = plane_.halfedges_begin(); h != plane_.halfedges_end(); ++h)
      if (h->data() >= 0) open.push_back(h);
    while (!open.empty()) {
      const Face face = open.back()->face();
      open.pop_back();
      if (face->data()) continue;
      face->set_data(true);
      for (Halfedge h : around(face))
        if (is_crack(h)) open.push_back(h->twin());
    }
  }

  template <class Condition>
  void remove_if(const Condition& condition) {
    for (auto e = plane_.edges_begin(); e != plane_.edges_end(); ++e)
      if (is_crack(e) && condition(e)) doomed_.push_back(e);
    remove_doomed();
  }

  void remove_doomed() {
    for (Halfedge h : doomed_) plane_.remove_edge(h);
    doomed_.clear();
  }

  std::vector<Face> inside() {
    std::vector<Face> faces;
    for (auto f = plane_.faces_begin(); f != plane_.faces_end(); ++f)
      if (f->data()) faces.push_back(f);
    return faces;
  }

  Vec2 vector_along(Halfedge h) const {
    return lines_.points[index(h->target()->data())] - lines_.points[index(h->source()->data())];
  }

  bool is_thin(Face face, double least_width) const {
    std::vector<Vec2> outline;
    double perimeter = 0;
    for (Halfedge h : around(face)) {
      outline.push_back(lines_.points[index(h->source()->data())]);
      perimeter += vector_along(h).norm();
    }
    return 2 * geometry::polygon_moments(outline).area < least_width * perimeter;
  }

  /// The neighbour that shares most crack length, the first along the boundary of equal ones.
  Face longest_neighbour(Face face) const {
    const std::vector<Halfedge> edges = around(face);
    Face best{};
    double most = 0;
    for (Halfedge h : edges) {
      if (!is_crack(h)) continue;
      double shared = 0;
      for (Halfedge g : edges)
        if (is_crack(g) && g->twin()->face() == h->twin()->face()) shared += vector_along(g).norm();
      if (shared > most) {
        most = shared;
        best = h->twin()->face();
      }
    }
    return best;
  }

  const SnappedLines& lines_;
  Arrangement plane_;
  std::map<std::pair<int, int>, int> place_;
  std::vector<Halfedge> doomed_;
};

}  // namespace

CrackFaces crack_faces(const SnappedLines& lines, double least_width) {
  FaceFinder finder(lines);
  CrackFaces found;
  while (finder.join_sliver(least_width)) ++found.slivers;
  found.faces = finder.faces();
  found.needless = finder.needless(least_width);
  return found;
}

}  // namespace nilas::fracture
