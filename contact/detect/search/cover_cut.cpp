#include "contact/detect/search/cover_cut.h"

#include <algorithm>
#include <cmath>

namespace nilas::detect {

namespace {

int number_of(const Feature& feature) {
  constexpr std::uint64_t k_positive_int = 0x7fffffff;
  return static_cast<int>(contact_key(0, feature) & k_positive_int);
}

/// Returns where the segment from x, outside, to y, inside, enters the part inflated by `tolerance`, as a share of the
/// segment [-].
double entry(const CoveringPart& part, const Vec3& x, const Vec3& y, double tolerance) {
  const geometry::ConvexPolytope& polytope = *part.facets->polytope;
  double t = 0;
  for (std::size_t f = 0; f < polytope.normals.size(); ++f) {
    const double above = polytope.normals[f].dot(x) - polytope.offsets[f] - tolerance;
    if (above > 0) t = std::max(t, above / polytope.normals[f].dot(x - y));
  }
  return std::min(t, 1.0);
}

/// Cuts one common area.
class AreaCut {
 public:
  AreaCut(const CoveredSide& side, const Axis& axis, FacingSurfaces& facing)
      : side_(side), axis_(axis), plane_(facing.plane), curved_(facing.a.size() * facing.b.size() > 1) {}

  void add(const OverlayPoint* first, const OverlayPoint* last, std::vector<OverlayPoint>& out) {
    const auto count = static_cast<std::size_t>(last - first);
    for (std::size_t i = 0; i < count; ++i) {
      const OverlayPoint& p = first[i];
      if (!is_hidden(p)) {
        out.push_back(p);
        continue;
      }
      const OverlayPoint &before = first[(i + count - 1) % count], &after = first[(i + 1) % count];
      if (count > 1) add_entry(before, p, out);
      if (count > 2) add_entry(after, p, out);
      if (count > 1 && (count > 2 || i == 0) && is_hidden(after)) add_between(p, after, out);
    }
  }

 private:
  /// Returns the normal that the contact will have: that of its own place on a gently curved surface.
  Vec3 normal_at(const OverlayPoint& p) const {
    const double steepest = std::tan(k_grown_angle);
    if (!curved_ || p.gap <= axis_.s + side_.pair.tolerance || std::hypot(p.slope.u, p.slope.v) > steepest)
      return axis_.n;
    return (plane_.n - p.slope.u * plane_.t1 - p.slope.v * plane_.t2).normalized();
  }
  bool is_hidden(const OverlayPoint& p) const {
    return side_.cover().hides(side_.place(plane_, p), side_.outward(normal_at(p)));
  }

  void add_entry(const OverlayPoint& shown, const OverlayPoint& hidden, std::vector<OverlayPoint>& out) {
    if (is_hidden(shown)) return;
    const Vec3 x = side_.place(plane_, shown), y = side_.place(plane_, hidden);
    side_.cover().list_hiding(y, side_.outward(normal_at(hidden)), hiding_);
    const double t = first_entry(x, y);
    if (t * (x - y).norm() <= side_.cover().tolerance) return;
    out.push_back(on_the_way(shown, hidden, t));
  }

  /// Adds both ends of the stretch between two corners in different parts where the outline is out of both. A piece
  /// that fits between two inner corners has such an outline.
  void add_between(const OverlayPoint& p, const OverlayPoint& q, std::vector<OverlayPoint>& out) {
    const Vec3 x = side_.place(plane_, p), y = side_.place(plane_, q);
    side_.cover().list_hiding(y, side_.outward(normal_at(q)), hiding_);
    const double to = first_entry(x, y);
    side_.cover().list_hiding(x, side_.outward(normal_at(p)), hiding_);
    const double from = 1 - first_entry(y, x);
    if ((to - from) * (x - y).norm() <= side_.cover().tolerance) return;
    if (is_hidden(on_the_way(p, q, 0.5 * (from + to)))) return;
    out.push_back(on_the_way(q, p, 1 - from));
    out.push_back(on_the_way(p, q, to));
  }

  /// The share of the way from x to y at which it enters the first of the parts that hide y.
  double first_entry(const Vec3& x, const Vec3& y) const {
    double t = 1;
    for (const CoveringPart* part : hiding_) t = std::min(t, entry(*part, x, y, side_.cover().tolerance));
    return t;
  }

  static OverlayPoint on_the_way(const OverlayPoint& from, const OverlayPoint& to, double t) {
    OverlayPoint p = from;
    p.feature = {FeatureKind::cover, number_of(from.feature), number_of(to.feature)};
    p.u += t * (to.u - from.u);
    p.v += t * (to.v - from.v);
    p.height_a += t * (to.height_a - from.height_a);
    p.gap += t * (to.gap - from.gap);
    return p;
  }

  const CoveredSide& side_;
  const Axis& axis_;
  const ContactPlane& plane_;
  bool curved_;
  std::vector<const CoveringPart*> hiding_;
};

}  // namespace

Vec3 CoveredSide::place(const ContactPlane& plane, const OverlayPoint& p) const {
  if (of_a) return p.u * plane.t1 + p.v * plane.t2 + p.height_a * plane.n;
  return pair.a_in_b.point(p.u * plane.t1 + p.v * plane.t2 + (p.height_a + p.gap) * plane.n);
}

Vec3 CoveredSide::outward(const Vec3& n) const { return of_a ? n : Vec3(-(pair.a_in_b.R * n)); }

Vec3 CoveredSide::other_place(const ContactPlane& plane, const OverlayPoint& p) const {
  return place(plane, p) + p.gap * outward(plane.n);
}

void cut_covered(const CoveredSide& side, const Axis& axis, FacingSurfaces& facing) {
  AreaCut cut(side, axis, facing);
  std::vector<OverlayPoint> left;
  int first = 0;
  for (int& end : facing.loop_ends) {
    cut.add(facing.points.data() + first, facing.points.data() + end, left);
    first = end;
    end = static_cast<int>(left.size());
  }
  facing.points.swap(left);
}

void drop_dominated(const CoveredSide& side, FacingSurfaces& facing) {
  const double tolerance = side.cover().tolerance;
  std::erase_if(facing.points, [&](const OverlayPoint& p) {
    if (p.gap >= -tolerance) return false;
    const Vec3 x = side.other_place(facing.plane, p);
    return std::any_of(side.cover().parts.begin(), side.cover().parts.end(), [&](const CoveringPart& part) {
      return part.contains(x, tolerance) && part.leads_out_within(-p.gap - tolerance, x);
    });
  });
}

void drop_internal_features(const CoveredSide& side, FacingSurfaces& facing) {
  const auto is = [](const std::vector<char>& internal, int i) { return i >= 0 && internal[i] != 0; };
  std::erase_if(facing.points, [&](const OverlayPoint& p) {
    const PartCover& cover = side.cover();
    if (p.feature.kind == FeatureKind::crossing)
      return is(cover.edge_is_internal, side.of_a ? p.feature.first : p.feature.second);
    return p.feature.kind == (side.of_a ? FeatureKind::vertex_a : FeatureKind::vertex_b) &&
           is(cover.vertex_is_internal, p.feature.first);
  });
}

}  // namespace nilas::detect
