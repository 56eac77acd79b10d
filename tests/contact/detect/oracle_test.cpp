/// Random pairs of prisms against brute force, class by class: the ones where a library's answer is known to fail
/// included.
#include <gtest/gtest.h>

#include <cmath>
#include <ostream>

#include "contact/detect/detector.h"
#include "tests/contact/detect/bodies_of_tests.h"
#include "tests/support/sat_oracle.h"

namespace nilas {
namespace {

enum class Attitude { any, nearly_flat, flat };

struct PairClass {
  const char* name;
  double size;       ///< radius of the outlines [m]
  double thickness;  ///< [m]
  Attitude attitude;
  double offset;   ///< of both bodies from the origin [m]
  double deepest;  ///< of the overlaps, in sizes
};

void PrintTo(const PairClass& c, std::ostream* out) { *out << c.name; }

constexpr double k_tilt = 0.02;

Quat attitude_of(const PairClass& c, RandomStream& random) {
  switch (c.attitude) {
    case Attitude::any:
      return random_attitude(random);
    case Attitude::nearly_flat:
      return random_tilt(random, k_tilt);
    default:
      return Quat(Eigen::AngleAxisd(random.uniform(0, 2 * k_pi), Vec3::UnitZ()));
  }
}

/// Direction in which B lies from A: around for half of the flat pairs, above or below for the others.
Vec3 direction_of(const PairClass& c, RandomStream& random) {
  Vec3 d(random.normal(), random.normal(), random.normal());
  if (c.attitude != Attitude::any) {
    if (random.uniform() < 0.5)
      d.z() = 0;
    else
      d = Vec3(0, 0, d.z());
  }
  return d.normalized();
}

/// A pair of bodies whose best axis over faces and edges separates them by exactly `target`, and all its axes.
struct PlacedPair {
  Bodies bodies;
  std::vector<oracle::SeparatingAxis> axes;  ///< best first
};

PlacedPair place(const PairClass& c, RandomStream& random) {
  PlacedPair placed;
  const Vec3 origin = c.offset * Vec3(1, -1, 0.5);
  for (int k = 0; k < 2; ++k)
    add_body(placed.bodies, floe_shape(random_outline(random, c.size), c.thickness),
             origin + 0.3 * c.size * k * Vec3(random.uniform(-1, 1), random.uniform(-1, 1), 0), attitude_of(c, random));
  const Vec3 d = direction_of(c, random);
  const double extent = c.size * std::pow(10.0, random.uniform(-4.3, std::log10(c.deepest)));
  const double target = random.uniform() < 0.5 ? -extent : extent;
  placed.axes = oracle::all_axes(oracle::posed(placed.bodies, 0), oracle::posed(placed.bodies, 1));
  double way = std::numeric_limits<double>::infinity();
  for (const auto& axis : placed.axes)
    if (axis.n.dot(d) > 1e-6) way = std::min(way, (target - axis.s) / axis.n.dot(d));
  placed.bodies.set_pose(1, placed.bodies.p_GB[1] + way * d, placed.bodies.q_GB[1]);
  for (auto& axis : placed.axes) axis.s += way * axis.n.dot(d);
  std::sort(placed.axes.begin(), placed.axes.end(), [](const auto& p, const auto& q) { return p.s > q.s; });
  return placed;
}

/// Height of a point over the surface of a solid: 0 on it.
double height_over(const oracle::Solid& solid, const Vec3& x) {
  double height = -std::numeric_limits<double>::infinity();
  for (std::size_t f = 0; f < solid.faces.size(); ++f)
    height = std::max(height, solid.normals[f].dot(x - solid.vertices[solid.faces[f][0]]));
  return height;
}

struct Tally {
  int in_contact = 0, missed = 0, normals_off = 0, surplus = 0;
  double worst_gap = 0, worst_surface = 0;  ///< in sizes
};

void judge(const PairClass& c, const PlacedPair& placed, double margin, const std::vector<ContactPoint>& points,
           Tally& tally) {
  const oracle::Solid a = oracle::posed(placed.bodies, 0), b = oracle::posed(placed.bodies, 1);
  const oracle::SeparatingAxis& best = placed.axes.front();
  const double truth = best.s > 0 ? oracle::distance(a, b) : best.s;
  if (truth >= margin) {
    tally.surplus += points.empty() ? 0 : 1;
    return;
  }
  ++tally.in_contact;
  if (points.empty()) {
    ++tally.missed;
    return;
  }
  double gap = points[0].gap;
  for (const ContactPoint& p : points) {
    gap = std::min(gap, p.gap);
    const double on_a = height_over(a, p.p - 0.5 * p.gap * p.n), on_b = height_over(b, p.p + 0.5 * p.gap * p.n);
    tally.worst_surface = std::max({tally.worst_surface, std::abs(on_a) / c.size, std::abs(on_b) / c.size});
  }
  tally.worst_gap = std::max(tally.worst_gap, std::abs(gap - truth) / c.size);
  const bool attains = oracle::separation(a, b, points[0].n) >= truth - 1e-9 * c.size;
  if (!attains && (best.s > 0 || points[0].n.dot(best.n) < std::cos(8 * k_deg))) ++tally.normals_off;
}

/// A detector that saw the pair a little apart from where it is now, and remembers the axis it had there.
ContactDetector saw_nearby(const PairClass& c, const Bodies& bodies, double margin, RandomStream& random) {
  const double nudge = std::pow(10.0, random.uniform(-5, -1));
  Bodies earlier = bodies;
  const Vec3 way(random.normal(), random.normal(), random.normal());
  const Quat turn(Eigen::AngleAxisd(nudge * random.normal(), Vec3(random.normal(), random.normal(), 1).normalized()));
  earlier.set_pose(1, bodies.p_GB[1] + 0.1 * nudge * std::min(c.size, c.thickness) * way, turn * bodies.q_GB[1]);
  ContactDetector detector;
  detector.detect(earlier, margin + 0.1 * nudge * c.size);
  return detector;
}

class OracleTest : public testing::TestWithParam<PairClass> {
 protected:
  /// `detector_for`: of bodies and margin.
  template <class Detector>
  void expect_truth(const Detector& detector_for) {
    const PairClass& c = GetParam();
    RandomStream random(7, c.name);
    constexpr int k_pairs = 3000;
    const double margin = 5e-4 * c.size;
    Tally tally;
    for (int k = 0; k < k_pairs; ++k) {
      const PlacedPair placed = place(c, random);
      ContactDetector detector = detector_for(placed.bodies, margin);
      judge(c, placed, margin, detector.detect(placed.bodies, margin), tally);
      kept_ += detector.counts().kept_axes;
    }
    RecordProperty("contacts", tally.in_contact);
    EXPECT_GT(tally.in_contact, k_pairs / 2);
    EXPECT_EQ(tally.missed, 0);
    EXPECT_EQ(tally.surplus, 0);
    EXPECT_EQ(tally.normals_off, 0);
    EXPECT_LT(tally.worst_gap, 1e-9);
    EXPECT_LT(tally.worst_surface, 1e-9);
  }

  long kept_ = 0;  ///< pairs that ended with the axis they had before
};

TEST_P(OracleTest, FindsTheBestAxisAndTheTrueGaps) {
  expect_truth([](const Bodies&, double) { return ContactDetector(); });
}

TEST_P(OracleTest, RememberedAxesAreFollowedOnlyWhileTheyAreTheBest) {
  RandomStream nudges(8, GetParam().name);
  expect_truth([&](const Bodies& bodies, double margin) { return saw_nearby(GetParam(), bodies, margin, nudges); });
  EXPECT_GT(kept_, 300);
}

INSTANTIATE_TEST_SUITE_P(Pairs, OracleTest,
                         testing::Values(PairClass{"unit_any_attitude", 1, 0.8, Attitude::any, 0, 1e-3},
                                         PairClass{"floes_nearly_flat", 1, 0.3, Attitude::nearly_flat, 0, 1e-3},
                                         PairClass{"plates_nearly_flat", 1, 0.01, Attitude::nearly_flat, 0, 1e-3},
                                         PairClass{"plates_flat", 1, 0.01, Attitude::flat, 0, 1e-3},
                                         PairClass{"plates_any_attitude", 1, 0.01, Attitude::any, 0, 1e-3},
                                         PairClass{"large_floes", 100, 1, Attitude::nearly_flat, 0, 1e-3},
                                         PairClass{"millimetre_scale", 1e-3, 3e-4, Attitude::nearly_flat, 0, 1e-3},
                                         PairClass{"millimetre_any_attitude", 1e-3, 8e-4, Attitude::any, 0, 1e-3},
                                         PairClass{"far_from_origin", 1, 0.3, Attitude::nearly_flat, 1e3, 1e-3},
                                         PairClass{"deep", 1, 0.3, Attitude::any, 0, 0.3},
                                         PairClass{"deep_plates", 1, 0.01, Attitude::nearly_flat, 0, 0.05}),
                         [](const auto& param_info) { return std::string(param_info.param.name); });

}  // namespace
}  // namespace nilas
