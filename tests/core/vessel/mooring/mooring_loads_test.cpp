#include <gtest/gtest.h>

#include <cmath>

#include "core/base/error.h"
#include "tests/core/vessel/mooring/mooring_example.h"

namespace nilas::vessel {

namespace mooring_loads_test {

using example::unbroken;

/// Loads at rest, with the turret where its lines hold it.
Vec6 at_rest(const MooringModel& model, MooringState state, const Pose& pose) {
  state.turret_angle = turret_angle(model, state, pose);
  const Wrench load = mooring_loads(model, state, {pose}).on_hull;
  Vec6 all;
  all << load.force, load.torque;
  return all;
}

Pose moved(const Pose& pose, const Vec6& motion) {
  const Vec3 turn = motion.tail<3>();
  const double angle = turn.norm();
  Pose at = pose;
  at.p += motion.head<3>();
  if (angle > 0) at.q = Quat(Eigen::AngleAxisd(angle, turn / angle)) * pose.q;
  return at;
}

/// The stiffness is the derivative of the loads, measured by central differences, with and without a turret.
TEST(MooringLoads, HaveTheirStiffness) {
  for (const bool turret : {false, true}) {
    const MooringModel model = example::mooring(8, turret);
    const Pose pose = example::pose_of_hull();
    MooringState state = unbroken(model);
    state.turret_angle = turret_angle(model, state, pose);
    state.broken[2] = 1;
    state.turret_angle = turret_angle(model, state, pose);
    const Mat6 K = mooring_stiffness(model, state, pose);
    constexpr double k_move = 1e-5;  // [m, rad]
    for (int axis = 0; axis < 6; ++axis) {
      const Vec6 step = k_move * Vec6::Unit(axis);
      const Vec6 change = at_rest(model, state, moved(pose, step)) - at_rest(model, state, moved(pose, -step));
      EXPECT_LT((change / (2 * k_move) + K.col(axis)).norm(), 1e-5 * K.col(axis).norm()) << turret << ' ' << axis;
    }
  }
}

/// The whole set-up turned about the vertical turns the loads; rounding is all that differs.
TEST(MooringLoads, TurnWithTheirMooring) {
  for (const bool turret : {false, true}) {
    const MooringModel model = example::mooring(8, turret);
    const Pose pose = example::pose_of_hull();
    const Vec6 load = at_rest(model, unbroken(model), pose);
    for (const double angle : {0.7, 2.0, 4.5}) {
      const Quat turn(Eigen::AngleAxisd(angle, Vec3::UnitZ()));
      MooringModel turned = model;
      for (MooringLine& line : turned.lines) line.anchor = turn * line.anchor;
      const Vec6 found = at_rest(turned, unbroken(turned), {turn * pose.q, turn * pose.p});
      EXPECT_LT((found.head<3>() - turn * load.head<3>()).norm(), 1e-10 * load.head<3>().norm());
      EXPECT_LT((found.tail<3>() - turn * load.tail<3>()).norm(), 1e-10 * load.tail<3>().norm());
    }
  }
}

/// A mirror image in the plane y = 0 has mirrored forces (y changes sign) and torques (x and z do), to the last bit.
TEST(MooringLoads, AreMirroredWithTheirMooring) {
  const MooringModel model = example::mooring(8, true);
  MooringModel mirrored = model;
  for (MooringLine& line : mirrored.lines) {
    line.anchor.y() = -line.anchor.y();
    line.fairlead_B.y() = -line.fairlead_B.y();
  }
  const Quat q(Eigen::AngleAxisd(0.2, Vec3::UnitZ())), q_mirrored(Eigen::AngleAxisd(-0.2, Vec3::UnitZ()));
  const Vec6 load = at_rest(model, unbroken(model), {q, {4, -3, 1}});
  const Vec6 image = at_rest(mirrored, unbroken(mirrored), {q_mirrored, {4, 3, 1}});
  for (const int axis : {0, 2, 4}) EXPECT_EQ(image[axis], load[axis]) << axis;
  for (const int axis : {1, 3, 5}) EXPECT_EQ(image[axis], -load[axis]) << axis;
}

/// No work over a closed path: lines without friction and damping derive from a potential.
TEST(MooringLoads, DoNoWorkOverAClosedPath) {
  MooringModel model = example::mooring(6, true);
  for (MooringLine& line : model.lines) std::get<CatenaryLine>(line.form).bed_friction = 0;
  constexpr int k_steps = 400;
  double work = 0, gross = 0;
  Vec6 before = Vec6::Zero(), load_before = Vec6::Zero();
  for (int k = 0; k <= k_steps; ++k) {
    const double s = 2 * k_pi * k / k_steps;
    const Vec6 place{6 * std::sin(s), 4 * (1 - std::cos(s)), std::sin(2 * s), 0, 0, 0.2 * std::sin(s)};
    Pose pose{Quat(Eigen::AngleAxisd(place[5], Vec3::UnitZ())), place.head<3>()};
    const Vec6 load = at_rest(model, unbroken(model), pose);
    if (k > 0) {
      const double part = 0.5 * (load + load_before).dot(place - before);
      work += part;
      gross += std::abs(part);
    }
    before = place;
    load_before = load;
  }
  // The trapezoidal rule over a smooth closed path leaves much less than its step squared.
  EXPECT_LT(std::abs(work), 1e-4 * gross);
}

TEST(MooringLoads, GrowWithTheSpeedOfTheFairlead) {
  MooringModel model = example::mooring(1, false);
  model.lines[0].fairlead_B.setZero();
  const MooringState state = unbroken(model);
  const Vec3 still = mooring_loads(model, state, {}).on_hull.force, pull = still.normalized();
  model.lines[0].damping = 1e4;
  HullMotion away;
  away.v = -0.5 * pull;
  EXPECT_NEAR(mooring_loads(model, state, away).on_hull.force.dot(pull), still.norm() + 0.5 * 1e4, 1e-6);
  away.v = 1e6 * pull;
  EXPECT_EQ(mooring_loads(model, state, away).on_hull.force.norm(), 0);
}

/// All lines at the turret: whatever the hull's heading, a free turret passes no moment about its axis.
TEST(Turret, LetsTheHullWeathervane) {
  MooringModel model = example::mooring(6, true);
  for (MooringLine& line : model.lines) {
    line.on_turret = true;
    line.fairlead_B = model.turret->at_B + 5 * (line.anchor - Vec3(0, 0, -100)).normalized();
  }
  for (const double heading : {0.0, 0.5, -2.0, 3.1}) {
    const Pose pose{Quat(Eigen::AngleAxisd(heading, Vec3::UnitZ())),
                    -(Eigen::AngleAxisd(heading, Vec3::UnitZ()) * model.turret->at_B)};
    MooringState state = unbroken(model);
    state.turret_angle = turret_angle(model, state, pose);
    const MooringLoads loads = mooring_loads(model, state, {pose});
    const Vec3 centre = pose.q * model.turret->at_B;
    double greatest = 0;
    for (const double tension : loads.tensions) greatest = std::max(greatest, tension);
    EXPECT_NEAR((loads.on_hull.torque - centre.cross(loads.on_hull.force)).z(), 0, 1e-8 * greatest) << heading;
    // It keeps its heading over ground while the hull turns.
    EXPECT_NEAR(std::remainder(state.turret_angle + heading, 2 * k_pi),
                turret_angle(model, unbroken(model), {Quat::Identity(), -model.turret->at_B}), 1e-9);
  }
}

/// A turret with friction sticks to the hull up to its friction and passes just that moment beyond.
TEST(Turret, SticksByFriction) {
  MooringModel model = example::mooring(6, true);
  for (MooringLine& line : model.lines) {
    line.on_turret = true;
    line.fairlead_B = model.turret->at_B + 5 * (line.anchor - Vec3(0, 0, -100)).normalized();
  }
  MooringState state = unbroken(model);
  const auto at = [&](double heading) {
    return Pose{Quat(Eigen::AngleAxisd(heading, Vec3::UnitZ())),
                -(Eigen::AngleAxisd(heading, Vec3::UnitZ()) * model.turret->at_B)};
  };
  const auto moment = [&](double angle, double heading) {
    MooringState held = state;
    held.turret_angle = angle;
    const Pose pose = at(heading);
    const Wrench load = mooring_loads(model, held, {pose}).on_hull;
    return (load.torque - (pose.q * model.turret->at_B).cross(load.force)).z();
  };
  state.turret_angle = turret_angle(model, state, at(0));
  const double stuck = moment(state.turret_angle, 0.01);
  model.turret->friction = 1.1 * std::abs(stuck);
  EXPECT_EQ(turret_angle(model, state, at(0.01)), state.turret_angle);
  model.turret->friction = 0.5 * std::abs(stuck);
  const double slipped = turret_angle(model, state, at(0.01));
  EXPECT_NE(slipped, state.turret_angle);
  EXPECT_NEAR(moment(slipped, 0.01), 0.5 * stuck, 1e-6 * std::abs(stuck));
}

}  // namespace mooring_loads_test

}  // namespace nilas::vessel
