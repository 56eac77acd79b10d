/// Rods between a vessel and fixed points: closed forms, momenta, energy, lengths, and the bits.
#include <cmath>

#include "core/numerics/event_ode.h"
#include "tests/core/vessel/tree/rod_example.h"

namespace nilas::vessel {
namespace jointed_rods_test {

const std::vector<std::optional<double>> k_schemes{std::nullopt, 0.5};

TEST(JointedRods, HeldAtItsCentreOfMassAVesselCirclesWithTheTensionOfTheClosedForm) {
  for (const auto theta : k_schemes) {
    VesselModel model = example::vessel();
    model.theta = theta;
    const Vec3 start = model.pose_V.p + model.pose_V.q * model.mass.com;
    const double length = 5, speed = 1.5;
    model.rods.push_back({"tie", -1, model.mass.com, start + Vec3(length, 0, 0), length});
    model.v = Vec3(0, speed, 0);
    VesselSystem system(model, 0);
    for (int k = 0; k < 500; ++k) {
      example::step(system, std::vector<Wrench>(1), 0.01);
      ASSERT_NEAR(example::rod_length(model, system), length, 1e-14 * length);
    }
    const double tension = model.mass.mass * speed * speed / length, angle = speed / length * 5;
    EXPECT_NEAR(system.joint_account().rods[0], tension, 1e-10 * tension);
    EXPECT_NEAR(system.state().v.norm(), speed, 1e-12);
    const Vec3 end = model.rods[0].to_G + length * Vec3(-std::cos(angle), std::sin(angle), 0);
    EXPECT_LT((system.state().pose.p - end).norm(), 1e-9);
  }
}

TEST(JointedRods, HeldOffItsCentreOfMassAVesselCirclesAsOneWithItsRod) {
  // in line with the rod, turning with it about a principal axis: the centre of mass has m W^2 (L + c)
  for (const auto theta : k_schemes) {
    VesselModel model;
    model.theta = theta;
    model.mass.mass = 80;
    model.mass.inertia = Vec3(10, 30, 35).asDiagonal();
    const double length = 3, offset = 0.8, turn = 0.6;
    model.rods.push_back({"tie", -1, Vec3(offset, 0, 0), Vec3(offset + length, 0, 0), std::nullopt});
    model.w = {0, 0, turn};
    model.v = model.w.cross(-model.rods[0].to_G);
    VesselSystem system(model, 0);
    for (int k = 0; k < 300; ++k) example::step(system, std::vector<Wrench>(1), 0.01);
    const double tension = 80 * turn * turn * (length + offset);
    EXPECT_NEAR(system.joint_account().rods[0], tension, 1e-8 * tension);
    EXPECT_NEAR(system.state().w.z(), turn, 1e-9);
    EXPECT_NEAR((system.state().pose.p - model.rods[0].to_G).norm(), length + offset, 1e-9);
  }
}

/// Hull under weight on a rod in one plane: a double pendulum whose upper bar has no mass, by CVODE.
TEST(JointedRods, SwingAsADoublePendulumWithoutMassInItsUpperBar) {
  const double length = 1.2, offset = 0.5, a = 0.7, b = -0.4, da = 0.3, db = 0.9, t = 1;
  VesselModel oracle;
  PartModel bar;
  bar.mass = 0;
  bar.inertia_B.setZero();
  oracle.parts.push_back(bar);
  bar.mass = 40;
  bar.inertia_B = Vec3(3, 5, 4).asDiagonal();
  bar.point_V = {0, 0, -length};
  bar.in_V.p = {0, 0, -length - offset};
  oracle.parts.push_back(bar);
  numerics::EventOde ode;
  ode.derivative = [&](double, const VecX& y, VecX& dy) { example::double_pendulum_rates(oracle, y, dy); };
  numerics::OdeSettings settings;
  settings.relative = 1e-13;
  settings.absolute = VecX::Constant(4, 1e-13);
  VecX y(4);
  y << a, b - a, da, db - da;
  numerics::OdeSolution solution(std::move(ode), settings, 0, y);
  solution.follow(t, y);
  const auto below = [](double angle, double l) { return Vec3(-l * std::sin(angle), 0, -l * std::cos(angle)); };
  const auto moving = [](double angle, double rate, double l) -> Vec3 {
    return l * rate * Vec3(-std::cos(angle), 0, std::sin(angle));
  };
  for (const auto& [theta, order] : {std::pair(std::optional<double>(), 1.0), std::pair(std::optional(0.5), 2.0)}) {
    VesselModel model;
    model.theta = theta;
    model.mass.mass = bar.mass;
    model.mass.inertia = bar.inertia_B;
    model.pose_V.p = below(a, length) + below(b, offset);
    model.pose_V.q = Quat(Eigen::AngleAxisd(b, Vec3::UnitY()));
    model.v = moving(a, da, length) + moving(b, db, offset);
    model.w = {0, db, 0};
    model.rods.push_back({"tie", -1, Vec3(0, 0, offset), Vec3::Zero(), length});
    std::vector<double> errors;
    for (const double h : {1.0 / 200, 1.0 / 400, 1.0 / 800}) {
      VesselSystem system(model, 0);
      for (int k = 0; k < std::lround(t / h); ++k) {
        example::step(system, example::weights(model), h);
        ASSERT_NEAR(example::rod_length(model, system), length, 1e-14);
      }
      const double turned = y[0] + y[1];
      errors.push_back((system.state().pose.p - below(y[0], length) - below(turned, offset)).norm());
    }
    EXPECT_NEAR(std::log2(errors[1] / errors[2]), order, 0.1) << errors[0] << " " << errors[1] << " " << errors[2];
    EXPECT_LT(errors[2], order == 1 ? 0.01 : 1e-4);
  }
}

TEST(JointedRods, BearAConstantForceAlongThem) {
  for (const auto theta : k_schemes) {
    VesselModel model = example::on_a_rod(theta);
    VesselSystem system(model, 0);
    const Vec3 end = example::rod_end(model, system);
    const Vec3 away = (end - model.rods[0].to_G).normalized(), force = 240 * away;
    const Wrench load{force, (end - system.state().pose.p).cross(force)};
    for (int k = 0; k < 50; ++k) example::step(system, std::vector<Wrench>{load}, 0.01);
    EXPECT_NEAR(system.joint_account().rods[0], 240, 1e-9);
    EXPECT_LT((example::rod_end(model, system) - end).norm(), 1e-12);
    // and a push along it
    example::step(system, std::vector<Wrench>{{-load.force, -load.torque}}, 0.01);
    EXPECT_NEAR(system.joint_account().rods[0], -240, 1e-9);
  }
}

TEST(JointedRods, PassABlowOnAsTheClosedFormSays) {
  // of the impulse r the rod takes T with n.W (r - T n) = 0, W the inverse mass of the hull's end
  for (const auto theta : k_schemes) {
    VesselModel model = example::on_a_rod(theta);
    VesselSystem system(model, 0);
    const Vec3 com = system.state().pose.p, end = example::rod_end(model, system);
    const Vec3 n = (end - model.rods[0].to_G).normalized(), arm = end - com, hit = Vec3(-1.7, 0.4, 0.6);
    const Vec3 blow(300, -200, 100);
    system.move_before_impulses(1e-3);
    const VesselBlock block = system.begin({}, 1e-3);
    EXPECT_EQ(block.mass.rows(), 5);
    system.finish({blow, hit.cross(blow)});
    const Mat3 R = model.pose_V.q.toRotationMatrix(), inertia = R * model.mass.inertia * R.transpose();
    const auto twist_of = [&](const Vec3& impulse, const Vec3& at) {
      Vec6 twist;
      twist << impulse / model.mass.mass, inertia.inverse() * at.cross(impulse);
      return twist;
    };
    const auto along_rod = [&](const Vec6& twist) { return n.dot(twist.head<3>() + twist.tail<3>().cross(arm)); };
    const double tension = along_rod(twist_of(blow, hit)) / along_rod(twist_of(n, arm));
    const Vec6 expected = twist_of(blow, hit) - tension * twist_of(n, arm);
    EXPECT_LT((system.velocity_after_impulses() - expected).norm(), 1e-12);
    EXPECT_NEAR(along_rod(system.velocity_after_impulses()), 0, 1e-13);
    EXPECT_NEAR(1e-3 * system.joint_account().rods[0], tension, 2e-3 * std::abs(tension));
    // The block gives the same value before the step is taken.
    Vec6 r;
    r << blow, hit.cross(blow);
    const VecX z = block.mass.llt().solve(block.f + block.hull.jacobian.transpose() * r);
    EXPECT_LT((block.hull.jacobian * z + block.hull.prescribed - expected).norm(), 1e-12);
  }
}

TEST(JointedRods, EachStepBalancesMomentaWithTensionLoadsAndImpulses) {
  // about the fixed end of its only rod a vessel keeps its angular momentum to rounding, whatever the tension; its
  // momentum changes along the rod besides
  RandomStream random(4, "rods");
  for (const auto theta : k_schemes) {
    VesselModel model = example::chain();
    model.theta = theta;
    model.v.setZero();
    model.w.setZero();
    for (PartModel& part : model.parts) part.rate = 0;
    model.rods.push_back({"tie", 2, model.parts[2].in_V.p + Vec3(0.1, 0.2, -0.3), Vec3(4, 3, -2), std::nullopt});
    VesselSystem system(model, 0);
    const double h = 0.01;
    for (int k = 0; k < 40; ++k) {
      const Vec6 start = example::totals(model, system).momentum;
      std::vector<Wrench> loads, impulses;
      for (std::size_t b = 0; b <= model.parts.size(); ++b) {
        loads.push_back(example::random_wrench(random, 50));
        impulses.push_back(example::random_wrench(random, 0.5));
      }
      system.move_before_impulses(h);
      std::vector<VesselState> there{system.state()};
      for (const PartState& part : system.parts()) there.push_back(part.state);
      const Vec3 pull = (model.rods[0].to_G - example::rod_end(model, system)).normalized();
      system.begin(loads[0], h, {loads.begin() + 1, loads.end()});
      system.finish(impulses[0], {impulses.begin() + 1, impulses.end()});
      Vec6 lack = example::totals(model, system).momentum - start;
      for (std::size_t b = 0; b < loads.size(); ++b) {
        const Vec3 p = h * loads[b].force + impulses[b].force, l = h * loads[b].torque + impulses[b].torque;
        lack.head<3>() -= p;
        lack.tail<3>() -= there[b].pose.p.cross(p) + l;
      }
      const Vec3 about_end = lack.tail<3>() - model.rods[0].to_G.cross(lack.head<3>());
      ASSERT_LT(about_end.norm(), 1e-11 * (1 + start.norm())) << k;
      const double tension = system.joint_account().rods[0];
      ASSERT_LT((lack.head<3>() - h * tension * pull).norm(), 2e-3 * h * std::abs(tension) + 1e-9) << k;
    }
  }
}

TEST(JointedRods, LengthsAndEnergyAreKeptInFreeMotion) {
  for (const auto theta : k_schemes) {
    const VesselModel model = example::chain_on_rods(theta);
    VesselSystem system(model, 0);
    const double energy = example::totals(model, system).kinetic;
    const std::array<double, 2> lengths{example::rod_length(model, system), example::rod_length(model, system, 1)};
    double worst = 0, scale = 0;
    for (int k = 0; k < 200; ++k) {
      example::step(system, std::vector<Wrench>(model.parts.size() + 1), 0.01);
      for (std::size_t rod = 0; rod < 2; ++rod)
        ASSERT_NEAR(example::rod_length(model, system, rod), lengths[rod], 1e-14 * lengths[rod]) << k;
      for (const PartState& part : system.parts()) {
        worst = std::max({worst, part.unbalanced_force, part.unbalanced_torque});
        scale = std::max({scale, part.joint.force.norm(), part.joint.torque.norm()});
      }
    }
    EXPECT_NEAR(example::totals(model, system).kinetic, energy, 1e-6 * energy);
    EXPECT_LT(worst, 1e-5 * scale) << scale;
    EXPECT_GT(std::abs(system.parts()[0].coordinates[0]), 0.1);
  }
}

TEST(JointedRods, EnergyUnderWeightErrsWithTheOrderOfTheScheme) {
  for (const auto& [theta, order] : {std::pair(std::optional<double>(), 1.0), std::pair(std::optional(0.5), 2.0)}) {
    std::vector<double> worst;
    for (const double h : {0.01, 0.005}) {
      const VesselModel model = example::on_a_rod(theta);
      VesselSystem system(model, 0);
      const double start = example::energy(model, system);
      worst.push_back(0);
      for (int k = 0; k < std::lround(5 / h); ++k) {
        example::step(system, example::weights(model), h);
        worst.back() = std::max(worst.back(), std::abs(example::energy(model, system) - start));
      }
    }
    EXPECT_NEAR(std::log2(worst[0] / worst[1]), order, 0.15) << worst[0] << " " << worst[1];
    if (order == 2) {
      EXPECT_LT(worst[1], 2e-4 * example::k_mass * example::k_gravity);
    }
  }
}

TEST(JointedRods, TurnWithTheFrame) {
  const Quat turn(Eigen::AngleAxisd(1.1, Vec3(0.3, -0.5, 0.8).normalized()));
  for (const auto theta : k_schemes) {
    const VesselModel model = example::chain_on_rods(theta);
    VesselModel turned = model;
    turned.pose_V = {turn * model.pose_V.q, turn * model.pose_V.p};
    turned.v = turn * model.v;
    turned.w = turn * model.w;
    for (RodModel& rod : turned.rods) rod.to_G = turn * rod.to_G;
    VesselSystem a(model, 0), b(turned, 0);
    std::vector<Wrench> loads, same;
    RandomStream random(3, "rods");
    for (std::size_t k = 0; k <= model.parts.size(); ++k) {
      loads.push_back(example::random_wrench(random, 30));
      same.push_back({turn * loads.back().force, turn * loads.back().torque});
    }
    for (int k = 0; k < 100; ++k) {
      example::step(a, loads, 0.01);
      example::step(b, same, 0.01);
      ASSERT_LT((a.joint_account().rods - b.joint_account().rods).norm(), 1e-8) << k;
    }
    EXPECT_LT((turn * a.state().pose.p - b.state().pose.p).norm(), 1e-10);
    EXPECT_LT((turn * a.parts()[2].joint.force - b.parts()[2].joint.force).norm(), 1e-8);
  }
}

TEST(JointedRods, GoOnFromASavedStateWithTheSameBits) {
  for (const auto theta : k_schemes) {
    const VesselModel model = example::chain_on_rods(theta);
    VesselSystem whole(model, 0), second(model, 0);
    const auto loads = example::weights(model);
    for (int k = 0; k < 10; ++k) example::step(whole, loads, 0.01);
    State state;
    whole.save(StateWriter(state));
    second.restore(StateReader(state));
    for (int k = 0; k < 10; ++k) {
      example::step(whole, loads, 0.01);
      example::step(second, loads, 0.01);
    }
    EXPECT_EQ(whole.coordinates(), second.coordinates());
    EXPECT_EQ(whole.joint_account().rods, second.joint_account().rods);
  }
}

TEST(JointedRods, AnAbandonedStepLeavesNothingBehind) {
  for (const auto theta : k_schemes) {
    const VesselModel model = example::chain_on_rods(theta);
    VesselSystem straight(model, 0), twice(model, 0);
    const auto loads = example::weights(model);
    twice.move_before_impulses(0.02);
    twice.begin(loads[0], 0.02, {loads.begin() + 1, loads.end()});
    twice.abandon_step();
    example::step(twice, loads, 0.01);
    example::step(straight, loads, 0.01);
    EXPECT_EQ(straight.coordinates(), twice.coordinates());
    EXPECT_EQ(straight.joint_account().rods, twice.joint_account().rods);
  }
}

}  // namespace jointed_rods_test
}  // namespace nilas::vessel
