#include "core/sim/reference_vessel.h"

#include "core/base/error.h"

namespace nilas {

ReferenceVessel::ReferenceVessel(const VesselModel& model, int hull) : tree_(model), hull_(hull) {
  NILAS_DEMAND(!model.carriage);
}

int ReferenceVessel::size() const { return static_cast<int>(tree_.coordinates().size()) + tree_.num_speeds(); }

VecX ReferenceVessel::state() const {
  VecX y(size());
  y << tree_.coordinates(), tree_.speeds();
  return y;
}

void ReferenceVessel::set_state(const VecX& y, Bodies& bodies) {
  tree_.set_coordinates(y.head(y.size() - tree_.num_speeds()));
  tree_.set_speeds(y.tail(tree_.num_speeds()));
  copy_to(bodies);
}

void ReferenceVessel::copy_to(Bodies& bodies) const {
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

std::vector<Wrench> ReferenceVessel::of_vessel(const Wrenches& loads) const {
  const auto first = loads.begin() + hull_;
  return {first, first + tree_.num_bodies()};
}

VecX ReferenceVessel::joint_forces() const {
  return -tree_.stiffness().cwiseProduct(tree_.stretch()) - tree_.damping().cwiseProduct(tree_.speeds());
}

VecX ReferenceVessel::accelerations(const Wrenches& loads) const {
  return response(tree_.force(of_vessel(loads), {}) + joint_forces());
}

Vec6 ReferenceVessel::twist_rate(int body, const VecX& accelerations) const {
  return tree_.jacobian(body - hull_) * accelerations + bias(body);
}

Vec6 ReferenceVessel::bias(int body) const { return tree_.twist_bias(body - hull_); }

VecX ReferenceVessel::generalised(int body, const Vec6& load) const {
  return tree_.jacobian(body - hull_).transpose() * load;
}

VecX ReferenceVessel::response(const VecX& impulse) const {
  if (impulse.size() == 0) return impulse;
  return tree_.mass_matrix().llt().solve(impulse);
}

void ReferenceVessel::set_speeds(const VecX& u, Bodies& bodies) {
  tree_.set_speeds(u);
  copy_to(bodies);
}

void ReferenceVessel::add_to_speeds(const VecX& change, Bodies& bodies) { set_speeds(tree_.speeds() + change, bodies); }

ArticulatedBlock ReferenceVessel::block(const VecX& speeds) const {
  ArticulatedBlock block{{}, tree_.mass_matrix(), {}};
  block.f = block.mass * speeds;
  for (int k = 0; k < tree_.num_bodies(); ++k) block.bodies.push_back({hull_ + k, tree_.jacobian(k)});
  return block;
}

double ReferenceVessel::joint_power() const { return joint_forces().dot(tree_.speeds()); }

std::vector<PartState> ReferenceVessel::parts(const Wrenches& loads) {
  const std::vector<Wrench> given = of_vessel(loads);
  const VecX found = accelerations(loads);
  const std::vector<Wrench> joints = tree_.joint_loads(found, {}, given), net = tree_.net_loads(joints);
  std::vector<PartState> parts;
  for (int k = 1; k < tree_.num_bodies(); ++k) {
    const auto b = static_cast<std::size_t>(k);
    const Vec6 twist = tree_.twist(k), rate = twist_rate(hull_ + k, found);
    const Mat3 inertia = tree_.inertia_G(k);
    PartState part;
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

}  // namespace nilas
