/// Linear hydrostatics of a database: loads for small motions, rest, the potential, heading.
#include "hydro/restoring/restoring.h"

#include <gtest/gtest.h>

#include <cmath>

namespace restoring_test {

using namespace nilas;
using namespace nilas::hydro;

constexpr double k_mass = 2000, k_gravity = 9.81;

/// A box of 2000 kg as the hull; the origin of D lies 0.3 m above and 0.1 m behind the centre of mass.
struct Rig {
  Rig() {
    bodies::BodySpec hull;
    hull.kind = bodies::BodyKind::vessel;
    hull.motion = bodies::Motion::articulated;
    hull.shape = std::make_shared<geometry::Shape>(geometry::box_shape(Vec3(4, 2, 1)));
    hull.mass = k_mass;
    bodies.add(hull);
    restoring.diagonal() << 0, 0, 8e4, 3e4, 1e5, 0;
    restoring(2, 4) = restoring(4, 2) = 5e3;
    model.body = 0;
    model.D_in_B.p = Vec3(-0.1, 0, 0.3);
    model.mass = k_mass;
    model.gravity = k_gravity;
    model.lift = k_mass * k_gravity;
    model.lift_centre = Vec2(0.1, 0);
    module = make_restoring(model, restoring);
  }
  /// Places D's origin at this height with these angles.
  void place(double heave, double roll, double pitch, double yaw) {
    const Quat q = Quat(Eigen::AngleAxisd(yaw, Vec3::UnitZ())) * Quat(Eigen::AngleAxisd(pitch, Vec3::UnitY())) *
                   Quat(Eigen::AngleAxisd(roll, Vec3::UnitX()));
    bodies.set_pose(0, Vec3(5, -3, heave) - q * model.D_in_B.p, q);
  }
  /// Load with the weight, about the origin of D.
  Wrench with_weight() {
    bodies::Wrenches out(1);
    module->add_forces(bodies, 0, out);
    out[0].force.z() -= k_mass * k_gravity;
    const Vec3 arm = -(bodies.R_GB[0] * model.D_in_B.p);
    return {out[0].force, out[0].torque + arm.cross(out[0].force)};
  }

  bodies::Bodies bodies;
  Mat6 restoring = Mat6::Zero();
  RestoredHull model;
  std::unique_ptr<bodies::ForceModule> module;
};

TEST(Restoring, IsZeroAtRestAtAnyHeading) {
  Rig rig;
  for (const double yaw : {0.0, 1.0, -2.5}) {
    rig.place(0, 0, 0, yaw);
    const Wrench load = rig.with_weight();
    EXPECT_LT(load.force.norm(), 1e-9);
    EXPECT_LT(load.torque.norm(), 1e-9);
  }
}

/// Small motions meet the whole stiffness of the file, the weight's part in it included, along axes that turn with yaw.
TEST(Restoring, SmallMotionsMeetTheStiffnessOfTheFile) {
  Rig rig;
  const double small = 1e-6;
  for (const double yaw : {0.0, 0.8}) {
    const Mat3 heading = Eigen::AngleAxisd(yaw, Vec3::UnitZ()).toRotationMatrix();
    for (int k = 0; k < 3; ++k) {
      Vec3 q = Vec3::Zero();
      q[k] = small;
      rig.place(q[0], q[1], q[2], yaw);
      const Wrench load = rig.with_weight();
      const Vec3 torque = heading.transpose() * load.torque;
      const Vec3 found(load.force.z(), torque.x(), torque.y());
      EXPECT_LT((found + rig.restoring.block<3, 3>(2, 2) * q).norm(), 1e-4 * small * 1e5) << k;
    }
  }
}

/// The power of the load is the fall of its potential, at attitudes that are not small.
TEST(Restoring, DerivesFromItsPotential) {
  Rig rig;
  const Vec3 v(0.2, -0.1, 0.3), w(0.4, 0.3, -0.2);
  rig.place(0.2, 0.3, -0.25, 0.7);
  bodies::Wrenches out(1);
  rig.module->add_forces(rig.bodies, 0, out);
  const double power = out[0].force.dot(v) + out[0].torque.dot(w), h = 1e-5;
  const Vec3 p = rig.bodies.p_GB[0];
  const Quat q = rig.bodies.q_GB[0];
  const auto potential = [&](double t) {
    rig.bodies.set_pose(0, p + t * v, Quat(Eigen::AngleAxisd(t * w.norm(), w.normalized())) * q);
    return rig.module->potential_energy(rig.bodies);
  };
  EXPECT_NEAR(power, -(potential(h) - potential(-h)) / (2 * h), 1e-6 * std::abs(power));
}

/// A file that was computed with another centre of mass or weight keeps its water, and gets the weight of the vessel.
TEST(Restoring, ReplacesTheWeightOfTheFile) {
  Database database;
  database.density = 1000;
  database.gravity = k_gravity;
  database.volume = 2;
  database.centre_of_gravity = Vec3(0, 0, -0.5);
  database.restoring = Mat6::Identity() * 1e4;
  const Mat6 moved = restoring_with_weight_at(database, 1000 * k_gravity, 2500 * k_gravity, Vec3(0, 0, 0.2));
  EXPECT_NEAR(moved(3, 3), 1e4 + 2000 * k_gravity * -0.5 - 2500 * k_gravity * 0.2, 1e-9);
  EXPECT_EQ(moved(2, 2), 1e4);
  database.centre_of_gravity.reset();
  EXPECT_EQ(restoring_with_weight_at(database, 1000 * k_gravity, 2500 * k_gravity, Vec3(0, 0, 0.2)),
            *database.restoring);
}

/// A vertical cylinder of radius 2 m and draught 3 m from a file for fresh water, in the sea. Its stiffness is rho g A
/// in heave and rho g (I + V z_b) - m g z_g in roll, with I = pi R^4 / 4 and z_b = -T/2, by the density of the sea.
TEST(Restoring, IsThatOfTheWaterOfTheScene) {
  constexpr double k_radius = 2, k_draught = 3, k_fresh = 1000, k_sea = 1025, k_centre = -1;
  const double area = k_pi * k_radius * k_radius, second = area * k_radius * k_radius / 4, volume = area * k_draught;
  Database database;
  database.density = k_fresh;
  database.gravity = 9.80665;
  database.volume = volume;
  database.centre_of_gravity = Vec3(0, 0, k_centre);
  const auto roll = [&](double density, double gravity) {
    return density * gravity * (second - volume * k_draught / 2 - volume * k_centre);
  };
  database.restoring.emplace(Mat6::Zero());
  (*database.restoring)(2, 2) = k_fresh * database.gravity * area;
  (*database.restoring)(3, 3) = roll(k_fresh, database.gravity);
  const double specific = k_sea * k_gravity;
  const Mat6 found = restoring_with_weight_at(database, specific, specific * volume, Vec3(0, 0, k_centre));
  EXPECT_NEAR(found(2, 2), specific * area, 1e-9 * specific * area);
  EXPECT_NEAR(found(3, 3), roll(k_sea, k_gravity), 1e-9 * specific * second);
}

}  // namespace restoring_test
