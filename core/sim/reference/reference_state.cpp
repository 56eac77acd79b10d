#include "core/sim/reference/reference_state.h"

namespace nilas::sim {

namespace {

constexpr Eigen::Index k_per_body = 13;  // p, q, v, L
/// Number of components of the loads on a vessel: on the whole, per part, of the carriage.
constexpr Eigen::Index k_whole = 15, k_part = 6, k_carriage = 15;
/// Offsets after the works: friction, impulse, angular impulse, and the two scales; then their number.
constexpr Eigen::Index k_friction = 0, k_impulse = 1, k_angular = 4, k_scales = 7, k_sums = 9;

Vec3 angular_momentum(const bodies::Bodies& bodies, std::size_t b) {
  const Mat3& R = bodies.R_GB[b];
  return R * (bodies.inertia_B[b] * (R.transpose() * bodies.w_GB[b]));
}

}  // namespace

ReferenceVesselLoads::ReferenceVesselLoads(int num_parts, std::size_t num_modules, bool towed)
    : modules(num_modules), on_parts(static_cast<std::size_t>(num_parts)) {
  if (towed) carriage.emplace();
}

Eigen::Index ReferenceVesselLoads::size() const {
  return k_whole + k_part * static_cast<Eigen::Index>(on_parts.size() + modules.size()) + (carriage ? k_carriage : 0);
}

VecX ReferenceVesselLoads::numbers() const {
  VecX all(size());
  all.head<k_whole>() << contact.force, contact.torque, hydro.force, hydro.torque, ice;
  Eigen::Index at = k_whole;
  for (const auto* loads : {&on_parts, &modules})
    for (const Wrench& load : *loads) {
      all.segment<k_part>(at) << load.force, load.torque;
      at += k_part;
    }
  if (carriage)
    all.segment<k_carriage>(at) << carriage->about_com.force, carriage->about_com.torque, carriage->about_joint.torque,
        Eigen::Map<const Vec6>(carriage->cells.data());
  return all;
}

void ReferenceVesselLoads::add(const VecX& all) {
  contact += {all.segment<3>(0), all.segment<3>(3)};
  hydro += {all.segment<3>(6), all.segment<3>(9)};
  ice += all.segment<3>(12);
  Eigen::Index at = k_whole;
  for (auto* loads : {&on_parts, &modules})
    for (Wrench& load : *loads) {
      load += {all.segment<3>(at), all.segment<3>(at + 3)};
      at += k_part;
    }
  if (!carriage) return;
  const auto sums = all.segment<k_carriage>(at);
  carriage->about_com += {sums.segment<3>(0), sums.segment<3>(3)};
  carriage->about_joint += {sums.segment<3>(0), sums.segment<3>(6)};
  Eigen::Map<Vec6>(carriage->cells.data()) += sums.segment<6>(9);
}

ReferenceState::ReferenceState(const bodies::Bodies& bodies, std::size_t works, ReferenceVessel* vessel,
                               const ReferenceVesselLoads* sums)
    : vessel_(vessel), works_(static_cast<Eigen::Index>(works)) {
  if (sums != nullptr) vessel_sums_ = sums->size();
  for (int b = 0; b < bodies.size(); ++b)
    if (bodies.is_free(b)) free_.push_back(b);
  at_vessel_ = k_per_body * static_cast<Eigen::Index>(free_.size());
  account_ = at_vessel_ + (vessel_ != nullptr ? vessel_->size() : 0);
}

Eigen::Index ReferenceState::size() const { return account_ + works_ + vessel_sums_ + k_sums; }

VecX ReferenceState::pack(const bodies::Bodies& bodies) const {
  VecX y = VecX::Zero(size());
  Eigen::Index at = 0;
  for (const int k : free_) {
    const auto b = static_cast<std::size_t>(k);
    const Quat& q = bodies.q_GB[b];
    y.segment<k_per_body>(at) << bodies.p_GB[b], q.w(), q.vec(), bodies.v_GB[b], angular_momentum(bodies, b);
    at += k_per_body;
  }
  if (vessel_ != nullptr) y.segment(at_vessel_, vessel_->size()) = vessel_->state();
  return y;
}

void ReferenceState::unpack(double t, const VecX& y, bodies::Bodies& bodies) const {
  Eigen::Index at = 0;
  for (const int k : free_) {
    const auto b = static_cast<std::size_t>(k);
    bodies.set_pose(k, y.segment<3>(at), Quat(y[at + 3], y[at + 4], y[at + 5], y[at + 6]));
    bodies.v_GB[b] = y.segment<3>(at + 7);
    const Mat3& R = bodies.R_GB[b];
    bodies.w_GB[b] = R * (bodies.inertia_inverse_B[b] * (R.transpose() * y.segment<3>(at + 10)));
    at += k_per_body;
  }
  if (vessel_ == nullptr) return;
  vessel_->go_to(t);
  vessel_->set_state(y.segment(at_vessel_, vessel_->size()), bodies);
}

void ReferenceState::add_account(const VecX& y, ReferenceAccount& account) const {
  account.works.resize(static_cast<std::size_t>(works_), 0);
  for (Eigen::Index k = 0; k < works_; ++k) account.works[k] += y[account_ + k];
  if (vessel_sums_ > 0) account.vessel.add(y.segment(account_ + works_, vessel_sums_));
  const auto sums = y.tail<k_sums>();
  account.friction += sums[k_friction];
  account.impulse += sums.segment<3>(k_impulse);
  account.angular_impulse += sums.segment<3>(k_angular);
  account.impulse_scale += sums[k_scales];
  account.angular_scale += sums[k_scales + 1];
}

void ReferenceState::derivative(const bodies::Bodies& bodies, const VecX& y, const ReferenceLoads& loads,
                                VecX& dy) const {
  dy.setZero(size());
  auto sums = dy.tail<k_sums>();
  Eigen::Index at = 0;
  for (const int k : free_) {
    const auto b = static_cast<std::size_t>(k);
    const Wrench& load = loads.total[b];
    // Use the quaternion of y, not the normalised one of the bodies: drift of its length must not slow the rotation.
    const Quat q(y[at + 3], y[at + 4], y[at + 5], y[at + 6]);
    const Vec3& w = bodies.w_GB[b];
    const Quat dq = Quat(0, w.x(), w.y(), w.z()) * q;
    dy.segment<k_per_body>(at) << bodies.v_GB[b], 0.5 * dq.w(), 0.5 * dq.vec(), load.force / bodies.mass[b],
        load.torque;
    sums.segment<3>(k_impulse) += load.force;
    sums.segment<3>(k_angular) += bodies.p_GB[b].cross(load.force) + load.torque;
    at += k_per_body;
  }
  if (vessel_ != nullptr) {
    dy.segment(at_vessel_, vessel_->size()) = vessel_->state_rate(vessel_->accelerations(loads.total));
    const auto add = [&](int k, const Wrench& load) {
      sums.segment<3>(k_impulse) += load.force;
      sums.segment<3>(k_angular) += bodies.p_GB[k].cross(load.force) + load.torque;
    };
    for (int k = vessel_->hull(); vessel_->has_known_loads() && vessel_->holds(k); ++k) add(k, loads.total[k]);
    if (loads.vessel.carriage) add(vessel_->hull(), loads.vessel.carriage->about_com);
  }
  if (vessel_sums_ > 0) dy.segment(account_ + works_, vessel_sums_) = loads.vessel.numbers();
  for (Eigen::Index k = 0; k < works_; ++k) dy[account_ + k] = loads.powers[k];
  sums[k_friction] = loads.friction_power;
  sums[k_scales] = loads.force_sum;
  sums[k_scales + 1] = loads.moment_sum;
}

VecX ReferenceState::absolute_tolerances(const bodies::Bodies& bodies, double relative) const {
  VecX tolerance = VecX::Constant(size(), relative);
  double mass = 0;
  Eigen::Index at = 0;
  for (const int k : free_) {
    const auto b = static_cast<std::size_t>(k);
    mass += bodies.mass[b];
    tolerance.segment<3>(at + 10).setConstant(relative * bodies.inertia_B[b].trace());
    at += k_per_body;
  }
  if (vessel_ != nullptr)
    for (int k = vessel_->hull(); vessel_->holds(k); ++k) mass += bodies.mass[k];
  tolerance.tail(size() - account_).setConstant(relative * std::max(mass, 1e-300));
  constexpr double k_uncontrolled = 1e30;  // scales need no accuracy, and absolute values have kinks
  tolerance.tail<2>().setConstant(k_uncontrolled);
  return tolerance;
}

Momenta momenta(const bodies::Bodies& bodies, bool with_vessel) {
  Momenta sums;
  for (int k = 0; k < bodies.size(); ++k) {
    const auto b = static_cast<std::size_t>(k);
    if (!bodies.is_free(k) && !(with_vessel && bodies.motion[b] == bodies::Motion::articulated)) continue;
    const Vec3 momentum = bodies.mass[b] * bodies.v_GB[b];
    const Vec3 moment = bodies.p_GB[b].cross(momentum) + angular_momentum(bodies, b);
    sums.linear += momentum;
    sums.angular += moment;
    sums.linear_size += momentum.norm();
    sums.angular_size += moment.norm();
  }
  return sums;
}

}  // namespace nilas::sim
