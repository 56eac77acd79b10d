/// A vessel on a carriage that is moved (1 - theta) h before the impulses and theta h after them: joints and paths.
#include <gtest/gtest.h>

#include <cmath>

#include "tests/core/vessel/example_vessel.h"

namespace nilas::vessel {
namespace vessel_moreau_carriage_test {

constexpr double k_h = 0.01;
constexpr double k_g = 9.81;
const std::array<bool, 6> k_none{}, k_heave{false, false, true, false, false, false},
    k_pitch{false, false, false, false, true, false}, k_heave_roll_pitch{false, false, true, true, true, false},
    k_surge{true, false, false, false, false, false};

const Wrench k_weight{{0, 0, -example::k_mass* k_g}, Vec3::Zero()};

const std::string k_track = "t_s,x_m,y_m,yaw_deg\n0,0,0,0\n1,0.5,0.1,30\n2,1.5,1.2,-20\n3,1.0,1.3,10\n";

VesselModel on_path(const std::string& file, BalanceKind balance, const std::array<bool, 6>& free, double theta) {
  VesselModel model = example::vessel();
  model.theta = theta;
  model.carriage = example::carriage(model, {1.5, 0.1, 0.5});
  model.carriage->balance = balance;
  model.carriage->free = free;
  const Vec3 start = model.pose_V.p + model.pose_V.q * model.carriage->joint_V;
  model.carriage->motion = CarriageMotion::path(start, 0.3, file);
  return model;
}

/// A vessel that the carriage holds altogether is where the carriage is at both ends and at the middle of every step.
TEST(VesselMoreauCarriage, FollowsItsMotionExactly) {
  const example::TemporaryFile track(k_track);
  for (const double theta : {0.5, 0.7, 1.0}) {
    const VesselModel model = on_path(track.path(), BalanceKind::rigid, k_none, theta);
    VesselSystem system(model, -0.1);  // at rest before the first row
    const auto verify = [&](double t) {
      const CarriageMotion::State c = model.carriage->motion.at(t);
      const Quat q = Quat(Eigen::AngleAxisd(c.yaw - 0.3, Vec3::UnitZ())) * model.pose_V.q;
      const Vec3 arm = q * (model.mass.com - model.carriage->joint_V), w(0, 0, c.yaw_rate);
      ASSERT_LT((system.state().pose.p - c.p - arm).norm(), 1e-13);
      ASSERT_LT(system.state().pose.q.angularDistance(q), 1e-13);
      ASSERT_LT((system.state().v - c.v - w.cross(arm)).norm(), 1e-13);
      ASSERT_LT((system.state().w - w).norm(), 1e-13);
    };
    for (int i = 0; i < 330; ++i) {
      const double t = system.time();
      verify(t);
      system.move_before_impulses(k_h);
      verify(t + (1 - theta) * k_h);
      system.begin({}, k_h);
      system.finish({{1, 2, 3}, {4, 5, 6}});
    }
  }
}

/// The solver's velocities from the block lead from one middle pose to the next.
TEST(VesselMoreauCarriage, MeanSpeedsLeadToTheNextMiddlePose) {
  for (const BalanceKind balance : {BalanceKind::rigid, BalanceKind::six_cells, BalanceKind::prismatic})
    for (const double theta : {0.5, 0.7, 1.0}) {
      VesselModel model = example::vessel();
      model.theta = theta;
      model.carriage = example::carriage(model, {1.5, 0.1, 0.5});
      model.carriage->balance = balance;
      model.carriage->free = k_heave;
      const Vec3 start = model.pose_V.p + model.pose_V.q * model.carriage->joint_V;
      model.carriage->motion = CarriageMotion::straight(start, 0.3, 0.7, 0.8, 1, 0);
      VesselSystem system(model, 0);
      RandomStream random(7, "block");
      Pose last;
      Vec6 twist = Vec6::Zero();
      for (int i = 0; i < 200; ++i) {
        system.move_before_impulses(k_h);
        const Pose pose = system.state().pose;
        if (i > 0) {
          ASSERT_LT(((pose.p - last.p) / k_h - twist.head<3>()).norm(), 1e-6) << i;
          const Eigen::AngleAxisd turn(pose.q * last.q.conjugate());
          ASSERT_LT((turn.angle() / k_h * turn.axis() - twist.tail<3>()).norm(), 1e-6) << i;
        }
        last = pose;
        const Wrench impulse = example::random_wrench(random, 0.5);
        Vec6 r;
        r << impulse.force, impulse.torque;
        const VesselBlock block = system.begin(example::random_wrench(random, 30), k_h);
        twist = block.hull.prescribed;
        if (block.f.size() > 0)
          twist += block.hull.jacobian * block.mass.llt().solve(block.f + block.hull.jacobian.transpose() * r);
        system.finish(impulse);
      }
    }
}

TEST(VesselMoreauCarriage, HeaveFreeFallsExactlyAndTransmitsNothing) {
  for (const BalanceKind balance : {BalanceKind::rigid, BalanceKind::prismatic, BalanceKind::six_cells}) {
    VesselModel model = example::carried(balance, k_heave);
    model.theta = 0.5;
    VesselSystem system(model, 0);
    const double z = system.state().pose.p.z();
    for (int i = 1; i <= 100; ++i) {
      example::step(system, k_weight, k_h);
      const double t = k_h * i;
      ASSERT_NEAR(system.state().v.z(), -k_g * t, 1e-10);
      ASSERT_NEAR(system.state().pose.p.z(), z - 0.5 * k_g * t * t, 1e-10);
      ASSERT_LT(std::abs(system.carriage_loads().about_joint.force.z()), 1e-9 * example::k_mass * k_g);
    }
  }
}

/// A surge-free vessel stays where it is while the carriage starts, runs up and goes on: only the two kinks show, by
/// h^2 a / 8 each.
TEST(VesselMoreauCarriage, ARampLeavesAFreeAxisAtRest) {
  VesselModel model = example::vessel();
  model.theta = 0.5;
  model.carriage = example::carriage(model, model.mass.com);
  model.carriage->free = k_surge;
  const Vec3 start = model.pose_V.p + model.pose_V.q * model.carriage->joint_V;
  model.carriage->motion = CarriageMotion::straight(start, 0.3, 0.6, 0.3, 2, 0);
  VesselSystem system(model, 0);
  for (int i = 0; i < 300; ++i) {
    example::step(system, Wrench{}, k_h);
    ASSERT_LT(system.state().v.norm(), 1e-13);
    ASSERT_LT((system.state().pose.p - start).norm(), 0.3 * k_h * k_h / 8 + 1e-12);
  }
}

/// A vessel hung above its centre of mass with free pitch, let go at rest: a physical pendulum of the period
/// 4 sqrt(I / (m g l)) K(sin(amplitude / 2)).
class VesselMoreauPendulum : public testing::TestWithParam<BalanceKind> {
 protected:
  static constexpr double k_length = 1.2, k_inertia = 900 + example::k_mass * k_length * k_length;
  static constexpr double k_scale = example::k_mass * k_g * k_length;

  static VesselModel pendulum(double amplitude, double theta) {
    VesselModel model = example::vessel();
    model.theta = theta;
    model.mass.inertia = Vec3(60, 900, 930).asDiagonal();
    model.pose_V = {Quat(Eigen::AngleAxisd(amplitude, Vec3::UnitY())), Vec3::Zero()};
    const Vec3 joint_V = model.mass.com + Vec3(0, 0, k_length);
    model.carriage = example::carriage(model, joint_V);
    model.carriage->motion = CarriageMotion::straight(model.pose_V.q * joint_V, 0, 0, 0, 0, 0);
    model.carriage->balance = GetParam();
    model.carriage->stiffness = 1e9;
    model.carriage->damping = 1e6;
    model.carriage->free = k_pitch;
    return model;
  }
  static double exact_period(double amplitude) {
    return 4 * std::sqrt(k_inertia / k_scale) * std::comp_ellint_1(std::sin(0.5 * amplitude));
  }
  /// Pitch from the lowest position, and its rate.
  static Vec2 swing(const VesselState& s) { return {2 * std::atan2(s.pose.q.y(), s.pose.q.w()), s.w.y()}; }
  static double energy(const VesselState& s) {
    const Vec2 x = swing(s);
    return 0.5 * k_inertia * x[1] * x[1] + k_scale * (1 - std::cos(x[0]));
  }
};

TEST_P(VesselMoreauPendulum, ItsPeriodIsOfSecondOrder) {
  for (const double amplitude : {1e-3, 1.2}) {
    const double exact = exact_period(amplitude);
    const auto error = [&](double h) {
      VesselSystem system(pendulum(amplitude, 0.5), 0);
      // the last of ten upward crossings of the lowest position
      int crossings = 0;
      double time = 0;
      Vec2 before = swing(system.state());
      while (crossings < 10) {
        example::step(system, k_weight, h);
        const Vec2 after = swing(system.state());
        if (before[0] < 0 && after[0] >= 0) {
          ++crossings;
          // between rows the pitch is a cubic of its values and rates
          double s = before[0] / (before[0] - after[0]);
          for (int pass = 0; pass < 20; ++pass) {
            const double f = before[0] * (1 + 2 * s) * (1 - s) * (1 - s) + h * before[1] * s * (1 - s) * (1 - s) +
                             after[0] * s * s * (3 - 2 * s) - h * after[1] * s * s * (1 - s);
            s -= f / (after[0] - before[0]);
          }
          time = system.time() - h * (1 - s);
        }
        before = after;
      }
      return std::abs(time / 9.75 - exact);
    };
    const double coarse = error(0.04), half = error(0.02), fine = error(0.01);
    // small swings are those of the implicit midpoint rule, whose period is longer by the share (omega h)^2 / 12
    if (amplitude < 1) {
      EXPECT_NEAR(fine / exact / (1e-4 * k_scale / k_inertia / 12), 1, 0.03);
    } else {
      EXPECT_LT(fine / exact, 4e-5);
    }
    EXPECT_NEAR(std::log2(coarse / half), 2, 0.1) << amplitude;
    EXPECT_NEAR(std::log2(half / fine), 2, 0.1) << amplitude;
  }
}

/// The energy returns in every swing of 100 periods and departs by no more than O(h^2), except for the damping of the
/// cells. The joint transmits no moment about its own pitch axis, which the cells let move.
TEST_P(VesselMoreauPendulum, ItsEnergyIsBounded) {
  const double amplitude = 1.2, period = exact_period(amplitude), start = k_scale * (1 - std::cos(amplitude));
  const bool has_cells = GetParam() == BalanceKind::six_cells;
  const auto departure = [&](double h, double duration) {
    VesselSystem system(pendulum(amplitude, 0.5), 0);
    double early = 0, late = 0, moment = 0;
    while (system.time() < duration) {
      const VecX before = system.coordinates();
      example::step(system, k_weight, h);
      const double error = std::abs(energy(system.state()) / start - 1);
      if (system.time() < 5 * period) early = std::max(early, error);
      if (system.time() > duration - 5 * period) late = std::max(late, error);
      const Wrench& read = system.carriage_loads().about_joint;
      const Vec3 moved = has_cells ? Vec3(0.5 * (before + system.coordinates()).segment<3>(3)) : Vec3(Vec3::Zero());
      moment = std::max(moment, std::abs((read.torque - moved.cross(read.force)).y()));
    }
    EXPECT_LT(moment, 1e-9 * k_scale);
    return Vec2(early, late);
  };
  const Vec2 coarse = departure(0.02, 100 * period), fine = departure(0.01, 10 * period);
  EXPECT_LT(fine[0], 2e-4);
  if (has_cells) {
    EXPECT_LT(coarse[1], 2e-3);
    return;
  }
  EXPECT_NEAR(coarse[1] / coarse[0], 1, 1e-2);
  EXPECT_NEAR(coarse[0] / fine[0], 4, 0.1);
}

/// The swing with theta above 1/2 loses the share (theta - 1/2) h omega^2 of its energy per second.
TEST_P(VesselMoreauPendulum, LargerThetasLoseEnergy) {
  const double amplitude = 1e-3, start = k_scale * (1 - std::cos(amplitude)), duration = 40;
  for (const double theta : {0.5, 0.7, 1.0}) {
    VesselSystem system(pendulum(amplitude, theta), 0);
    example::run(system, k_weight, k_h, static_cast<int>(std::lround(duration / k_h)));
    const double loss = (theta - 0.5) * k_h * k_scale / k_inertia * duration;
    EXPECT_NEAR(std::log(energy(system.state()) / start), -loss, 0.02 * loss + 2e-4) << theta;
  }
}

INSTANTIATE_TEST_SUITE_P(Balances, VesselMoreauPendulum, testing::Values(BalanceKind::rigid, BalanceKind::six_cells),
                         [](const auto& instance) {
                           return instance.param == BalanceKind::rigid ? "rigid" : "six_cells";
                         });

/// Heave, roll and pitch on a turning and accelerating carriage converge in second order.
TEST(VesselMoreauCarriage, FreeAxesConvergeInSecondOrder) {
  const example::TemporaryFile track(k_track);
  for (const BalanceKind balance : {BalanceKind::rigid, BalanceKind::six_cells}) {
    VesselModel model = on_path(track.path(), balance, k_heave_roll_pitch, 0.5);
    model.carriage->stiffness = 2e5;
    model.carriage->damping = 2e4;
    const auto end = [&](double h) {
      VesselSystem system(model, 0.25);
      for (int i = 0; i < static_cast<int>(std::lround(0.5 / h)); ++i)
        example::step_under(
            system,
            [](const VesselState& s) {
              return Wrench{{20, -10, 30}, {40 * s.pose.p.x(), -30, 10}};
            },
            h);
      return system.state();
    };
    const VesselState fine = end(1e-4), coarse = end(4e-3), half = end(2e-3);
    EXPECT_NEAR((coarse.pose.p - fine.pose.p).norm() / (half.pose.p - fine.pose.p).norm(), 4, 0.2);
    EXPECT_NEAR(coarse.pose.q.angularDistance(fine.pose.q) / half.pose.q.angularDistance(fine.pose.q), 4, 0.2);
    EXPECT_NEAR((coarse.v - fine.v).norm() / (half.v - fine.v).norm(), 4, 0.2);
    EXPECT_NEAR((coarse.w - fine.w).norm() / (half.w - fine.w).norm(), 4, 0.2);
  }
}

/// The speeds by Simbody's equations of motion at the middle pose and those by the momenta of both ends differ by
/// O(h^3): inertia forces of the carriage, Coriolis terms and Jacobians fit together.
TEST(VesselMoreauCarriage, EquationsOfMotionAndMomentaAgree) {
  const example::TemporaryFile track(k_track);
  const VesselModel model = on_path(track.path(), BalanceKind::rigid, k_heave_roll_pitch, 0.5);
  const auto largest_difference = [&](double h) {
    VesselSystem system(model, 0.25);
    double largest = 0;
    for (int i = 0; i < static_cast<int>(std::lround(0.5 / h)); ++i) {
      const double t = system.time();
      const VesselBlock block = example::step(system, {{20, -10, 30 * std::sin(t)}, {40 * std::cos(t), -30, 10}}, h);
      const VecX by_forces = block.mass.llt().solve(block.f);
      largest = std::max(largest, (by_forces - system.coordinates().tail(by_forces.size())).norm());
    }
    return largest;
  };
  EXPECT_NEAR(largest_difference(0.01) / largest_difference(0.005), 8, 1);
}

/// The carriage turns at a constant rate: centripetal force m w^2 r, torque w x I w, read at the middle of the step.
TEST(VesselMoreauCarriage, TurningCarriageGivesCentripetalLoad) {
  const example::TemporaryFile track("t_s,x_m,y_m,yaw_deg\n0,0,0,0\n10,0,0,360\n");
  const double w = 2 * k_pi / 10;
  VesselModel model = example::vessel();
  model.theta = 0.5;
  const Vec3 joint_V = model.mass.com + Vec3(-1.4, 0, 0.3);
  model.carriage = example::carriage(model, joint_V);
  const Vec3 start = model.pose_V.p + model.pose_V.q * joint_V;
  model.carriage->motion = CarriageMotion::path(start, 0.3, track.path());
  const auto errors = [&](double h) {
    VesselSystem system(model, 0);
    example::run(system, {}, h, static_cast<int>(std::lround(5 / h)));
    const Quat q = Quat(Eigen::AngleAxisd(-0.5 * h * w, Vec3::UnitZ())) * system.state().pose.q;
    const Vec3 spin(0, 0, w);
    const Vec3 centripetal = example::k_mass * spin.cross(spin.cross(q * Vec3(1.4, 0, 0)));
    const Vec3 gyroscopic = spin.cross(q * (model.mass.inertia * (q.conjugate() * spin)));
    const Vec3 moment = gyroscopic + (q * Vec3(1.4, 0, -0.3)).cross(centripetal);
    const CarriageLoads& loads = system.carriage_loads();
    return Vec3((loads.about_com.force - centripetal).norm() / centripetal.norm(),
                (loads.about_com.torque - gyroscopic).norm() / gyroscopic.norm(),
                (loads.about_joint.torque - moment).norm() / moment.norm());
  };
  const Vec3 coarse = errors(0.02), fine = errors(0.01);
  EXPECT_LT(fine.maxCoeff(), 1e-5);
  for (int i = 0; i < 3; ++i) EXPECT_NEAR(coarse[i] / fine[i], 4, 0.1);
}

/// A carriage that leaves everything free moves the vessel as if it were not there, to the order of the scheme.
TEST(VesselMoreauCarriage, OneThatHoldsNothingIsNone) {
  const auto distance = [](double h) {
    VesselModel free = example::vessel();
    VesselModel carried = example::carried(BalanceKind::rigid, {true, true, true, true, true, true});
    free.theta = carried.theta = 0.5;
    VesselSystem a(free, 0), b(carried, 0);
    for (int i = 0; i < static_cast<int>(std::lround(1 / h)); ++i) {
      for (VesselSystem* system : {&a, &b}) example::step(*system, {{30, -20, 10}, {5, 80, -60}}, h);
      EXPECT_LT(b.carriage_loads().about_com.force.norm() + b.carriage_loads().about_com.torque.norm(), 1e-9);
      EXPECT_LT((a.state().pose.p - b.state().pose.p).norm(), 1e-12);
    }
    return (a.state().w - b.state().w).norm() + a.state().pose.q.angularDistance(b.state().pose.q);
  };
  const double coarse = distance(0.02), fine = distance(0.01);
  EXPECT_LT(fine, 1e-4);
  EXPECT_NEAR(coarse / fine, 4, 0.3);
}

/// The motion with theta 1 is that of semi-implicit Euler if no axis of the joint turns. Otherwise the joint's
/// condition halfway instead of at the end makes a difference of first order.
TEST(VesselMoreauCarriage, ThetaOneIsSemiImplicitEuler) {
  const auto largest_difference = [](BalanceKind balance, const std::array<bool, 6>& free, double h) {
    VesselModel euler = example::carried(balance, free), moreau = euler;
    moreau.theta = 1;
    VesselSystem a(euler, 0), b(moreau, 0);
    double largest = 0;
    for (int i = 0; i < static_cast<int>(std::lround(1 / h)); ++i) {
      for (VesselSystem* system : {&a, &b}) example::step(*system, {{30, -20, 10}, {5, 80, -60}}, h);
      largest = std::max(largest, (a.coordinates() - b.coordinates()).norm());
    }
    return largest;
  };
  EXPECT_LT(largest_difference(BalanceKind::rigid, k_heave, k_h), 1e-13);
  EXPECT_LT(largest_difference(BalanceKind::six_cells, k_heave, k_h), 1e-8);  // the cells' deflections turn the axes
  const double coarse = largest_difference(BalanceKind::rigid, k_heave_roll_pitch, 0.01);
  const double fine = largest_difference(BalanceKind::rigid, k_heave_roll_pitch, 0.005);
  EXPECT_NEAR(coarse / fine, 2, 0.3);
}

/// Everything turned about the vertical gives the turned motion and the same readings.
TEST(VesselMoreauCarriage, ATurnedFrameGivesTheTurnedMotion) {
  const double yaw = 1.1;
  const Quat turn(Eigen::AngleAxisd(yaw, Vec3::UnitZ()));
  VesselModel model = example::vessel(), turned = model;
  turned.pose_V = {turn * model.pose_V.q, turn * model.pose_V.p};
  const auto hang = [](VesselModel& m, double heading) {
    m.theta = 0.5;
    m.carriage = example::carriage(m, {1.5, 0.1, 0.5});
    const Vec3 start = m.pose_V.p + m.pose_V.q * m.carriage->joint_V;
    m.carriage->balance = BalanceKind::six_cells;
    m.carriage->free = k_heave_roll_pitch;
    m.carriage->motion = CarriageMotion::straight(start, heading, 0.7, heading + 0.5, 1, 0);
  };
  hang(model, 0.3);
  hang(turned, 0.3 + yaw);
  VesselSystem a(model, 0), b(turned, 0);
  RandomStream random(9, "frame");
  for (int i = 0; i < 200; ++i) {
    const Wrench load = example::random_wrench(random, 100), impulse = example::random_wrench(random, 1);
    example::step(a, load, k_h, impulse);
    example::step(b, {turn * load.force, turn * load.torque}, k_h, {turn * impulse.force, turn * impulse.torque});
    ASSERT_LT((turn * a.state().pose.p - b.state().pose.p).norm(), 1e-12);
    ASSERT_LT((a.coordinates() - b.coordinates()).norm(), 1e-10);
    for (std::size_t c = 0; c < 6; ++c) ASSERT_NEAR(a.carriage_loads().cells[c], b.carriage_loads().cells[c], 1e-7);
  }
}

}  // namespace vessel_moreau_carriage_test
}  // namespace nilas::vessel
