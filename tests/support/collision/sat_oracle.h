#pragma once
/// Brute-force truth for two convex solids: every face normal, every pair of edges, every direction of a round side. It
/// is slow and simple on purpose, and shares no code with contact/detect.
#include <algorithm>
#include <cmath>
#include <limits>
#include <tuple>
#include <utility>
#include <vector>

#include "core/bodies/bodies.h"
#include "core/geometry/shape.h"

namespace nilas::oracle {

constexpr double k_infinite = std::numeric_limits<double>::infinity();

/// The Minkowski sum of a polytope and a disc, at a pose. A cylinder is the segment between its caps' centres and a
/// disc.
struct Solid {
  std::vector<Vec3> vertices;
  std::vector<std::vector<int>> faces;
  std::vector<Vec3> normals;  ///< Normals of the faces, and of a cylinder's caps.
  std::vector<std::pair<int, int>> edges;
  Vec3 axis = Vec3::UnitZ();  ///< Axis of the disc.
  double radius = 0;          ///< Radius of the disc [m].

  /// The share of the disc in the extent along n [m].
  double rim(const Vec3& n) const { return radius > 0 ? radius * (n - n.dot(axis) * axis).norm() : 0; }
  double extent(const Vec3& n) const {
    double high = -k_infinite;
    for (const Vec3& v : vertices) high = std::max(high, n.dot(v));
    return high + rim(n);
  }
};

inline Solid posed(const geometry::ConvexPolytope& polytope, const Mat3& R, const Vec3& p) {
  Solid solid;
  for (const Vec3& v : polytope.vertices) solid.vertices.push_back(R * v + p);
  solid.faces = polytope.faces;
  for (const auto& loop : polytope.faces) {
    Vec3 area = Vec3::Zero();
    for (std::size_t k = 0; k < loop.size(); ++k) {
      const int i = loop[k], j = loop[(k + 1) % loop.size()];
      area +=
          (polytope.vertices[i] - polytope.vertices[loop[0]]).cross(polytope.vertices[j] - polytope.vertices[loop[0]]);
      if (i < j) solid.edges.emplace_back(i, j);
    }
    solid.normals.push_back(R * area.normalized());
  }
  return solid;
}

inline Solid posed_cylinder(const geometry::Shape& shape, const Mat3& R, const Vec3& p) {
  Solid solid;
  solid.axis = R.col(2);
  solid.radius = shape.radius;
  solid.vertices = {p - shape.half_height * solid.axis, p + shape.half_height * solid.axis};
  solid.edges = {{0, 1}};
  solid.normals = {-solid.axis, solid.axis};
  return solid;
}

/// A convex piece of a body in coordinates relative to `origin`: with a near origin no digits are lost.
inline Solid posed(const bodies::Bodies& bodies, int b, int part = 0, const Vec3& origin = Vec3::Zero()) {
  const geometry::Shape& shape = *bodies.shape[b];
  const Vec3 p = bodies.p_GB[b] - origin;
  if (shape.kind == geometry::ShapeKind::cylinder) return posed_cylinder(shape, bodies.R_GB[b], p);
  return posed(shape.parts[part], bodies.R_GB[b], p);
}

inline bool is_round(const Solid& solid) { return solid.radius > 0; }

/// Separation along n: the least n . x over b minus the largest over a [m].
inline double separation(const Solid& a, const Solid& b, const Vec3& n) { return -b.extent(-n) - a.extent(n); }

struct SeparatingAxis {
  Vec3 n = Vec3::UnitX();  ///< Unit vector from a to b.
  double s = -k_infinite;
};

/// Differences between points of b and of a that have ruled out axes, the latest first. No axis separates the solids by
/// more than such a difference along it.
class Witnesses {
 public:
  bool rule_out(const Vec3& n, double least) const {
    return std::any_of(differences_.begin(), differences_.end(), [&](const Vec3& d) { return n.dot(d) < least; });
  }
  void add(const Solid& a, const Solid& b, const Vec3& n) {
    constexpr std::size_t k_most = 8;
    differences_.insert(differences_.begin(), farthest(b, -n) - farthest(a, n));
    if (differences_.size() > k_most) differences_.pop_back();
  }

 private:
  static Vec3 farthest(const Solid& solid, const Vec3& n) {
    return *std::max_element(solid.vertices.begin(), solid.vertices.end(),
                             [&](const Vec3& p, const Vec3& q) { return n.dot(p) < n.dot(q); });
  }
  std::vector<Vec3> differences_;
};

/// Calls visit(n, s) for the normals of the faces of both solids and of the pairs of their edges that separate them by
/// at least floor(n).
template <class Floor, class Visit>
void visit_flat_axes(const Solid& a, const Solid& b, const Floor& floor, const Visit& visit) {
  Witnesses witnesses;
  const auto add = [&](const Vec3& n, double most) {
    const double least = floor(n);
    if (most < least || witnesses.rule_out(n, least)) return;
    const double s = separation(a, b, n);
    if (s >= least)
      visit(n, s);
    else
      witnesses.add(a, b, n);
  };
  for (const Vec3& n : a.normals) add(n, k_infinite);
  for (const Vec3& n : b.normals) add(-n, k_infinite);
  for (const auto& [i, j] : a.edges) {
    const Vec3 along_a = a.vertices[j] - a.vertices[i];
    for (const auto& [k, l] : b.edges) {
      const Vec3 along_b = b.vertices[l] - b.vertices[k];
      const Vec3 n = along_a.cross(along_b);
      const double length = n.norm();
      constexpr double k_parallel = 1e-12;
      if (length <= k_parallel * std::sqrt(along_a.squaredNorm() * along_b.squaredNorm())) continue;
      const Vec3 unit = n / length;
      const double most = unit.dot(b.vertices[k] - a.vertices[i]);
      add(unit, most);
      add(-unit, -most);
    }
  }
}

/// The place of the largest f in [low, high], where f has one maximum, by golden section.
template <class Function>
double top(const Function& f, double low, double high) {
  constexpr double k_golden = 0.6180339887498949;
  double p = high - k_golden * (high - low), q = low + k_golden * (high - low);
  double at_p = f(p), at_q = f(q);
  for (int step = 0; step < 60; ++step) {
    if (at_p > at_q) {
      high = q;
      q = p;
      at_q = at_p;
      at_p = f(p = high - k_golden * (high - low));
    } else {
      low = p;
      p = q;
      at_p = at_q;
      at_q = f(q = low + k_golden * (high - low));
    }
  }
  return at_p > at_q ? p : q;
}

/// Visits local maxima of f over a full turn: samples that exceed their neighbours, refined by golden section.
template <class Function, class Visit>
void visit_tops(const Function& f, int samples, const Visit& visit) {
  std::vector<double> at(static_cast<std::size_t>(samples));
  const double step = 2 * k_pi / samples;
  for (int k = 0; k < samples; ++k) at[k] = f(k * step);
  for (int k = 0; k < samples; ++k) {
    const double before = at[(k + samples - 1) % samples];
    const double after = at[(k + 1) % samples];
    if (at[k] >= std::max(before, after)) visit(top(f, (k - 1) * step, (k + 1) * step));
  }
}

/// Visits directions square to an edge, where its sum with a disc is a ruled surface: the local maxima of each full
/// turn.
template <class Visit>
void visit_round_axes(const Solid& a, const Solid& b, const Visit& visit) {
  std::vector<Vec3> directions;
  for (const Solid* solid : {&a, &b})
    for (const auto& [i, j] : solid->edges) {
      const Vec3 along = (solid->vertices[j] - solid->vertices[i]).normalized();
      const auto same = [&](const Vec3& d) { return d.cross(along).norm() < 1e-9; };
      if (std::none_of(directions.begin(), directions.end(), same)) directions.push_back(along);
    }
  constexpr int k_samples = 72;
  for (const Vec3& d : directions) {
    const Vec3 u = d.unitOrthogonal(), v = d.cross(u);
    const auto n_at = [&](double angle) { return Vec3(std::cos(angle) * u + std::sin(angle) * v); };
    visit_tops([&](double angle) { return separation(a, b, n_at(angle)); }, k_samples,
               [&](double angle) {
                 const Vec3 n = n_at(angle);
                 visit(n, separation(a, b, n));
               });
  }
}

/// Visits the best directions of two discs, whose sum is curved both ways. The search climbs from the best of many
/// directions in ever smaller steps.
template <class Visit>
void visit_doubly_round_axes(const Solid& a, const Solid& b, const Visit& visit) {
  constexpr int k_samples = 1000, k_starts = 8;
  constexpr double k_golden_angle = 2.399963229728653;
  std::vector<std::pair<double, Vec3>> found;
  for (int k = 0; k < k_samples; ++k) {
    const double z = 1 - (2.0 * k + 1) / k_samples, r = std::sqrt(1 - z * z);
    const Vec3 n(r * std::cos(k * k_golden_angle), r * std::sin(k * k_golden_angle), z);
    found.emplace_back(separation(a, b, n), n);
  }
  std::partial_sort(found.begin(), found.begin() + k_starts, found.end(),
                    [](const auto& p, const auto& q) { return p.first > q.first; });
  for (int k = 0; k < k_starts; ++k) {
    auto [s, n] = found[k];
    for (double step = 0.06; step > 1e-9;) {
      const Vec3 u = n.unitOrthogonal(), v = n.cross(u);
      bool better = false;
      for (int way = 0; way < 8 && !better; ++way) {
        const double angle = k_pi / 4 * way;
        const Vec3 next = (n + step * (std::cos(angle) * u + std::sin(angle) * v)).normalized();
        const double s_next = separation(a, b, next);
        better = s_next > s;
        if (better) std::tie(s, n) = std::pair(s_next, next);
      }
      step *= better ? 1.5 : 0.5;
    }
    visit(n, s);
  }
}

/// All axes of two polytopes with their separations, the largest first.
inline std::vector<SeparatingAxis> all_axes(const Solid& a, const Solid& b) {
  std::vector<SeparatingAxis> axes;
  visit_flat_axes(
      a, b, [](const Vec3&) { return -k_infinite; },
      [&](const Vec3& n, double s) {
        axes.push_back({n, s});
      });
  std::sort(axes.begin(), axes.end(), [](const auto& p, const auto& q) { return p.s > q.s; });
  return axes;
}

/// The axis that separates most, or along which the solids overlap least.
inline SeparatingAxis best_axis(const Solid& a, const Solid& b) {
  SeparatingAxis best;
  const auto keep = [&](const Vec3& n, double s) {
    if (s > best.s) best = {n, s};
  };
  visit_flat_axes(
      a, b, [&](const Vec3&) { return best.s; }, keep);
  if (is_round(a) || is_round(b)) visit_round_axes(a, b, keep);
  if (is_round(a) && is_round(b)) visit_doubly_round_axes(a, b, keep);
  return best;
}

}  // namespace nilas::oracle
