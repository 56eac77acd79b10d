/// The vessel of several bodies: momenta, energy, impulses through its joints, reactions, carriage, and its state.
#include <cmath>

#include "core/base/error.h"
#include "core/vessel/tree/jointed_tree.h"
#include "tests/core/vessel/tree/jointed_example.h"

namespace nilas::vessel {
namespace jointed_vessel_test {

const std::vector<std::optional<double>> k_schemes{std::nullopt, 0.5};

TEST(JointedVessel, FreeMotionKeepsMomentaAndEnergy) {
  for (const auto theta : k_schemes) {
    VesselModel model = example::chain();
    model.theta = theta;
    VesselSystem system(model, 0);
    const std::vector<Wrench> nothing(model.parts.size() + 1);
    const example::Totals start = example::totals(model, system);
    for (int k = 0; k < 200; ++k) example::step(system, nothing, 0.01);
    const example::Totals end = example::totals(model, system);
    EXPECT_LT((end.momentum.head<3>() - start.momentum.head<3>()).norm(), 1e-12 * start.momentum.head<3>().norm());
    EXPECT_LT((end.momentum.tail<3>() - start.momentum.tail<3>()).norm(), 1e-12 * start.momentum.tail<3>().norm());
    EXPECT_NEAR(end.kinetic, start.kinetic, 1e-7 * start.kinetic);
    // they have moved
    EXPECT_GT(std::abs(system.parts()[0].coordinates[0]), 0.3);
  }
}

TEST(JointedVessel, EachStepBalancesMomentaWithAllThatActs) {
  RandomStream random(1, "jointed");
  for (const auto theta : k_schemes) {
    VesselModel model = example::chain();
    model.theta = theta;
    model.parts[0].stiffness = 300;
    model.parts[0].damping = 20;
    model.parts[1].stiffness = 100;
    VesselSystem system(model, 0);
    const double h = 0.01;
    for (int k = 0; k < 20; ++k) {
      const example::Totals start = example::totals(model, system);
      std::vector<Wrench> loads, impulses;
      for (std::size_t b = 0; b <= model.parts.size(); ++b) {
        loads.push_back(example::random_wrench(random, 50));
        impulses.push_back(example::random_wrench(random, 0.5));
      }
      system.move_before_impulses(h);
      std::vector<VesselState> there{system.state()};
      for (const PartState& part : system.parts()) there.push_back(part.state);
      system.begin(loads[0], h, {loads.begin() + 1, loads.end()});
      system.finish(impulses[0], {impulses.begin() + 1, impulses.end()});
      Vec6 given = Vec6::Zero();
      for (std::size_t b = 0; b < loads.size(); ++b) {
        const Vec3 p = h * loads[b].force + impulses[b].force, l = h * loads[b].torque + impulses[b].torque;
        given.head<3>() += p;
        given.tail<3>() += there[b].pose.p.cross(p) + l;
      }
      const Vec6 gained = example::totals(model, system).momentum - start.momentum;
      ASSERT_LT((gained - given).norm(), 1e-11 * (1 + start.momentum.norm())) << k;
    }
  }
}

TEST(JointedVessel, SimbodysReactionsBalanceTheMomentaOfEachPart) {
  // The remaining error is that of the motion's scheme over a step: fourth order.
  for (const auto theta : k_schemes) {
    double last = 0;
    for (const double h : {0.02, 0.01}) {
      VesselModel model = example::chain();
      model.theta = theta;
      model.parts[0].stiffness = 300;
      model.parts[0].damping = 20;
      VesselSystem system(model, 0);
      RandomStream random(2, "jointed");
      std::vector<Wrench> impulses;
      for (std::size_t b = 0; b <= model.parts.size(); ++b) impulses.push_back(example::random_wrench(random, 0.5));
      example::step(system, example::weights(model), h, impulses);
      double worst = 0, scale = 0;
      for (const PartState& part : system.parts()) {
        worst = std::max({worst, part.unbalanced_force, part.unbalanced_torque});
        scale = std::max({scale, part.joint.force.norm(), part.joint.torque.norm()});
      }
      EXPECT_LT(worst, 1e-6 * scale) << scale;
      if (last > 0) {
        EXPECT_GT(std::log2(last / worst), 3) << last << " " << worst;
      }
      last = worst;
    }
  }
}

TEST(JointedVessel, ImpulsePassesThroughAHingeAsInTheClosedForm) {
  // two equal rods in line, hinged end to end, at rest, struck across at the far end of the first: the far end starts
  // with 14 J/(4 m)..., here from the two-body chain: v = W J with W = 4/m (1 - 1/8) for rods of mass m
  constexpr double m = 12, l = 2, J = 3;
  VesselModel model;
  model.mass.mass = m;
  model.mass.inertia = Vec3(0.01, m * l * l / 12, m * l * l / 12).asDiagonal();
  PartModel rod;
  rod.mass = m;
  rod.inertia_B = model.mass.inertia;
  rod.point_V = {l / 2, 0, 0};
  rod.in_V.p = {l, 0, 0};
  rod.axis_V = Vec3::UnitZ();
  model.parts.push_back(rod);
  VesselSystem system(model, 0);
  system.move_before_impulses(1e-3);
  const VesselBlock block = system.begin({}, 1e-3, {Wrench{}});
  const Vec3 arm(-l / 2, 0, 0), blow(0, J, 0);
  system.finish({blow, arm.cross(blow)}, {Wrench{}});
  const Vec6 hull = system.velocity_after_impulses(), part = system.part_velocities_after_impulses()[0];
  const Vec3 end = hull.head<3>() + hull.tail<3>().cross(arm);
  EXPECT_NEAR(end.y(), 3.5 * J / m, 1e-12);
  // hinge impulse on the second rod X = -J/4... : m v2 = X, and both rods' ends there move alike
  const double X = m * part[1];
  EXPECT_NEAR(X, -J / 4, 1e-12);
  EXPECT_NEAR(part[5], X * (-l / 2) / (m * l * l / 12), 1e-12);
  EXPECT_NEAR(hull[1] + hull[5] * l / 2, part[1] - part[5] * l / 2, 1e-12);
  // The block gives the same value before the step is taken.
  Vec6 r;
  r << blow, arm.cross(blow);
  const VecX speeds = block.mass.llt().solve(block.f + block.hull.jacobian.transpose() * r);
  EXPECT_LT((block.hull.jacobian * speeds - hull).norm() + (block.parts[0].jacobian * speeds - part).norm(), 1e-12);
  EXPECT_NEAR(system.parts()[0].joint.force.y() * 1e-3, X, 1e-6 * J);
}

TEST(JointedVessel, WeldedPartsAreOneBodyWithTheHull) {
  VesselModel model = example::vessel();
  model.v = {0.4, -0.2, 0.1};
  model.w = {0.2, -0.3, 0.25};
  model.theta = 0.5;
  PartModel welded = example::part(JointKind::weld);
  model.parts = {welded};
  VesselModel whole = model;
  whole.parts.clear();
  whole.mass.mass = model.mass.mass + welded.mass;
  whole.mass.com = (model.mass.mass * model.mass.com + welded.mass * welded.in_V.p) / whole.mass.mass;
  const auto about = [&](const Mat3& inertia, double mass, const Vec3& p) -> Mat3 {
    const Vec3 arm = p - whole.mass.com;
    return inertia + mass * (arm.squaredNorm() * Mat3::Identity() - arm * arm.transpose());
  };
  const Mat3 R = welded.in_V.q.toRotationMatrix();
  whole.mass.inertia = about(model.mass.inertia, model.mass.mass, model.mass.com) +
                       about(R * welded.inertia_B * R.transpose(), welded.mass, welded.in_V.p);
  whole.v += model.w.cross(model.pose_V.q * (whole.mass.com - model.mass.com));
  VesselSystem two(model, 0), one(whole, 0);
  const Wrench push{{30, -20, 10}, Vec3::Zero()};
  for (int k = 0; k < 100; ++k) {
    const Vec3 arm = one.state().pose.p - two.state().pose.p;
    example::step(two, std::vector<Wrench>{{push.force, arm.cross(push.force)}, {}}, 0.005);
    example::step(one, push, 0.005);
  }
  const Vec3 com = two.state().pose.p + two.state().pose.q * (whole.mass.com - model.mass.com);
  EXPECT_LT((com - one.state().pose.p).norm(), 1e-6);
  EXPECT_LT(two.state().pose.q.angularDistance(one.state().pose.q), 1e-5);
}

TEST(JointedVessel, TurnsWithTheFrame) {
  const Quat turn(Eigen::AngleAxisd(1.1, Vec3(0.3, -0.5, 0.8).normalized()));
  for (const auto theta : k_schemes) {
    VesselModel model = example::chain(), turned = model;
    model.theta = turned.theta = theta;
    turned.pose_V = {turn * model.pose_V.q, turn * model.pose_V.p};
    turned.v = turn * model.v;
    turned.w = turn * model.w;
    VesselSystem a(model, 0), b(turned, 0);
    std::vector<Wrench> loads, same;
    RandomStream random(3, "jointed");
    for (std::size_t k = 0; k <= model.parts.size(); ++k) {
      loads.push_back(example::random_wrench(random, 30));
      same.push_back({turn * loads.back().force, turn * loads.back().torque});
    }
    for (int k = 0; k < 100; ++k) {
      example::step(a, loads, 0.01);
      example::step(b, same, 0.01);
    }
    for (std::size_t k = 0; k < model.parts.size(); ++k) {
      const PartState &one = a.parts()[k], &other = b.parts()[k];
      EXPECT_LT((turn * one.state.pose.p - other.state.pose.p).norm(), 1e-10) << k;
      EXPECT_LT((turn * one.joint.force - other.joint.force).norm(), 1e-8) << k;
      if (one.coordinates.size() > 0) {
        EXPECT_LT((one.coordinates - other.coordinates).norm(), 1e-10) << k;
      }
    }
  }
}

TEST(JointedVessel, CarriageLoadIsWhatTheMomentaLack) {
  for (const auto theta : k_schemes)
    for (const bool heaves : {false, true}) {
      VesselModel model = example::carried(heaves ? BalanceKind::prismatic : BalanceKind::rigid);
      model.theta = theta;
      model.parts = example::chain().parts;
      const Vec3 start = model.pose_V.p + model.pose_V.q * model.mass.com;
      model.carriage->motion = CarriageMotion::straight(start, 0.3, 2, 0.4, 0.5, 0);
      VesselSystem system(model, 0);
      const double h = 0.01;
      double worst = 0;
      for (int k = 0; k < 100; ++k) {
        const Vec6 before = example::totals(model, system).momentum;
        example::step(system, example::weights(model), h);
        Vec3 weight = Vec3::Zero();
        for (const Wrench& load : example::weights(model)) weight += load.force;
        const Vec6 after = example::totals(model, system).momentum;
        const Vec3 lack = (after - before).head<3>() / h - weight;
        worst = std::max(worst, (system.carriage_loads().about_com.force - lack).norm());
        const Wrench& apart = system.carriage_loads().disagreement.value();
        ASSERT_LT(apart.force.norm() + apart.torque.norm(), 1e-5 * model.mass.mass * example::k_gravity);
        if (heaves) {
          ASSERT_NEAR(system.carriage_loads().about_com.force.z(), 0, 1e-8 * weight.norm());
        }
      }
      EXPECT_LT(worst, 1e-5 * model.mass.mass * example::k_gravity) << heaves;
      EXPECT_NEAR(system.state().v.x(), 2 * std::cos(0.4), 1e-12);
    }
}

TEST(JointedVessel, SimbodyConfirmsTheLoadOfARigidCarriage) {
  // the load of a vessel of one body is what its momenta lack; Simbody's reaction of the same tree under the same loads
  for (const auto theta : k_schemes) {
    VesselModel model = example::carried(BalanceKind::rigid);
    model.theta = theta;
    const Vec3 start = model.pose_V.p + model.pose_V.q * model.mass.com;
    model.carriage->motion = CarriageMotion::straight(start, 0.3, 2, 0.4, 1, 0);
    VesselSystem system(model, 0);
    JointedTree tree(model);
    const Wrench load{{30, -40, -5000}, {10, 20, 30}}, impulse{{1, 2, 3}, {-0.5, 0.2, 0.1}};
    const double h = 0.01;
    for (int k = 0; k < 20; ++k) example::step(system, load, h, impulse);
    CarriageMotion::State acceleration;
    acceleration.v = Vec3(2 * std::cos(0.4), 2 * std::sin(0.4), 0);
    tree.set_carriage(model.carriage->motion.at(0.19));
    const Wrench all{load.force + impulse.force / h, load.torque + impulse.torque / h};
    const Wrench reaction = tree.joint_loads(VecX(0), acceleration, {all}).front();
    EXPECT_LT((reaction.force - system.carriage_loads().about_joint.force).norm(), 1e-9 * reaction.force.norm());
    EXPECT_LT((reaction.torque - system.carriage_loads().about_joint.torque).norm(), 1e-9 * reaction.force.norm());
  }
}

TEST(JointedVessel, GoesOnFromItsSavedStateWithTheSameBits) {
  for (const auto theta : k_schemes) {
    VesselModel model = example::chain();
    model.theta = theta;
    VesselSystem whole(model, 0), second(model, 0);
    const auto loads = example::weights(model);
    for (int k = 0; k < 10; ++k) example::step(whole, loads, 0.01);
    State state;
    whole.save(StateWriter(state));
    second.restore(StateReader(state));
    for (int k = 0; k < 10; ++k) {
      example::step(whole, loads, 0.01);
      example::step(second, loads, 0.01);
      ASSERT_EQ(whole.coordinates(), second.coordinates()) << k;
    }
    EXPECT_EQ(whole.parts()[2].joint.torque, second.parts()[2].joint.torque);
  }
}

TEST(JointedVessel, ImpossiblePartsAreInputErrors) {
  VesselModel model = example::chain();
  model.parts[1].mass = 0;
  EXPECT_THROW(VesselSystem(model, 0), InputError);
  model = example::chain();
  model.parts[1].inertia_B = Vec3(1, 1, 5).asDiagonal();
  EXPECT_THROW(VesselSystem(model, 0), InputError);
}

}  // namespace jointed_vessel_test
}  // namespace nilas::vessel
