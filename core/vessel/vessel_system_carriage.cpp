#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

#include "core/base/error.h"
#include "core/vessel/model/cells.h"
#include "core/vessel/tree/carried_vessel.h"

namespace nilas::vessel {

std::vector<int> free_axes(const CarriageModel& carriage) {
  if (carriage.balance == BalanceKind::prismatic) return {k_heave};
  std::vector<int> axes;
  for (int axis = 0; axis < 6; ++axis)
    if (carriage.free[(axis + 3) % 6]) axes.push_back(axis);
  return axes;
}

namespace {

std::vector<int> coordinate_axes(const CarriageModel& carriage) {
  if (carriage.balance == BalanceKind::six_cells) return {0, 1, 2, 3, 4, 5};
  return free_axes(carriage);
}

/// The carriage before it moves, to which the scene's vessel pose refers.
CarriageMotion::State at_rest(const CarriageMotion& motion) { return motion.at(std::numeric_limits<double>::lowest()); }

Quat turned(double yaw) { return Quat(Eigen::AngleAxisd(yaw, Vec3::UnitZ())); }

}  // namespace

std::vector<int> free_coordinates(const CarriageModel& carriage) {
  const std::vector<int> axes = free_axes(carriage);
  if (carriage.balance == BalanceKind::six_cells) return axes;
  std::vector<int> all(axes.size());
  std::iota(all.begin(), all.end(), 0);
  return all;
}

std::vector<TreeCell> carriage_cells(const CarriageModel& carriage) {
  if (carriage.balance != BalanceKind::six_cells) return {};
  const std::string where = "force balance six-cells: ";
  if (!(carriage.stiffness > 0)) throw InputError(where + "stiffness must be > 0 N/m");
  if (!(carriage.damping >= 0)) throw InputError(where + "damping must be >= 0 N s/m");
  if (!(layout_condition(carriage.cells) <= k_max_layout_condition))
    throw InputError(where + "the layout of the cells is singular");
  const Mat6 shortenings = cell_shortenings(cell_wrenches(carriage.cells), free_axes(carriage));
  std::vector<TreeCell> cells;
  for (int k = 0; k < 6; ++k) cells.push_back({shortenings.row(k).transpose(), carriage.stiffness, carriage.damping});
  return cells;
}

TreeJoint carriage_joint(const VesselModel& model) {
  const CarriageModel& carriage = *model.carriage;
  const CarriageMotion::State rest = at_rest(carriage.motion);
  const Quat q_GV = model.pose_V.q.normalized();
  // Vessel and carriage must agree on the joint's place at the start.
  constexpr double k_place_tolerance = 1e-9;
  const Vec3 start = model.pose_V.p + q_GV * carriage.joint_V;
  NILAS_DEMAND((start - rest.p).norm() <= k_place_tolerance * (1 + start.norm()));
  TreeJoint joint;
  joint.in_B = {q_GV.conjugate() * turned(rest.yaw), carriage.joint_V - model.mass.com};
  joint.height = rest.p.z();
  joint.axes = coordinate_axes(carriage);
  return joint;
}

CarriedVessel::CarriedVessel(const VesselModel& model, double t0)
    : VesselMotion(model, t0),
      motion_(model.carriage->motion),
      tree_(model.mass, carriage_joint(model), carriage_cells(*model.carriage)) {
  const CarriageModel& carriage = *model.carriage;
  const int n = tree_.size();
  axes_ = coordinate_axes(carriage);
  has_three_angles_ = axes_.size() >= 3 && axes_[2] == 2;
  free_coordinates_ = free_coordinates(carriage);
  stiffness_ = MatX::Zero(n, n);
  if (carriage.balance == BalanceKind::six_cells) {
    const Mat6 wrenches = cell_wrenches(carriage.cells);
    cells_.emplace(wrenches);
    stiffness_ = condensed_stiffness(wrenches, carriage.stiffness, free_coordinates_);
    damping_time_ = carriage.damping / carriage.stiffness;
  }
  q_ = VecX::Zero(n);
  u_ = VecX::Zero(n);
  now_ = motion_.at(t0);
  place(now_, u_);
}

Vec6 CarriedVessel::velocity_after_impulses() const {
  Vec6 twist;
  twist << state_.v, state_.w;
  return twist;
}

VecX CarriedVessel::coordinates() const {
  VecX all(q_.size() + u_.size());
  all << q_, u_;
  return all;
}

void CarriedVessel::save_motion(StateWriter& out) const {
  out.add("coordinates", q_);
  out.add("speeds", u_);
  out.add("carriage_p", now_.p);
  out.add("carriage_yaw", now_.yaw);
  out.add("carriage_v", now_.v);
  out.add("carriage_yaw_rate", now_.yaw_rate);
}

void CarriedVessel::restore_motion(const StateReader& in) {
  in.get("coordinates", q_);
  in.get("speeds", u_);
  in.get("carriage_p", now_.p);
  in.get("carriage_yaw", now_.yaw);
  in.get("carriage_v", now_.v);
  in.get("carriage_yaw_rate", now_.yaw_rate);
  tree_.set_coordinates(q_);
  tree_.set_carriage(now_);
  tree_.set_speeds(u_);
}

void CarriedVessel::place(const CarriageMotion::State& carriage, const VecX& u) {
  tree_.set_coordinates(q_);
  tree_.set_carriage(carriage);
  set_speeds(u);
}

void CarriedVessel::set_speeds(const VecX& u) {
  tree_.set_speeds(u);
  const Vec6 twist = tree_.twist();
  state_ = {tree_.pose(), twist.head<3>(), twist.tail<3>()};
}

Vec6 CarriedVessel::momentum() const {
  Vec6 p;
  p << mass_.mass * state_.v, inertia_G() * state_.w;
  return p;
}

Vec6 CarriedVessel::mean_carriage_twist(const CarriageMotion::State& next) const {
  const Vec3 arm = state_.pose.p - now_.p;
  const double turn = next.yaw - now_.yaw;
  Vec6 twist;
  twist << next.p - now_.p + turned(turn) * arm - arm, 0, 0, turn;
  return twist / h_;
}

void CarriedVessel::demand_regular(double t) const {
  const std::string when = "at " + std::to_string(t) + " s ";
  if (!q_.allFinite()) throw SimulationError(when + "the vessel's joint coordinates left finite numbers");
  constexpr double k_gimbal_cosine = 1e-6;  // nearer to pitch 90 degrees, roll and yaw are one axis to rounding
  if (has_three_angles_ && std::abs(std::cos(q_[1])) < k_gimbal_cosine)
    throw SimulationError(when + "the joint's pitch is 90 degrees: roll and yaw have become one axis");
}

void CarriedVessel::read_loads(const Vec6& reaction, const Vec3& com, const CarriageMotion::State& carriage) {
  loads_.about_com = {reaction.head<3>(), reaction.tail<3>()};
  loads_.about_joint = loads_.about_com;
  loads_.about_joint.torque += (com - carriage.p).cross(loads_.about_com.force);
  if (cells_) loads_.cells = cell_readings(*cells_, loads_.about_joint, carriage.yaw);
}

/// The momenta give the reaction as a mean over the step; Simbody gives it at one instant. Simbody therefore evaluates
/// it halfway, with the mean of the speeds, their actual change as the acceleration, and contact impulses spread over
/// the step.
void CarriedVessel::ask_simbody(const StepEnd& start, const StepEnd& end, const Vec6& given) {
  CarriageMotion::State halfway, acceleration;
  halfway.p = 0.5 * (start.carriage.p + end.carriage.p);
  halfway.yaw = 0.5 * (start.carriage.yaw + end.carriage.yaw);
  halfway.v = 0.5 * (start.carriage.v + end.carriage.v);
  halfway.yaw_rate = 0.5 * (start.carriage.yaw_rate + end.carriage.yaw_rate);
  acceleration.v = (end.carriage.v - start.carriage.v) / h_;
  acceleration.yaw_rate = (end.carriage.yaw_rate - start.carriage.yaw_rate) / h_;
  tree_.set_coordinates(0.5 * (start.q + end.q));
  tree_.set_carriage(halfway);
  tree_.set_speeds(0.5 * (start.u + end.u));
  const Wrench simbody = tree_.reaction({given.head<3>(), given.tail<3>()}, (end.u - start.u) / h_, acceleration);
  loads_.disagreement = {simbody.force - loads_.about_com.force, simbody.torque - loads_.about_com.torque};
}

namespace {

/// Semi-implicit Euler.
class EulerCarriedVessel : public CarriedVessel {
 public:
  using CarriedVessel::CarriedVessel;

 protected:
  VesselBlock begin_step() override;
  void finish_step(const Wrench& contact) override;

 private:
  void keep_free_momentum(const Vec6& given_momentum);

  CarriageMotion::State next_;  ///< carriage at the end of the present step
};

VesselBlock EulerCarriedVessel::begin_step() {
  next_ = motion_.at(time_ + h_);
  // The mean acceleration over the step keeps the momenta exact at kinks of the motion.
  CarriageMotion::State acceleration;
  acceleration.v = (next_.v - now_.v) / h_;
  acceleration.yaw_rate = (next_.yaw_rate - now_.yaw_rate) / h_;
  const VecX force = tree_.force(free_, acceleration);
  jacobian_ = tree_.jacobian();
  step_ = stiff_block(tree_.mass_matrix(), stiffness_, damping_time_, free_coordinates_, h_);
  u_without_contact_ = step_.kept * u_ + h_ * (step_.response * (force + tree_.cell_force()));
  return {step_.mass, step_.mass * u_without_contact_, {jacobian_, mean_carriage_twist(next_)}, {}};
}

void EulerCarriedVessel::finish_step(const Wrench& contact) {
  Vec6 impulse;
  impulse << contact.force, contact.torque;
  Vec6 given = impulse;
  given.head<3>() += h_ * free_.force;
  given.tail<3>() += h_ * free_.torque;
  const Vec6 before = momentum();
  const StepEnd start{q_, u_, now_};

  // new speeds, new pose
  u_ = u_without_contact_ + step_.response * (jacobian_.transpose() * impulse);
  q_ += h_ * u_;
  demand_regular(time_ + h_);
  now_ = next_;
  place(now_, u_);

  // The change of the momenta that no other load explains is the carriage's impulse.
  keep_free_momentum(before + given);
  read_loads((momentum() - before - given) / h_, state_.pose.p, now_);
  ask_simbody(start, {q_, u_, now_}, given / h_);
  place(now_, u_);
}

/// Chooses the speeds of the free coordinates so that the reaction at the new pose has no component along them. Where
/// the axes turn with the vessel, this differs from the speeds that moved it by O(h^2). It never adds energy: a
/// pendulum about the joint loses the share h omega^2 of its energy per second.
void EulerCarriedVessel::keep_free_momentum(const Vec6& given_momentum) {
  if (free_coordinates_.empty()) return;
  const MatX mass = tree_.mass_matrix()(free_coordinates_, free_coordinates_);
  const VecX lack = tree_.jacobian().transpose() * (given_momentum - momentum());
  u_(free_coordinates_) += mass.llt().solve(VecX(lack(free_coordinates_)));
  set_speeds(u_);
}

}  // namespace

std::unique_ptr<VesselMotion> make_carried_vessel(const VesselModel& model, double t0) {
  if (model.theta) return make_moreau_carried_vessel(model, t0);
  return std::make_unique<EulerCarriedVessel>(model, t0);
}

}  // namespace nilas::vessel
