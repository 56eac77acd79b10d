#include "core/sim/reference/reference_vessel.h"

#include <cmath>
#include <limits>

#include "core/base/error.h"
#include "core/vessel/tree/carried_vessel.h"

namespace nilas::sim {

ReferenceVessel::ReferenceVessel(const vessel::VesselModel& model, int hull, double t0, const VecX& start)
    : tree_(model), hull_(hull) {
  if (!model.carriage) return;
  const std::vector<int> axes = vessel::carriage_joint(model).axes;
  has_three_angles_ = axes.size() >= 3 && axes[2] == 2;
  carriage_.emplace(*model.carriage);
  carriage_->begin_stretch(t0);
  tree_.set_carriage(carriage_->now());
  tree_.set_coordinates(start.head(start.size() - tree_.num_speeds()));
  tree_.set_speeds(start.tail(tree_.num_speeds()));
}

void ReferenceVessel::go_to(double t) {
  if (!carriage_) return;
  carriage_->go_to(t);
  tree_.set_carriage(carriage_->now());
}

double ReferenceVessel::stretch_end() const {
  return carriage_ ? carriage_->stretch_end() : std::numeric_limits<double>::infinity();
}

void ReferenceVessel::enter_next_stretch(bodies::Bodies& bodies) {
  const double t = carriage_->stretch_end();
  carriage_->go_to(t);
  const vessel::CarriageMotion::State before = carriage_->now();
  carriage_->begin_stretch(t);
  const vessel::CarriageMotion::State& after = carriage_->now();
  vessel::CarriageMotion::State change;
  change.v = after.v - before.v;
  change.yaw_rate = after.yaw_rate - before.yaw_rate;
  // Both speeds are only known to rounding.
  constexpr double k_rounding = 1e-14;
  if (change.v.norm() <= k_rounding * (1 + after.v.norm()) &&
      std::abs(change.yaw_rate) <= k_rounding * (1 + std::abs(after.yaw_rate)))
    return;
  // Poses do not change during the impulse, and springs give no impulse.
  const VecX u = tree_.speeds();
  vessel::CarriageMotion::State stopped = after;
  stopped.v.setZero();
  stopped.yaw_rate = 0;
  tree_.set_carriage(stopped);
  tree_.set_speeds(VecX::Zero(u.size()));
  const VecX jump = response(tree_.force(std::vector<Wrench>(static_cast<std::size_t>(tree_.num_bodies())), change));
  tree_.set_carriage(after);
  set_speeds(u + jump, bodies);
}

vessel::CarriageLoads ReferenceVessel::carriage_loads(const bodies::Wrenches& loads) {
  Wrench held = tree_.joint_loads(accelerations(loads), carriage_acceleration(), of_vessel(loads)).front();
  const Vec3 com = tree_.pose(0).p;
  held.torque += (tree_.joint_point(0) - com).cross(held.force);
  return carriage_->loads(held, com);
}

void ReferenceVessel::demand_regular(double t) const {
  constexpr double k_gimbal_cosine = 1e-6;  // nearer to pitch 90 degrees, roll and yaw are one axis to rounding
  if (has_three_angles_ && std::abs(std::cos(tree_.coordinates()[1])) < k_gimbal_cosine)
    throw SimulationError("at " + std::to_string(t) +
                          " s the joint's pitch is 90 degrees: roll and yaw have become one axis");
}

int ReferenceVessel::size() const { return static_cast<int>(tree_.coordinates().size()) + tree_.num_speeds(); }

VecX ReferenceVessel::state() const {
  VecX y(size());
  y << tree_.coordinates(), tree_.speeds();
  return y;
}

void ReferenceVessel::set_state(const VecX& y, bodies::Bodies& bodies) {
  tree_.set_coordinates(y.head(y.size() - tree_.num_speeds()));
  tree_.set_speeds(y.tail(tree_.num_speeds()));
  copy_to(bodies);
}

void ReferenceVessel::copy_to(bodies::Bodies& bodies) const {
  for (int k = 0; k < tree_.num_bodies(); ++k) {
    const auto b = static_cast<std::size_t>(hull_ + k);
    const Pose pose = tree_.pose(k);
    const Vec6 twist = tree_.twist(k);
    bodies.set_pose(hull_ + k, pose.p, pose.q);
    bodies.v_GB[b] = twist.head<3>();
    bodies.w_GB[b] = twist.tail<3>();
  }
}

VecX ReferenceVessel::state_rate(const VecX& accelerations) const {
  VecX rate(size());
  rate << tree_.coordinate_rates(), accelerations;
  return rate;
}

std::vector<Wrench> ReferenceVessel::of_vessel(const bodies::Wrenches& loads) const {
  const auto first = loads.begin() + hull_;
  return {first, first + tree_.num_bodies()};
}

vessel::CarriageMotion::State ReferenceVessel::carriage_acceleration() const {
  return carriage_ ? carriage_->acceleration() : vessel::CarriageMotion::State{};
}

/// Spring and damper forces on the speeds of the tree.
VecX ReferenceVessel::joint_forces() const {
  return -tree_.stiffness().cwiseProduct(tree_.stretch()) - tree_.damping().cwiseProduct(tree_.speeds());
}

VecX ReferenceVessel::accelerations(const bodies::Wrenches& loads) const {
  return response(tree_.force(of_vessel(loads), carriage_acceleration()) + joint_forces() + tree_.cell_force());
}

Vec6 ReferenceVessel::twist_rate(int body, const VecX& accelerations) const {
  return tree_.jacobian(body - hull_) * accelerations + bias(body);
}

Vec6 ReferenceVessel::bias(int body) const {
  Vec6 bias = tree_.twist_bias(body - hull_);
  if (!carriage_) return bias;
  const vessel::CarriageMotion::State& acceleration = carriage_->acceleration();
  const Vec3 turn = acceleration.yaw_rate * Vec3::UnitZ();
  bias.head<3>() += acceleration.v + turn.cross(tree_.pose(body - hull_).p - carriage_->now().p);
  bias.tail<3>() += turn;
  return bias;
}

VecX ReferenceVessel::generalised(int body, const Vec6& load) const {
  return tree_.jacobian(body - hull_).transpose() * load;
}

VecX ReferenceVessel::response(const VecX& impulse) const {
  if (impulse.size() == 0) return impulse;
  return tree_.mass_matrix().llt().solve(impulse);
}

void ReferenceVessel::set_speeds(const VecX& u, bodies::Bodies& bodies) {
  tree_.set_speeds(u);
  copy_to(bodies);
}

void ReferenceVessel::add_to_speeds(const VecX& change, bodies::Bodies& bodies) {
  set_speeds(tree_.speeds() + change, bodies);
}

contact::ArticulatedBlock ReferenceVessel::block(const VecX& speeds) const {
  contact::ArticulatedBlock block{{}, tree_.mass_matrix(), {}};
  block.f = block.mass * speeds;
  for (int k = 0; k < tree_.num_bodies(); ++k) block.bodies.push_back({hull_ + k, tree_.jacobian(k)});
  return block;
}

contact::ArticulatedBlock ReferenceVessel::velocity_block() const {
  contact::ArticulatedBlock block = this->block(tree_.speeds());
  for (int k = 0; k < tree_.num_bodies(); ++k) {
    contact::ArticulatedBody& body = block.bodies[k];
    body.prescribed = tree_.twist(k) - body.jacobian * tree_.speeds();
  }
  return block;
}

double ReferenceVessel::joint_power() const { return joint_forces().dot(tree_.speeds()); }

std::vector<vessel::PartState> ReferenceVessel::parts(const bodies::Wrenches& loads) {
  const std::vector<Wrench> given = of_vessel(loads);
  const VecX found = accelerations(loads);
  const std::vector<Wrench> joints = tree_.joint_loads(found, carriage_acceleration(), given),
                            net = tree_.net_loads(joints);
  std::vector<vessel::PartState> parts;
  for (int k = 1; k < tree_.num_bodies(); ++k) {
    const auto b = static_cast<std::size_t>(k);
    const Vec6 twist = tree_.twist(k), rate = twist_rate(hull_ + k, found);
    const Mat3 inertia = tree_.inertia_G(k);
    vessel::PartState part;
    part.state = {tree_.pose(k), twist.head<3>(), twist.tail<3>()};
    part.joint = joints[b];
    part.coordinates = tree_.part_coordinates(k - 1);
    part.rates = tree_.part_rates(k - 1);
    const Vec3 spin = inertia * twist.tail<3>();
    part.unbalanced_force = (tree_.mass(k) * rate.head<3>() - given[b].force - net[b].force).norm();
    part.unbalanced_torque =
        (inertia * rate.tail<3>() + twist.tail<3>().cross(spin) - given[b].torque - net[b].torque).norm();
    parts.push_back(std::move(part));
  }
  return parts;
}

}  // namespace nilas::sim
