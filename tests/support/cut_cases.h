#pragma once
/// Random outlines and cracks by class, ordinary and adversarial.
#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <vector>

#include "core/base/random.h"
#include "core/geometry/mass_properties.h"
#include "core/geometry/orientation.h"
#include "core/geometry/polygon.h"

namespace nilas::test {

using Outline = std::vector<Vec2>;
using Lines = std::vector<std::vector<Vec2>>;

struct CutCase {
  Outline outline;
  Lines cracks;
};

inline Vec2 at_angle(double radius, double angle) { return {radius * std::cos(angle), radius * std::sin(angle)}; }
inline int whole(RandomStream& random, int low, int high) {
  return low + static_cast<int>(random.uniform() * (high - low + 1));
}
/// A magnitude from 10^low to 10^high, log-uniform.
inline double magnitude(RandomStream& random, double low, double high) {
  return std::pow(10.0, random.uniform(low, high));
}

inline Outline convex_outline(RandomStream& random) {
  std::vector<double> angles;
  const int n = whole(random, 3, 20);
  const double start = random.uniform(0, 2 * k_pi), flat = random.uniform(0.3, 1);
  for (int i = 0; i < n; ++i) angles.push_back((i + random.uniform(0.05, 0.95)) * 2 * k_pi / n);
  Outline outline;
  for (const double a : angles) {
    const Vec2 p = at_angle(1, a).cwiseProduct(Vec2(1, flat));
    outline.push_back(Eigen::Rotation2Dd(start) * p);
  }
  return outline;
}

inline Outline star_outline(RandomStream& random) {
  Outline outline;
  const int n = whole(random, 5, 40);
  for (int i = 0; i < n; ++i)
    outline.push_back(at_angle(random.uniform(0.2, 1), (i + random.uniform(0.1, 0.9)) * 2 * k_pi / n));
  return outline;
}

/// A band that winds outward one to three times.
inline Outline spiral_outline(RandomStream& random) {
  const int n = whole(random, 10, 40);
  const double turns = random.uniform(1, 3), width = random.uniform(0.1, 0.6), start = random.uniform(0, 2 * k_pi);
  const auto arm = [&](int i, double inwards) {
    const double t = static_cast<double>(i) / n;
    return at_angle(0.25 + 0.75 * t - inwards * width * 0.75 / turns, start + 2 * k_pi * turns * t);
  };
  Outline outline;
  for (int i = 0; i <= n; ++i) outline.push_back(arm(i, 0));
  for (int i = n; i >= 0; --i) outline.push_back(arm(i, 1));
  return outline;
}

/// Adds vertices along edges, and some at the distance `apart` from their neighbour.
inline Outline with_runs(const Outline& outline, double apart, RandomStream& random) {
  Outline out;
  for (std::size_t i = 0; i < outline.size(); ++i) {
    const Vec2 &a = outline[i], along = outline[(i + 1) % outline.size()] - a;
    out.push_back(a);
    if (random.uniform() < 0.3) out.push_back(a + apart / along.norm() * along);
    const int more = whole(random, 0, 2);
    for (int k = 0; k < more; ++k) out.push_back(a + (k + random.uniform(0.1, 0.9)) / more * along);
  }
  return out;
}

inline bool sound(const Outline& outline) { return geometry::is_simple(outline) && !geometry::is_clockwise(outline); }

/// Returns an outline that is simple in spite of rounding, scaled and moved.
template <class Make>
Outline sound_outline(const Make& make, double scale, const Vec2& offset, RandomStream& random) {
  for (;;) {
    Outline outline = make(random);
    for (Vec2& p : outline) p = scale * p + offset;
    if (sound(outline)) return outline;
  }
}

inline Outline any_shape(RandomStream& random) {
  const int kind = whole(random, 0, 2);
  return kind == 0 ? convex_outline(random) : kind == 1 ? star_outline(random) : spiral_outline(random);
}

/// A line through a point near the middle, from far outside to far outside. Its bends advance along its direction, so
/// that it never meets itself.
inline std::vector<Vec2> through_line(RandomStream& random, double scale, const Vec2& offset, int bends) {
  const double angle = random.uniform(0, 2 * k_pi);
  const Vec2 along = at_angle(1, angle), across(-along.y(), along.x());
  const Vec2 middle = at_angle(random.uniform(0, 0.8), random.uniform(0, 2 * k_pi));
  std::vector<Vec2> line{offset + scale * (middle - 3 * along)};
  for (int i = 0; i < bends; ++i)
    line.push_back(offset + scale * (middle + (2.0 * (i + random.uniform()) / bends - 1) * along +
                                     random.normal() * 0.2 * across));
  line.push_back(offset + scale * (middle + 3 * along));
  return line;
}

inline const Vec2& vertex_of(const Outline& outline, int i) {
  return outline[static_cast<std::size_t>(i) % outline.size()];
}

/// A line through two vertices, or along an edge and beyond it, shifted sideways by `aside`.
inline std::vector<Vec2> line_by_vertices(const Outline& outline, bool edge, double aside, RandomStream& random) {
  const int n = static_cast<int>(outline.size()), i = whole(random, 0, n - 1);
  const Vec2 &a = vertex_of(outline, i), &b = vertex_of(outline, i + (edge ? 1 : whole(random, 1, n - 1)));
  const Vec2 along = b - a, across = Vec2(-along.y(), along.x()).normalized();
  const double beyond = random.uniform() < 0.5 ? 0 : random.uniform(0, 2);
  return {a - beyond * along + aside * across, b + beyond * along + aside * across};
}

inline Vec2 on_edge(const Outline& outline, RandomStream& random) {
  const int i = whole(random, 0, static_cast<int>(outline.size()) - 1);
  const double share = whole(random, 0, 3) == 0 ? 0 : random.uniform();
  return vertex_of(outline, i) + share * (vertex_of(outline, i + 1) - vertex_of(outline, i));
}

enum class CutClass {
  lines,
  polylines,
  many_lines,
  edge_to_edge,
  dangling,
  vertices,
  along_edges,
  tangents,
  tiny_edges,
  zero_segments,
  scales,
  far_off,
  self_crossing
};
constexpr int k_num_cut_classes = 13;
constexpr std::array<const char*, k_num_cut_classes> k_cut_class_names{
    "lines",        "polylines",    "many lines",    "edge to edge",  "dangling",  "through vertices", "along edges",
    "near tangent", "1e-9 m edges", "zero segments", "1e-6 .. 1e4 m", "1e6 m off", "self-crossing"};

/// Whether cracks of this class may enclose a piece of the floe, so that a refusal is correct.
inline bool may_enclose(CutClass kind) { return kind == CutClass::edge_to_edge || kind == CutClass::self_crossing; }

inline Lines random_cracks(CutClass kind, const Outline& outline, double scale, const Vec2& offset,
                           RandomStream& random) {
  Lines cracks;
  const auto through = [&](int bends) { cracks.push_back(through_line(random, scale, offset, bends)); };
  const auto inner = [&] { return Vec2(offset + scale * at_angle(random.uniform(0, 1), random.uniform(0, 7))); };
  switch (kind) {
    case CutClass::polylines:
      through(whole(random, 1, 6));
      break;
    case CutClass::many_lines:
      for (int k = whole(random, 2, 8); k > 0; --k) through(0);
      break;
    case CutClass::edge_to_edge:
      cracks.push_back({on_edge(outline, random), inner(), on_edge(outline, random)});
      break;
    case CutClass::dangling:
      cracks.push_back({on_edge(outline, random), inner()});
      cracks.push_back({inner(), inner()});
      through(whole(random, 0, 2));
      break;
    case CutClass::vertices:
    case CutClass::along_edges:
      for (int k = whole(random, 1, 3); k > 0; --k)
        cracks.push_back(line_by_vertices(outline, kind == CutClass::along_edges, 0, random));
      break;
    case CutClass::tangents:
      for (int k = whole(random, 1, 3); k > 0; --k)
        cracks.push_back(line_by_vertices(outline, whole(random, 0, 1) == 0,
                                          (random.uniform() < 0.5 ? -1 : 1) * magnitude(random, -15, -9), random));
      break;
    case CutClass::zero_segments: {
      through(2);
      auto& crack = cracks.back();
      crack.insert(crack.begin() + 1, crack[1]);
      crack.insert(crack.begin() + 1, {crack[0], crack[1], crack[0]});  // The crack also runs back on itself.
      cracks.push_back({inner()});
      cracks.emplace_back();
      break;
    }
    case CutClass::self_crossing:
      cracks.push_back({on_edge(outline, random)});
      for (int k = whole(random, 2, 8); k > 0; --k) cracks.back().push_back(inner());
      break;
    default:
      through(0);
      if (kind != CutClass::lines) cracks.push_back(line_by_vertices(outline, whole(random, 0, 1) == 0, 0, random));
  }
  return cracks;
}

inline CutCase cut_case(CutClass kind, RandomStream& random) {
  double scale = magnitude(random, -1, 2);
  Vec2 offset = Vec2::Zero();
  if (kind == CutClass::scales) scale = magnitude(random, -6, 4);
  if (kind == CutClass::far_off) offset = at_angle(1e6, random.uniform(0, 2 * k_pi));
  const bool runs = kind == CutClass::tiny_edges || kind == CutClass::along_edges || kind == CutClass::tangents;
  const auto shape = [&](RandomStream& r) { return runs ? with_runs(any_shape(r), 1e-9 / scale, r) : any_shape(r); };
  CutCase made{sound_outline(shape, scale, offset, random), {}};
  made.cracks = random_cracks(kind, made.outline, scale, offset, random);
  return made;
}

}  // namespace nilas::test
