/// The vessel of several bodies: its step. docs/theory/vessel.md
#include <numeric>

#include "core/base/error.h"
#include "core/vessel/tree/carriage_changes.h"
#include "core/vessel/tree/jointed_drift.h"
#include "core/vessel/tree/jointed_vessel.h"
#include "core/vessel/tree/rods.h"
#include "core/vessel/tree/stiff_block.h"

namespace nilas::vessel {

namespace {

void add(double share, const std::vector<Wrench>& part, std::vector<Wrench>& sum) {
  for (std::size_t b = 0; b < sum.size(); ++b) sum[b] += {share * part[b].force, share * part[b].torque};
}

}  // namespace

void JointedVessel::begin_account() {
  impulses_ = JointImpulses(size(), tree_.num_rods());
  joint_account_ = {};
  q_start_ = tree_.coordinates();
  u_start_ = tree_.speeds();
  start_ = now_;
  momenta_.clear();
  for (int b = 0; b < tree_.num_bodies(); ++b) momenta_.push_back(tree_.momentum(b));
}

/// The carriage at its present place, with its mean speeds between two instants; for equal instants, the speeds there.
CarriageMotion::State JointedVessel::with_mean_speed(double from, double to) const {
  CarriageMotion::State carriage = now_;
  if (!motion_) return carriage;
  const CarriageMotion::State a = motion_->at(from), b = motion_->at(to);
  carriage.v = to > from ? Vec3((b.p - a.p) / (to - from)) : a.v;
  carriage.yaw_rate = to > from ? (b.yaw - a.yaw) / (to - from) : a.yaw_rate;
  return carriage;
}

/// Adds joint impulses at the present pose, and the carriage's work on the hull in them to `work`.
void JointedVessel::add_impulses(const CarriageMotion::State& carriage, double share, const std::vector<Wrench>& joints,
                                 double& work) {
  add(share, joints, impulses_.joint);
  add(share, tree_.net_loads(joints), impulses_.net);
  if (!motion_) return;
  const Wrench& hull = joints.front();
  const Vec3 torque = hull.torque + (tree_.joint_point(0) - carriage.p).cross(hull.force);
  impulses_.carriage_about_point += {share * hull.force, share * torque};
  work += share * (hull.force.dot(carriage.v) + torque.z() * carriage.yaw_rate);
}

/// Adds impulses of tension at the present pose.
void JointedVessel::add_rods(double share, const VecX& tensions) {
  impulses_.rods += share * tensions;
  add(share, tree_.rod_loads(tensions), impulses_.net);
}

void JointedVessel::demand_rods(double t) const {
  if (!has_rods()) return;
  if (const auto failed = failed_rod(tree_, rods_))
    throw SimulationError("at " + std::to_string(t) + " s rod '" + rods_[*failed].name +
                          "' is at a dead point: what it holds can move along it no more");
}

/// Change of the speeds of a tree at rest when the carriage changes its speeds at one instant. Speeds other than the
/// loose ones move only if the rods require it.
JointedVessel::SpeedChange JointedVessel::jump_with(const CarriageMotion::State& change) const {
  VecX impulse = tree_.force(std::vector<Wrench>(size()), change);
  const MatX mass = tree_.mass_matrix(), rods = has_rods() ? tree_.rod_jacobian() : MatX();
  std::vector<int> moving = loose_;
  if (has_rods() && !obey_with(rods, loose_)) {
    moving.resize(static_cast<std::size_t>(impulse.size()));
    std::iota(moving.begin(), moving.end(), 0);
  }
  VecX jump = VecX::Zero(impulse.size()), tensions = VecX::Zero(tree_.num_rods());
  if (!moving.empty()) {
    const MatX of_moving = mass(moving, moving);
    VecX speeds = of_moving.llt().solve(VecX(impulse(moving)));
    if (has_rods()) {
      const HeldByRods held = held_by_rods(of_moving, rods(Eigen::all, moving), tree_.rod_rates(change), speeds);
      speeds = held.speeds;
      tensions = held.tensions;
      impulse -= rods.transpose() * tensions;
    }
    for (std::size_t i = 0; i < moving.size(); ++i) jump[moving[i]] = speeds[static_cast<Eigen::Index>(i)];
  }
  VecX borne = impulse - mass * jump;
  for (const int i : moving) borne[i] = 0;
  return {jump, borne, tensions};
}

/// Gives the carriage the speeds of `next` at one instant; the impulse acts on the vessel.
void JointedVessel::change_speeds(const CarriageMotion::State& next, JointAccount::Motion& work) {
  const CarriageMotion::State change = change_between(now_, next);
  if (change.v.isZero(0) && change.yaw_rate == 0) return;
  const VecX u = tree_.speeds();
  tree_.set_carriage(stopped(now_));
  tree_.set_speeds(VecX::Zero(u.size()));
  const auto [jump, borne, tensions] = jump_with(change);
  std::vector<Wrench> given(size());
  if (has_rods()) {
    given = tree_.rod_loads(tensions);
    add_rods(1, tensions);
  }
  add_impulses(between(now_, next), 1, tree_.joint_loads(jump, change, given), work.carriage);
  work.springs -= borne.dot(u);
  now_ = next;
  tree_.set_carriage(now_);
  tree_.set_speeds(u + jump);
}

/// Moves the vessel between two instants, with the carriage's mean speeds.
void JointedVessel::move(double from, double to, JointAccount::Motion& work) {
  if (!(to > from)) return;
  change_speeds(with_mean_speed(from, to), work);
  const VecX put_right =
      drift(tree_, now_, to - from,
            [&](const CarriageMotion::State& carriage, double time, const VecX& accelerations, const VecX& tensions) {
              std::vector<Wrench> given(size());
              if (has_rods()) {
                given = tree_.rod_loads(tensions);
                add_rods(time, tensions);
              }
              add_impulses(carriage, time, tree_.joint_loads(accelerations, {}, given), work.carriage);
            });
  if (has_rods()) add_rods(1, put_right);
  if (!motion_) return;
  const CarriageMotion::State end = motion_->at(to);
  now_.p = end.p;
  now_.yaw = end.yaw;
  tree_.set_carriage(now_);
}

void JointedVessel::move_before_step(double h) {
  begin_account();
  move(time_, time_ + (1 - theta_) * h, joint_account_.before);
  read_states();
}

void JointedVessel::abandon_motion() {
  now_ = start_;
  tree_.set_carriage(now_);
  tree_.set_coordinates(q_start_);
  tree_.set_speeds(u_start_);
  read_states();
}

std::vector<Wrench> JointedVessel::free_loads() const {
  std::vector<Wrench> loads{free_};
  loads.insert(loads.end(), free_on_parts_.begin(), free_on_parts_.end());
  return loads;
}

std::vector<Wrench> JointedVessel::contact_impulses(const Wrench& on_hull) const {
  std::vector<Wrench> impulses{on_hull};
  impulses.insert(impulses.end(), contact_on_parts_.begin(), contact_on_parts_.end());
  return impulses;
}

/// Acceleration of the carriage in the velocity step.
CarriageMotion::State JointedVessel::mean_acceleration() const {
  CarriageMotion::State acceleration = change_between(now_, next_);
  acceleration.v /= h_;
  acceleration.yaw_rate /= h_;
  return acceleration;
}

/// Change of the carriage's speeds over the present step outside of the velocity step, which takes them from now_ to
/// next_.
CarriageMotion::State JointedVessel::change_outside_step() const {
  CarriageMotion::State change = change_between(start_, motion_->at(time_ + h_));
  const CarriageMotion::State inside = change_between(now_, next_);
  change.v -= inside.v;
  change.yaw_rate -= inside.yaw_rate;
  return change;
}

/// Springs act at the mean of three poses: the present one and those before and after it. Dampers act at the speeds
/// after the step or at the mean of both. Therefore no stiffness or damping requires a shorter step. Cells take the
/// exact step of stiff_block.h, in which the parts' speeds are free.
VesselBlock JointedVessel::begin_step() {
  const double start = time_ + (1 - theta_) * h_;
  if (start == time_) begin_account();
  next_ = with_mean_speed(start, time_ + h_);
  const CarriageMotion::State acceleration = mean_acceleration();
  u_before_ = tree_.speeds();
  const VecX of_cells = tree_.cell_force();
  // The force is taken at rest, without Coriolis terms: those act while the vessel moves.
  const VecX still = VecX::Zero(u_before_.size());
  tree_.set_speeds(still);
  tree_.set_carriage(stopped(now_));
  VecX force = tree_.force(free_loads(), acceleration);
  if (motion_) force += jump_with(change_outside_step()).borne / h_;
  MatX mass = tree_.mass_matrix(), momentum = mass;
  if (cells_) {
    const StiffBlock step = stiff_block(mass, cells_->stiffness, cells_->damping_time, cells_->free, h_);
    mass = step.mass;
    momentum = step.mass * step.kept;
  }
  const VecX spring = 0.25 * h_ * h_ * tree_.stiffness(), damper = h_ * tree_.damping();
  block_ = {};
  block_.mass = mass;
  block_.mass.diagonal() += spring + damper_share_ * damper;
  block_.f = momentum * u_before_ + (spring - (1 - damper_share_) * damper).cwiseProduct(u_before_) +
             h_ * (force + of_cells - tree_.stiffness().cwiseProduct(tree_.stretch()));
  tree_.set_carriage(next_);
  block_.hull = {tree_.jacobian(0), tree_.twist(0)};
  for (int b = 1; b < tree_.num_bodies(); ++b) block_.parts.push_back({tree_.jacobian(b), tree_.twist(b)});
  if (!has_rods()) return block_;
  demand_rods(start);
  rod_jacobian_ = tree_.rod_jacobian();
  rod_rates_ = tree_.rod_rates();
  return block_on_rods(block_, rod_jacobian_, rod_rates_);
}

void JointedVessel::finish_step(const Wrench& contact) {
  const std::vector<Wrench> impulses = contact_impulses(contact);
  std::vector<Wrench> given = free_loads();
  add(1 / h_, impulses, given);

  // The velocity step.
  VecX momentum = block_.f;
  for (std::size_t b = 0; b < size(); ++b) {
    Vec6 r;
    r << impulses[b].force, impulses[b].torque;
    momentum += (b == 0 ? block_.hull : block_.parts[b - 1]).jacobian.transpose() * r;
  }
  VecX u(momentum.size());
  if (momentum.size() > 0) u = block_.mass.llt().solve(momentum);
  std::vector<Wrench> of_rods;  ///< means over the step
  if (has_rods()) {
    const HeldByRods held = held_by_rods(block_.mass, rod_jacobian_, rod_rates_, u);
    u = held.speeds;
    impulses_.rods += held.tensions;
    of_rods = tree_.rod_loads(held.tensions / h_);
    add(1, of_rods, given);
  }
  if (!u.allFinite())
    throw SimulationError("at " + std::to_string(time_ + h_) +
                          " s the speeds of the vessel's joints left finite numbers");
  const CarriageMotion::State acceleration = mean_acceleration();
  tree_.set_carriage(stopped(now_));
  tree_.set_speeds(VecX::Zero(u.size()));
  const std::vector<Wrench> joints = tree_.joint_loads((u - u_before_) / h_, acceleration, given);
  joint_account_.held = tree_.net_loads(joints);
  if (has_rods()) add(1, of_rods, joint_account_.held);
  add_impulses(between(now_, next_), h_, joints, joint_account_.carriage_work);
  const VecX mean = 0.5 * (u + u_before_);
  const VecX spring_impulse = tree_.mass_matrix() * (u - u_before_) - h_ * tree_.force(given, acceleration);
  joint_account_.spring_work = spring_impulse.dot(mean);
  now_ = next_;
  tree_.set_carriage(now_);
  tree_.set_speeds(u);
  for (int b = 0; b < tree_.num_bodies(); ++b) after_[b] = tree_.twist(b);

  // The motion after it.
  const double start = time_ + (1 - theta_) * h_, end = time_ + h_;
  move(start, end, joint_account_.after);
  change_speeds(with_mean_speed(end, end), joint_account_.after);
  demand_rods(end);
  read_states();
  read_loads(given);
}

}  // namespace nilas::vessel
