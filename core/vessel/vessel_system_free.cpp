#include <cmath>

#include "core/base/error.h"
#include "core/bodies/free_rotation.h"
#include "core/vessel/tree/vessel_motion.h"
#include "core/vessel/tree/vessel_tree.h"

namespace nilas::vessel {

namespace {

/// Rotation by the vector `turn` [rad].
Quat rotation(const Vec3& turn) {
  const double angle = turn.norm();
  return angle > 0 ? Quat(Eigen::AngleAxisd(angle, turn / angle)) : Quat::Identity();
}

/// A free vessel with six speeds (w; v). Its block of the contact problem is the body's own mass matrix.
class FreeVessel : public VesselMotion {
 public:
  FreeVessel(const VesselModel& model, double t0)
      : VesselMotion(model, t0), gyroscopic_(model.gyroscopic), tree_(model.mass) {
    state_.v = model.v;
    state_.w = model.w;
    after_ << state_.v, state_.w;
  }

  Vec6 velocity_after_impulses() const override { return after_; }

  VecX coordinates() const override {
    VecX all(13);
    all << state_.pose.p, state_.pose.q.coeffs(), state_.v, state_.w;
    return all;
  }

 protected:
  VesselBlock begin_step() override {
    const Quat& q = state_.pose.q;
    VecX coordinates(7), speeds(6);
    coordinates << q.w(), q.vec(), state_.pose.p;
    speeds << state_.w, state_.v;
    tree_.set_coordinates(coordinates);
    // At rest the force has no gyroscopic term, which acts while the attitude turns.
    tree_.set_speeds(VecX::Zero(6));
    VesselBlock block;
    block.mass = tree_.mass_matrix();
    block.f = block.mass * speeds + h_ * tree_.force(free_, {});
    block.hull.jacobian = tree_.jacobian();
    return block;
  }

  void save_motion(StateWriter& out) const override { out.add("after_impulses", after_); }
  void restore_motion(const StateReader& in) override { in.get("after_impulses", after_); }

  void keep_velocity_after_impulses() {
    after_ << state_.v, state_.w;
    if (!after_.allFinite())
      throw SimulationError("at " + std::to_string(time_) + " s the vessel's velocity left finite numbers");
  }

  bool gyroscopic_;

 private:
  VesselTree tree_;
  Vec6 after_;
};

/// A free vessel with semi-implicit Euler. With the gyroscopic term, the angular momentum of the velocity step is kept
/// to the last digit while the attitude turns about the mean of the angular velocities at both ends. Without it the
/// angular velocity is kept, and the angular momentum is not conserved.
class EulerFreeVessel : public FreeVessel {
 public:
  EulerFreeVessel(const VesselModel& model, double t0) : FreeVessel(model, t0) {
    angular_momentum_ = inertia_G() * state_.w;
  }

  void displace(const Vec6& pseudo_twist, double h) override {
    state_.pose.p += h * pseudo_twist.head<3>();
    state_.pose.q = (rotation(h * pseudo_twist.tail<3>()) * state_.pose.q).normalized();
    if (gyroscopic_) state_.w = turning(angular_momentum_);
  }

 protected:
  void finish_step(const Wrench& contact) override {
    if (!gyroscopic_) angular_momentum_ = inertia_G() * state_.w;
    angular_momentum_ += h_ * free_.torque + contact.torque;
    state_.v += (h_ * free_.force + contact.force) / mass_.mass;
    state_.w = turning(angular_momentum_);
    keep_velocity_after_impulses();
    state_.pose.p += h_ * state_.v;
    if (gyroscopic_)
      turn();
    else
      state_.pose.q = (rotation(h_ * state_.w) * state_.pose.q).normalized();
  }

  void save_motion(StateWriter& out) const override {
    FreeVessel::save_motion(out);
    out.add("angular_momentum", angular_momentum_);
  }
  void restore_motion(const StateReader& in) override {
    FreeVessel::restore_motion(in);
    in.get("angular_momentum", angular_momentum_);
  }

 private:
  void turn() {
    const Quat q = state_.pose.q;
    const Vec3 w = state_.w;
    // Each pass reduces the error by a factor of about h |w|. The last passes change nothing, so that the step is
    // reversible.
    constexpr int k_most_passes = 20;
    for (int pass = 0; pass < k_most_passes; ++pass) {
      const Vec3 w_end = state_.w;
      state_.pose.q = (rotation(0.5 * h_ * (w + w_end)) * q).normalized();
      state_.w = turning(angular_momentum_);
      if (state_.w == w_end) break;
    }
  }

  Vec3 angular_momentum_;  ///< conserved quantity of the rotation when gyroscopic, so that rounding does not accumulate
};

/// A free vessel in the theta scheme: (1 - theta) h before the impulses, theta h after them, with the same rotation as
/// the floes.
class MoreauFreeVessel : public FreeVessel {
 public:
  MoreauFreeVessel(const VesselModel& model, double t0)
      : FreeVessel(model, t0), theta_(*model.theta), inertia_inverse_(model.mass.inertia.inverse()) {}

  void displace(const Vec6& pseudo_twist, double h) override {
    const Vec3 angular_momentum = inertia_G() * state_.w;
    state_.pose.p += h * pseudo_twist.head<3>();
    state_.pose.q = (bodies::exponential(h * pseudo_twist.tail<3>()) * state_.pose.q).normalized();
    if (gyroscopic_) state_.w = turning(angular_momentum);
  }

 protected:
  void move_before_step(double h) override {
    start_ = state_;
    move((1 - theta_) * h);
  }
  void abandon_motion() override { state_ = start_; }

  void finish_step(const Wrench& contact) override {
    state_.v += (h_ * free_.force + contact.force) / mass_.mass;
    state_.w += turning(h_ * free_.torque + contact.torque);
    keep_velocity_after_impulses();
    move(theta_ * h_);
  }

 private:
  void move(double h) {
    state_.pose.p += h * state_.v;
    if (gyroscopic_)
      bodies::turn_freely(state_.pose.q, state_.w, mass_.inertia, inertia_inverse_, h);
    else
      state_.pose.q = (bodies::exponential(h * state_.w) * state_.pose.q).normalized();
  }

  double theta_;
  Mat3 inertia_inverse_;
  VesselState start_;  ///< state at the start of the present step
};

}  // namespace

std::unique_ptr<VesselMotion> make_free_vessel(const VesselModel& model, double t0) {
  if (model.theta) return std::make_unique<MoreauFreeVessel>(model, t0);
  return std::make_unique<EulerFreeVessel>(model, t0);
}

}  // namespace nilas::vessel
