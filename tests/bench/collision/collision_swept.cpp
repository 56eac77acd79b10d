/// Times of first contact on many random pairs: misses, false hits and errors against brute force, and time per pair.
/// The misses of FCL's own continuousCollide on the same pairs are counted as well.
/// usage: bench_collision_swept [pairs of all classes, 100000]; returns 1 when any result is wrong
#include <fcl/geometry/shape/convex.h>
#include <fcl/narrowphase/continuous_collision.h>
#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cstdlib>

#include "contact/detect/swept.h"
#include "tests/contact/detect/bodies_of_tests.h"
#include "tests/support/collision/swept_pairs.h"

namespace nilas::bench {
namespace {

using Clock = std::chrono::steady_clock;
double seconds_since(Clock::time_point start) { return std::chrono::duration<double>(Clock::now() - start).count(); }

detect::BodyMotion motion_of(const oracle::Way& way) { return {way.p, way.q.toRotationMatrix(), way.way, way.turn}; }

detect::Part part_of(const geometry::ConvexPolytope& polytope, bodies::Bodies& bodies) {
  geometry::Shape shape;
  shape.kind = geometry::ShapeKind::mesh;
  shape.parts = {polytope};
  shape.bounding_radius = polytope.centre.norm() + polytope.radius;
  return std::move(detect::make_parts(bodies, detect::add_body(bodies, shape, Vec3::Zero())).front());
}

struct Tally {
  int pairs = 0, missed = 0, false_hits = 0, late = 0;
  long advances = 0;
  int most_advances = 0;
  double worst_time = 0, seconds = 0;
};

/// Time of impact of one pair. Its shapes are made beforehand, as a detector keeps them.
detect::TimeOfImpact ask(const oracle::PairOnItsWay& pair, Tally& tally) {
  bodies::Bodies bodies;
  const detect::Part a = part_of(pair.a, bodies), b = part_of(pair.b, bodies);
  const detect::BodyMotion motion_a = motion_of(pair.way_a), motion_b = motion_of(pair.way_b);
  detect::FclShapes fcl;
  detect::AxisSearchRoom room;
  detect::time_of_impact(a, {motion_a.p, motion_a.R, Vec3::Zero(), Vec3::Zero()}, b,
                         // The first call makes FCL's geometry, outside of the timing.
                         {motion_b.p, motion_b.R, Vec3::Zero(), Vec3::Zero()}, fcl, room);
  const auto start = Clock::now();
  const detect::TimeOfImpact found = detect::time_of_impact(a, motion_a, b, motion_b, fcl, room);
  tally.seconds += seconds_since(start);
  tally.advances += found.advances;
  tally.most_advances = std::max(tally.most_advances, found.advances);
  return found;
}

fcl::Convexd fcl_convex(const geometry::ConvexPolytope& polytope) {
  auto faces = std::make_shared<std::vector<int>>();
  for (const auto& loop : polytope.faces) {
    faces->push_back(static_cast<int>(loop.size()));
    faces->insert(faces->end(), loop.begin(), loop.end());
  }
  fcl::Convexd convex(std::make_shared<std::vector<Vec3>>(polytope.vertices), static_cast<int>(polytope.faces.size()),
                      faces);
  convex.computeLocalAABB();
  return convex;
}

fcl::Transform3d pose(const oracle::Way& way, double t) {
  fcl::Transform3d pose = fcl::Transform3d::Identity();
  const double angle = t * way.turn.norm();
  const Quat turned = angle > 0 ? Quat(Eigen::AngleAxisd(angle, way.turn.normalized())) : Quat::Identity();
  pose.linear() = (turned * way.q).toRotationMatrix();
  pose.translation() = way.p + t * way.way;
  return pose;
}

/// Finds the same time by FCL's conservative advancement.
void ask_fcl(const oracle::PairOnItsWay& pair, bool turns, Tally& tally) {
  const fcl::Convexd a = fcl_convex(pair.a), b = fcl_convex(pair.b);
  fcl::ContinuousCollisionRequestd request(50, 1e-6);
  request.ccd_motion_type = turns ? fcl::CCDM_LINEAR : fcl::CCDM_TRANS;
  request.ccd_solver_type = fcl::CCDC_CONSERVATIVE_ADVANCEMENT;
  request.gjk_solver_type = fcl::GST_LIBCCD;
  fcl::ContinuousCollisionResultd result;
  const auto start = Clock::now();
  fcl::continuousCollide(&a, pose(pair.way_a, 0), pose(pair.way_a, 1), &b, pose(pair.way_b, 0), pose(pair.way_b, 1),
                         request, result);
  tally.seconds += seconds_since(start);
  ++tally.pairs;
  if (!result.is_collide) ++tally.missed;
}

/// Runs a class. True when no pair was missed, no passing pair was hit, and all times are right.
bool run(const oracle::PairClass& c, int pairs) {
  RandomStream hits(21, c.name), misses(22, c.name);
  Tally ours, fcl, passing;
  constexpr double k_time_tolerance = 1e-6;
  while (ours.pairs < pairs) {
    const oracle::PairOnItsWay pair = oracle::crossing_pair(c, hits);
    if (pair.separation_at(0) <= 0) continue;
    const detect::TimeOfImpact found = ask(pair, ours);
    const double truth = oracle::first_contact(pair).t;
    ++ours.pairs;
    if (!found.hit) {
      ++ours.missed;
    } else {
      const double error = std::abs(found.t - truth);
      ours.worst_time = std::max(ours.worst_time, error);
      if (!(error <= k_time_tolerance)) ++ours.late;
    }
    ask_fcl(pair, c.turn > 0, fcl);
  }
  while (passing.pairs < pairs) {
    const oracle::PairOnItsWay pair = oracle::passing_pair(c, misses);
    if (!oracle::first_contact(pair).certain_miss) continue;
    ++passing.pairs;
    if (ask(pair, passing).hit) ++passing.false_hits;
  }
  const double us = 1e6 / pairs;
  fmt::print("{:32} {:7} {:7} {:9.1e} {:6} {:7} {:7.1f} {:8.1f} {:8.1f} {:6} {:11.2f} {:8.1f}\n", c.name, ours.pairs,
             ours.missed, ours.worst_time, ours.late, passing.false_hits,
             static_cast<double>(ours.advances) / ours.pairs, us * ours.seconds, us * passing.seconds,
             std::max(ours.most_advances, passing.most_advances), 100.0 * fcl.missed / fcl.pairs, us * fcl.seconds);
  std::fflush(stdout);
  return ours.missed + ours.late + passing.false_hits == 0;
}

}  // namespace
}  // namespace nilas::bench

int main(int argc, char** argv) {
  const int pairs = argc > 1 ? std::atoi(argv[1]) : 100000;
  const auto classes = nilas::oracle::pair_classes();
  fmt::print("{:32} {:>7} {:>7} {:>9} {:>6} {:>7} {:>7} {:>8} {:>8} {:>6} {:>11} {:>8}\n", "class", "hits", "missed",
             "worst dt", ">1e-6", "false", "adv.", "us/hit", "us/miss", "most", "FCL miss %", "us");
  bool right = true;
  for (const auto& c : classes)
    right = nilas::bench::run(c, std::max(1, pairs / static_cast<int>(classes.size()))) && right;
  return right ? 0 : 1;
}
