#pragma once
/// Distance of two convex solids that are apart, feature by feature. Shares no code with contact/detect.
#include "tests/support/collision/sat_oracle.h"

namespace nilas::oracle {

/// The shortest vector found so far from a point of a to a point of b, and its length [m].
struct Span {
  Vec3 way = Vec3::UnitX();
  double length = k_infinite;
  void offer(const Vec3& other) {
    const double other_length = other.norm();
    if (other_length < length) *this = {other, other_length};
  }
};

/// The point of a cylinder that is nearest to x, a point outside of it.
inline Vec3 nearest_on_cylinder(const Solid& cylinder, const Vec3& x) {
  const Vec3 middle = 0.5 * (cylinder.vertices[0] + cylinder.vertices[1]);
  const double half = 0.5 * (cylinder.vertices[1] - cylinder.vertices[0]).norm();
  const double z = cylinder.axis.dot(x - middle);
  const Vec3 out = x - middle - z * cylinder.axis;
  const double r = out.norm();
  return middle + std::clamp(z, -half, half) * cylinder.axis + (r > cylinder.radius ? cylinder.radius / r : 1.0) * out;
}

/// Offers the vector between x and its foot on a face of a polytope, when the foot lies on the face.
inline void offer_face(const Solid& solid, int face, const Vec3& x, double sign, Span& least) {
  const auto& loop = solid.faces[face];
  const Vec3& n = solid.normals[face];
  for (std::size_t k = 0; k < loop.size(); ++k) {
    const Vec3& p = solid.vertices[loop[k]];
    const Vec3& q = solid.vertices[loop[(k + 1) % loop.size()]];
    if ((q - p).cross(n).dot(x - p) > 0) return;
  }
  least.offer(sign * n.dot(x - solid.vertices[loop[0]]) * n);
}

inline void offer_segments(const Vec3& p0, const Vec3& p1, const Vec3& q0, const Vec3& q1, Span& least) {
  const auto foot = [](const Vec3& x, const Vec3& s0, const Vec3& s1) {
    const double t = std::clamp((x - s0).dot(s1 - s0) / (s1 - s0).squaredNorm(), 0.0, 1.0);
    return Vec3(s0 + t * (s1 - s0));
  };
  for (const Vec3& p : {p0, p1}) least.offer(foot(p, q0, q1) - p);
  for (const Vec3& q : {q0, q1}) least.offer(q - foot(q, p0, p1));
  const Vec3 d = p1 - p0, e = q1 - q0, n = d.cross(e);
  constexpr double k_parallel = 1e-9;
  if (n.norm() <= k_parallel * d.norm() * e.norm()) return;
  const double t = (q0 - p0).cross(e).dot(n) / n.squaredNorm();
  const double u = (q0 - p0).cross(d).dot(n) / n.squaredNorm();
  if (t >= 0 && t <= 1 && u >= 0 && u <= 1) least.offer((q0 - p0).dot(n.normalized()) * n.normalized());
}

inline Span between_polytopes(const Solid& a, const Solid& b) {
  Span least;
  for (int f = 0; f < static_cast<int>(a.faces.size()); ++f)
    for (const Vec3& v : b.vertices) offer_face(a, f, v, 1, least);
  for (int f = 0; f < static_cast<int>(b.faces.size()); ++f)
    for (const Vec3& v : a.vertices) offer_face(b, f, v, -1, least);
  for (const auto& [i, j] : a.edges)
    for (const auto& [k, l] : b.edges)
      offer_segments(a.vertices[i], a.vertices[j], b.vertices[k], b.vertices[l], least);
  return least;
}

/// The shortest vector from a polytope to a cylinder. Candidates are the points of the polytope's edges, along which
/// the distance is convex, and the rims against its faces.
inline Span polytope_to_cylinder(const Solid& polytope, const Solid& cylinder) {
  Span least;
  for (const auto& [i, j] : polytope.edges) {
    const Vec3 &p = polytope.vertices[i], &q = polytope.vertices[j];
    const auto way = [&](double t) {
      const Vec3 x = p + t * (q - p);
      return Vec3(nearest_on_cylinder(cylinder, x) - x);
    };
    least.offer(way(top([&](double t) { return -way(t).norm(); }, 0, 1)));
    for (const double end : {0.0, 1.0}) least.offer(way(end));
  }
  for (int f = 0; f < static_cast<int>(polytope.faces.size()); ++f) {
    const Vec3& n = polytope.normals[f];
    const Vec3 aside = n.dot(cylinder.axis) * cylinder.axis - n;
    for (const Vec3& centre : cylinder.vertices) {
      offer_face(polytope, f, centre, 1, least);  // A cap may lie flat on a face.
      if (aside.norm() > 1e-12) offer_face(polytope, f, centre + cylinder.radius * aside.normalized(), 1, least);
    }
  }
  return least;
}

/// The shortest vector between two cylinders. Candidates are the rims against the other cylinder, and the sides where
/// the axes cross.
inline Span between_cylinders(const Solid& a, const Solid& b) {
  Span least;
  constexpr int k_samples = 72;
  const auto offer_rims = [&](const Solid& of, const Solid& other, double sign) {
    const Vec3 u = of.axis.unitOrthogonal(), v = of.axis.cross(u);
    for (const Vec3& centre : of.vertices) {
      const auto way = [&](double angle) {
        const Vec3 x = centre + of.radius * (std::cos(angle) * u + std::sin(angle) * v);
        return Vec3(sign * (nearest_on_cylinder(other, x) - x));
      };
      visit_tops([&](double angle) { return -way(angle).norm(); }, k_samples,
                 [&](double angle) { least.offer(way(angle)); });
    }
  };
  offer_rims(a, b, 1);
  offer_rims(b, a, -1);
  Span axes;
  offer_segments(a.vertices[0], a.vertices[1], b.vertices[0], b.vertices[1], axes);
  const bool square_to_both =
      std::max(std::abs(axes.way.dot(a.axis)), std::abs(axes.way.dot(b.axis))) < 1e-9 * axes.length;
  if (square_to_both && axes.length > a.radius + b.radius)
    least.offer((1 - (a.radius + b.radius) / axes.length) * axes.way);
  return least;
}

inline Span shortest_way(const Solid& a, const Solid& b) {
  if (is_round(a) && is_round(b)) return between_cylinders(a, b);
  if (is_round(b)) return polytope_to_cylinder(a, b);
  if (!is_round(a)) return between_polytopes(a, b);
  const Span back = polytope_to_cylinder(b, a);
  return {-back.way, back.length};
}

/// Distance of two solids that are apart [m].
inline double distance(const Solid& a, const Solid& b) { return shortest_way(a, b).length; }

/// The gap of two solids and its direction from a to b: their distance, or minus the depth of their overlap. A gap of
/// more than `enough` [m] may be larger than the returned value.
inline SeparatingAxis true_gap(const Solid& a, const Solid& b, double enough = k_infinite) {
  const SeparatingAxis best = best_axis(a, b);
  if (!(best.s > 0) || best.s > enough) return best;
  const Span way = shortest_way(a, b);
  return way.length > best.s ? SeparatingAxis{way.way / way.length, way.length} : best;
}

}  // namespace nilas::oracle
