#pragma once
/// Judges the contacts found for a pair against the oracle and tallies the errors by class.
#include <algorithm>
#include <array>
#include <limits>

#include "contact/detect/detector.h"
#include "tests/support/collision/pair_placing.h"

namespace nilas::pairs {

/// Largest angle between a contact normal and the true one [rad]. A normal further off is wrong unless it separates as
/// well.
constexpr double k_wrong_normal = 8 * k_deg;
/// Largest error of a correct depth or distance: this share of the size, or so many units in the last place of the
/// coordinates.
constexpr double k_right_depth = 1e-9, k_right_ulps = 4;
/// Margin of the search as a share of the size: gaps below it are contacts.
constexpr double k_margin = 5e-4;

/// Spacing of doubles at x.
inline double ulp(double x) { return std::nextafter(std::abs(x), oracle::k_infinite) - std::abs(x); }

/// Two convex pieces with their true gap.
struct PartsInQuestion {
  oracle::Solid a, b;
  oracle::SeparatingAxis gap;
};

/// A pair of bodies with the true gaps between all their convex pieces.
struct KnownPair {
  bodies::Bodies bodies;
  std::vector<PartsInQuestion> parts;
  double size = 1, ulp = 0;  ///< Size of the smaller body, and spacing of doubles at the farthest coordinate [m].
  double right() const { return std::max(k_right_depth * size, k_right_ulps * ulp); }
};

/// Height of a point over the surface of a solid: 0 on it, negative inside [m].
inline double height_over(const oracle::Solid& solid, const Vec3& x) {
  double height = -oracle::k_infinite;
  for (std::size_t f = 0; f < solid.normals.size(); ++f)
    height = std::max(height, solid.normals[f].dot(x) - solid.extent(solid.normals[f]));
  if (!oracle::is_round(solid)) return height;
  const Vec3 from_axis = x - solid.vertices[0];
  return std::max(height, (from_axis - from_axis.dot(solid.axis) * solid.axis).norm() - solid.radius);
}

inline KnownPair find_truth(const PairClass& c, bodies::Bodies bodies) {
  KnownPair known;
  const auto of_a = solids_of(bodies, 0), of_b = solids_of(bodies, 1);
  for (std::size_t i = 0; i < of_a.size(); ++i)
    for (std::size_t j = 0; j < of_b.size(); ++j) {
      known.parts.push_back({of_a[i], of_b[j], oracle::true_gap(of_a[i], of_b[j], 2 * k_margin * c.size)});
    }
  const double farthest = std::max(bodies.p_GB[0].lpNorm<Eigen::Infinity>(), bodies.p_GB[1].lpNorm<Eigen::Infinity>());
  known.size = c.size;
  known.ulp = ulp(farthest + std::max(reach(*bodies.shape[0]), reach(*bodies.shape[1])));
  known.bodies = std::move(bodies);
  return known;
}

struct Tally {
  long pairs = 0;
  long contacts = 0;       ///< Pairs of convex pieces nearer than the margin.
  long missed = 0;         ///< Contacts for which no point was found.
  long surplus = 0;        ///< Pairs of convex pieces with a point although they are not nearer than the margin.
  long wrong_normals = 0;  ///< Wrong normals of the deepest point.
  long ties = 0;           ///< Normals other than the oracle's that separate as well as it.
  long unjudged = 0;       ///< Overlapping bodies of several convex pieces: only a miss is an error there.
  long wrong_depths = 0;
  double worst_depth = 0;    ///< Largest error of the deepest point's gap over the size.
  double worst_ulps = 0;     ///< The same error in units in the last place of the coordinates.
  double worst_surface = 0;  ///< Largest distance of a point from either surface over the size.
  long kept_axes = 0;

  Tally& operator+=(const Tally& other) {
    for (auto count : {&Tally::pairs, &Tally::contacts, &Tally::missed, &Tally::surplus, &Tally::wrong_normals,
                       &Tally::ties, &Tally::unjudged, &Tally::wrong_depths, &Tally::kept_axes})
      this->*count += other.*count;
    for (auto worst : {&Tally::worst_depth, &Tally::worst_ulps, &Tally::worst_surface})
      this->*worst = std::max(this->*worst, other.*worst);
    return *this;
  }
};

/// The contact that a search reports for a pair of convex pieces: the normal and gap [m] of the deepest point.
struct Verdict {
  Vec3 n = Vec3::UnitX();
  double gap = 0;
};

/// Judges the normal and the gap found for convex pieces that touch.
inline void judge_verdict(const KnownPair& known, const PartsInQuestion& parts, const Verdict& found, Tally& tally) {
  // The true gap is at least the separation along the normal found, whatever that normal is.
  const double along = oracle::separation(parts.a, parts.b, found.n);
  const double truth = std::max(parts.gap.s, along);
  if (found.n.dot(parts.gap.n) < std::cos(k_wrong_normal))
    ++(along >= truth - known.right() ? tally.ties : tally.wrong_normals);
  const double error = std::abs(found.gap - truth);
  tally.wrong_depths += error > known.right() ? 1 : 0;
  tally.worst_depth = std::max(tally.worst_depth, error / known.size);
  tally.worst_ulps = std::max(tally.worst_ulps, error / known.ulp);
}

inline void judge_surfaces(const KnownPair& known, const PartsInQuestion& parts, const detect::ContactPoint& point,
                           Tally& tally) {
  const Vec3 p = point.p - known.bodies.p_GB[0];
  const double off = std::max(std::abs(height_over(parts.a, p - 0.5 * point.gap * point.n)),
                              std::abs(height_over(parts.b, p + 0.5 * point.gap * point.n)));
  tally.worst_surface = std::max(tally.worst_surface, off / known.size);
}

inline const detect::ContactPoint* deepest_point(const std::vector<detect::ContactPoint>& points) {
  const auto by_gap = [](const detect::ContactPoint& p, const detect::ContactPoint& q) { return p.gap < q.gap; };
  return points.empty() ? nullptr : &*std::min_element(points.begin(), points.end(), by_gap);
}

/// The normal to be judged. Points on a curved side have normals of their own: among the points as deep as the deepest,
/// the normal nearest to the true one counts.
inline Vec3 normal_of(const KnownPair& known, const PartsInQuestion& parts, const detect::ContactPoint& deepest,
                      const std::vector<detect::ContactPoint>& points) {
  Vec3 n = deepest.n;
  for (const detect::ContactPoint& p : points)
    if (p.gap <= deepest.gap + known.right() && p.n.dot(parts.gap.n) > n.dot(parts.gap.n)) n = p.n;
  return n;
}

/// Judges bodies of several convex pieces as wholes. When they are apart, their nearest pieces give distance and
/// direction. The depth of an overlap of such bodies has no closed form here: then only a miss is wrong.
inline void judge_bodies(const KnownPair& known, double margin, const std::vector<detect::ContactPoint>& points,
                         Tally& tally) {
  const auto by_gap = [](const auto& p, const auto& q) { return p.gap.s < q.gap.s; };
  const double truth = std::min_element(known.parts.begin(), known.parts.end(), by_gap)->gap.s;
  if (points.empty()) tally.missed += truth < margin - known.right() ? 1 : 0;
  if (!points.empty() && truth > margin + known.right()) ++tally.surplus;
  if (points.empty() || truth >= margin) return;
  ++tally.contacts;
  if (truth < known.right()) {
    ++tally.unjudged;
    return;
  }
  const detect::ContactPoint* deepest = deepest_point(points);
  const double error = std::abs(deepest->gap - truth);
  tally.wrong_depths += error > known.right() ? 1 : 0;
  tally.worst_depth = std::max(tally.worst_depth, error / known.size);
  tally.worst_ulps = std::max(tally.worst_ulps, error / known.ulp);
  tally.wrong_normals += std::none_of(known.parts.begin(), known.parts.end(), [&](const PartsInQuestion& parts) {
    return parts.gap.s <= truth + known.right() && deepest->n.dot(parts.gap.n) >= std::cos(k_wrong_normal);
  });
}

/// Judges all points that a detector found with gaps below `margin` [m].
inline void judge(const KnownPair& known, double margin, const std::vector<detect::ContactPoint>& points,
                  Tally& tally) {
  ++tally.pairs;
  if (known.parts.size() > 1) return judge_bodies(known, margin, points, tally);
  const PartsInQuestion& parts = known.parts.front();
  const detect::ContactPoint* deepest = deepest_point(points);
  if (deepest == nullptr && parts.gap.s < margin - known.right()) ++tally.missed;
  if (deepest != nullptr && parts.gap.s > margin + known.right()) ++tally.surplus;
  if (parts.gap.s >= margin || deepest == nullptr) return;
  ++tally.contacts;
  const Vec3 n = normal_of(known, parts, *deepest, points);
  judge_verdict(known, parts, {n, deepest->gap}, tally);
  for (const detect::ContactPoint& p : points)
    if (p.n == n) judge_surfaces(known, parts, p, tally);
}

/// A detector that saw the pair at a nearby relative pose and remembers the separating axis of that pose.
inline detect::ContactDetector saw_nearby(const KnownPair& known, double margin, NarrowPhase narrow,
                                          RandomStream& random) {
  const double nudge = std::pow(10.0, random.uniform(-5, -1));
  bodies::Bodies earlier = known.bodies;
  const Vec3 way(random.normal(), random.normal(), random.normal());
  const Quat turn(Eigen::AngleAxisd(nudge * random.normal(), Vec3(random.normal(), random.normal(), 1).normalized()));
  earlier.set_pose(1, earlier.p_GB[1] + 0.1 * nudge * known.size * way, turn * earlier.q_GB[1]);
  detect::ContactDetector detector(1, narrow);
  detector.detect(earlier, margin + 0.1 * nudge * known.size);
  return detector;
}

constexpr int k_batch = 1000;

/// Puts the class's batch number `batch` of pairs through two detectors: one that has never seen the pair, and one that
/// remembers it from a nearby pose.
inline std::array<Tally, 2> tally_batch(const PairClass& c, int batch, NarrowPhase narrow = NarrowPhase::nilas) {
  RandomStream random(7, c.name + std::string("/") + std::to_string(batch));
  std::array<Tally, 2> tallies;
  for (int k = 0; k < k_batch; ++k) {
    const KnownPair known = find_truth(c, draw_pair(c, random));
    const double margin = k_margin * c.size;
    judge(known, margin, detect::ContactDetector(1, narrow).detect(known.bodies, margin), tallies[0]);
    detect::ContactDetector remembering = saw_nearby(known, margin, narrow, random);
    judge(known, margin, remembering.detect(known.bodies, margin), tallies[1]);
    tallies[1].kept_axes += remembering.counts().kept_axes;
  }
  return tallies;
}

}  // namespace nilas::pairs
