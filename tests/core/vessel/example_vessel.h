#pragma once
/// A vessel of 500 kg with an inertia that has no zero entry, and carriages to hang it on.
#include <gtest/gtest.h>

#include <algorithm>
#include <string>

#include "core/base/random.h"
#include "core/vessel/vessel_system.h"
#include "tests/support/scratch_folder.h"

namespace nilas::example {

constexpr double k_mass = 500;  ///< [kg]
constexpr double k_arm = 1.5;   ///< Lever arm of the default cells [m].

inline vessel::VesselModel vessel() {
  vessel::VesselModel model;
  model.mass.mass = k_mass;
  model.mass.com = {2.9, 0.02, 0.3};
  model.mass.inertia << 60, 1.5, -9, 1.5, 900, 2, -9, 2, 930;
  model.pose_V.p = {1, -2, -0.2};
  model.pose_V.q = Quat(Eigen::AngleAxisd(0.3, Vec3::UnitZ()));
  return model;
}

/// The carriage of a vessel, standing still, its joint at `joint_V`.
inline vessel::CarriageModel carriage(const vessel::VesselModel& model, const Vec3& joint_V) {
  vessel::CarriageModel carriage;
  carriage.joint_V = joint_V;
  const Vec3 start = model.pose_V.p + model.pose_V.q * joint_V;
  carriage.motion = vessel::CarriageMotion::straight(start, 0.3, 0, 0, 0, 0);
  carriage.stiffness = 1e7;
  carriage.damping = 1e4;
  carriage.cells = vessel::default_cells(k_arm);
  return carriage;
}

inline vessel::VesselModel carried(BalanceKind balance, const std::array<bool, 6>& free = {}) {
  vessel::VesselModel model = vessel();
  model.carriage = carriage(model, model.mass.com);
  model.carriage->balance = balance;
  model.carriage->free = free;
  return model;
}

/// One step under a constant wrench, with an impulse.
inline vessel::VesselBlock step(vessel::VesselSystem& system, const Wrench& load, double h,
                                const Wrench& impulse = {}) {
  system.move_before_impulses(h);
  vessel::VesselBlock block = system.begin(load, h);
  system.finish(impulse);
  return block;
}

/// One step under the wrench that the state at which loads act has.
template <class Load>
void step_under(vessel::VesselSystem& system, const Load& load, double h) {
  system.move_before_impulses(h);
  system.begin(load(system.state()), h);
  system.finish({});
}

inline void run(vessel::VesselSystem& system, const Wrench& load, double h, int steps) {
  for (int i = 0; i < steps; ++i) step(system, load, h);
}

inline Vec3 random_vector(RandomStream& random, double size) {
  return {random.uniform(-size, size), random.uniform(-size, size), random.uniform(-size, size)};
}

inline Wrench random_wrench(RandomStream& random, double size) {
  const Vec3 force = random_vector(random, size);
  return {force, random_vector(random, size)};
}

/// R I R^T w of a state.
inline Vec3 angular_momentum(const vessel::VesselModel& model, const vessel::VesselState& state) {
  const Mat3 R = state.pose.q.toRotationMatrix();
  return R * model.mass.inertia * R.transpose() * state.w;
}

/// Moves a vessel by a pseudo velocity for 0.01 s, and expects that its momenta stay.
inline void expect_displacement_keeps_momenta(vessel::VesselModel model) {
  constexpr double k_step = 0.01;
  model.v = {1, 2, 3};
  model.w = {0.3, 0.8, -0.4};
  vessel::VesselSystem system(model, 0);
  const vessel::VesselState before = system.state();
  Vec6 pseudo;
  pseudo << 0.1, -0.2, 0.3, 0.5, 0, 0;
  system.displace(pseudo, k_step);
  const vessel::VesselState& after = system.state();
  EXPECT_LT((after.pose.p - before.pose.p - k_step * pseudo.head<3>()).norm(), 1e-15);
  EXPECT_NEAR(after.pose.q.angularDistance(before.pose.q), 0.005, 1e-12);
  EXPECT_EQ(after.v, before.v);
  EXPECT_LT((angular_momentum(model, after) - angular_momentum(model, before)).norm(), 1e-11);
}

/// A file that goes when the test ends.
class TemporaryFile {
 public:
  explicit TemporaryFile(const std::string& text) { path_ = folder_.write("table.csv", text).string(); }
  const std::string& path() const { return path_; }

 private:
  test::ScratchFolder folder_;
  std::string path_;
};

}  // namespace nilas::example
