#include "core/vessel/tree/jointed_tree.h"

#include "core/base/error.h"
#include "core/vessel/tree/jointed_tree_implementation.h"

namespace nilas::vessel {

namespace {

/// Rotation vector of the shorter rotation to the attitude q.
Vec3 rotation_vector(const SimTK::Vec4& q) {
  const Quat unit(q[0] < 0 ? -q[0] : q[0], q[0] < 0 ? -q[1] : q[1], q[0] < 0 ? -q[2] : q[2], q[0] < 0 ? -q[3] : q[3]);
  const double sine = unit.vec().norm();
  return sine > 0 ? Vec3(2 * std::atan2(sine, unit.w()) / sine * unit.vec()) : Vec3(Vec3::Zero());
}

/// Whether the coordinates of such a joint begin with a quaternion.
bool has_quaternion(JointKind kind) { return kind == JointKind::ball || kind == JointKind::free; }

}  // namespace

JointedTree::JointedTree(const VesselModel& model) : implementation_(std::make_unique<Implementation>()) {
  NILAS_DEMAND(!(model.fixed && model.carriage));
  Implementation& tree = *implementation_;
  Pose hull_in_G{model.pose_V.q.normalized(), Vec3::Zero()};
  hull_in_G.p = model.pose_V.p + hull_in_G.q * model.mass.com;
  tree.length_unit = model.length_unit;
  tree.add_hull(model, hull_in_G);
  tree.add_parts(model);
  tree.add_rods(model);
  tree.begin_state();
  tree.place_parts();
  if (tree.free_hull) tree.place_free_hull(model, hull_in_G);
}

JointedTree::~JointedTree() = default;
JointedTree::JointedTree(JointedTree&&) noexcept = default;
JointedTree& JointedTree::operator=(JointedTree&&) noexcept = default;

int JointedTree::num_bodies() const { return static_cast<int>(implementation_->bodies.size()); }
int JointedTree::num_speeds() const { return implementation_->speeds; }
bool JointedTree::has_carriage() const { return implementation_->carried > 0; }
bool JointedTree::hull_is_free() const { return implementation_->free_hull; }
double JointedTree::mass(int body) const { return implementation_->body(body).mass; }
int JointedTree::parent(int body) const { return implementation_->body(body).parent; }
const VecX& JointedTree::stiffness() const { return implementation_->stiffness; }
const VecX& JointedTree::damping() const { return implementation_->damping; }

VecX JointedTree::coordinates() const {
  const Implementation& tree = *implementation_;
  VecX q(tree.state.getNQ() - tree.carried);
  for (int i = 0; i < q.size(); ++i) q[i] = tree.state.getQ()[tree.carried + i];
  return q;
}

VecX JointedTree::speeds() const {
  const Implementation& tree = *implementation_;
  VecX u(tree.speeds);
  for (int i = 0; i < u.size(); ++i) u[i] = tree.state.getU()[tree.carried + i];
  return u;
}

void JointedTree::set_coordinates(const VecX& q) {
  Implementation& tree = *implementation_;
  NILAS_DEMAND(q.size() == tree.state.getNQ() - tree.carried);
  SimTK::Vector& all = tree.state.updQ();
  for (int i = 0; i < q.size(); ++i) all[tree.carried + i] = q[i];
}

void JointedTree::normalise_quaternions() {
  Implementation& tree = *implementation_;
  SimTK::Vector& all = tree.state.updQ();
  for (std::size_t b = 0; b < tree.bodies.size(); ++b) {
    const auto& body = tree.bodies[b];
    if (b == 0 ? !tree.free_hull : !has_quaternion(body.part.joint)) continue;
    SimTK::Vec4 quaternion = SimTK::Vec4::getAs(&all[body.first_q]);
    quaternion /= quaternion.norm();
    for (int i = 0; i < 4; ++i) all[body.first_q + i] = quaternion[i];
  }
}

std::pair<int, int> JointedTree::speeds_of(int body) const {
  const Implementation& tree = *implementation_;
  const auto& one = tree.body(body);
  return {one.first_u - tree.carried, one.mobilized.getNumU(tree.state)};
}

VecX JointedTree::moved(const VecX& q, const VecX& along) const {
  const Implementation& tree = *implementation_;
  VecX out = q;
  for (int b = 0; b < num_bodies(); ++b) {
    const auto& body = tree.body(b);
    const auto [from, count] = speeds_of(b);
    int to = body.first_q - tree.carried, done = 0;
    if (count > 0 && (b == 0 ? tree.free_hull : has_quaternion(body.part.joint))) {
      const Vec3 turn = along.segment<3>(from);
      const double angle = turn.norm();
      const Quat before(q[to], q[to + 1], q[to + 2], q[to + 3]);
      const Quat turned = angle > 0 ? Quat(Eigen::AngleAxisd(angle, Vec3(turn / angle))) * before : before;
      out.segment<4>(to) << turned.w(), turned.x(), turned.y(), turned.z();
      to += 4;
      done = 3;
    }
    for (; done < count; ++done) out[to++] += along[from + done];
  }
  return out;
}

void JointedTree::set_speeds(const VecX& u) {
  Implementation& tree = *implementation_;
  NILAS_DEMAND(u.size() == tree.speeds);
  SimTK::Vector& all = tree.state.updU();
  for (int i = 0; i < u.size(); ++i) all[tree.carried + i] = u[i];
}

void JointedTree::set_carriage(const CarriageMotion::State& state) {
  Implementation& tree = *implementation_;
  if (tree.carried == 0) return;
  tree.state.updQ()(0, tree.carried) = SimTK::Vector(SimTK::Vec3(state.yaw, state.p.x(), state.p.y()));
  tree.state.updU()(0, tree.carried) = SimTK::Vector(SimTK::Vec3(state.yaw_rate, state.v.x(), state.v.y()));
}

Mat3 JointedTree::inertia_G(int body) const {
  const Mat3 R = pose(body).q.toRotationMatrix();
  return R * implementation_->body(body).inertia * R.transpose();
}

Pose JointedTree::pose(int body) const {
  const SimTK::State& state = implementation_->at(SimTK::Stage::Position);
  return from_simbody(implementation_->body(body).mobilized.getBodyTransform(state));
}

Vec6 JointedTree::twist(int body) const {
  const SimTK::State& state = implementation_->at(SimTK::Stage::Velocity);
  const SimTK::SpatialVec& V = implementation_->body(body).mobilized.getBodyVelocity(state);
  Vec6 twist;
  twist << from_simbody(V[1]), from_simbody(V[0]);
  return twist;
}

Vec6 JointedTree::momentum(int body) const {
  const Vec6 velocity = twist(body);
  Vec6 momentum;
  momentum << mass(body) * velocity.head<3>(), inertia_G(body) * velocity.tail<3>();
  return momentum;
}

MatX JointedTree::mass_matrix() const {
  const Implementation& tree = *implementation_;
  SimTK::Matrix all;
  tree.matter.calcM(tree.at(SimTK::Stage::Position), all);
  MatX mass(tree.speeds, tree.speeds);
  for (int i = 0; i < tree.speeds; ++i)
    for (int j = 0; j < tree.speeds; ++j)
      mass(i, j) = 0.5 * (all(tree.carried + i, tree.carried + j) + all(tree.carried + j, tree.carried + i));
  return mass;
}

MatX JointedTree::jacobian(int body) const {
  const Implementation& tree = *implementation_;
  SimTK::RowVector_<SimTK::SpatialVec> all;
  tree.matter.calcFrameJacobian(tree.at(SimTK::Stage::Position), tree.body(body).mobilized, SimTK::Vec3(0), all);
  MatX jacobian(6, tree.speeds);
  for (int j = 0; j < tree.speeds; ++j) {
    const SimTK::SpatialVec& column = all[tree.carried + j];
    jacobian.col(j) << from_simbody(column[1]), from_simbody(column[0]);
  }
  return jacobian;
}

Vec6 JointedTree::twist_bias(int body) const {
  const Implementation& tree = *implementation_;
  const SimTK::State& state = tree.at(SimTK::Stage::Velocity);
  const SimTK::MobilizedBodyIndex place = tree.body(body).mobilized.getMobilizedBodyIndex();
  const SimTK::SpatialVec found = tree.matter.calcBiasForFrameJacobian(state, place, SimTK::Vec3(0));
  Vec6 bias;
  bias << from_simbody(found[1]), from_simbody(found[0]);
  return bias;
}

VecX JointedTree::coordinate_rates() const {
  const Implementation& tree = *implementation_;
  const SimTK::Vector& all = tree.at(SimTK::Stage::Velocity).getQDot();
  VecX rates(all.size() - tree.carried);
  for (int i = 0; i < rates.size(); ++i) rates[i] = all[tree.carried + i];
  return rates;
}

VecX JointedTree::force(const std::vector<Wrench>& loads, const CarriageMotion::State& acceleration) const {
  const Implementation& tree = *implementation_;
  const SimTK::Vector missing =
      tree.residual(tree.all_accelerations(VecX::Zero(tree.speeds), acceleration), tree.spatial(loads));
  VecX force(tree.speeds);
  for (int i = 0; i < tree.speeds; ++i) force[i] = -missing[tree.carried + i];
  return force;
}

VecX JointedTree::cell_force() const {
  const Implementation& tree = *implementation_;
  return tree.cells.along_speeds(tree.at(SimTK::Stage::Velocity)).tail(tree.speeds);
}

double JointedTree::cell_energy() const {
  const Implementation& tree = *implementation_;
  return tree.cells.energy(tree.at(SimTK::Stage::Position));
}

std::vector<Wrench> JointedTree::joint_loads(const VecX& accelerations, const CarriageMotion::State& acceleration,
                                             const std::vector<Wrench>& loads) {
  Implementation& tree = *implementation_;
  const SimTK::Vector_<SimTK::SpatialVec> on_bodies = tree.spatial(loads);
  SimTK::Vector mobility = tree.residual(tree.all_accelerations(accelerations, acceleration), on_bodies);
  const VecX of_cells = tree.cells.along_speeds(tree.at(SimTK::Stage::Velocity));
  for (int i = 0; i < of_cells.size(); ++i) mobility[i] -= of_cells[i];
  if (tree.carried > 0) {
    mobility(0, tree.carried) = SimTK::Vector(tree.carried, 0.0);
    tree.carriage.lockAt(tree.state, SimTK::Vec3(acceleration.yaw_rate, acceleration.v.x(), acceleration.v.y()),
                         SimTK::Motion::Acceleration);
  }
  tree.applied.setAllMobilityForces(tree.state, mobility);
  tree.applied.setAllBodyForces(tree.state, on_bodies);
  SimTK::Vector_<SimTK::SpatialVec> reactions;
  tree.matter.calcMobilizerReactionForces(tree.at(SimTK::Stage::Acceleration), reactions);
  std::vector<Wrench> out;
  for (const auto& body : tree.bodies) {
    const SimTK::SpatialVec& load = reactions[body.mobilized.getMobilizedBodyIndex()];
    out.push_back({from_simbody(load[1]), from_simbody(load[0])});
  }
  return out;
}

Vec3 JointedTree::joint_point(int body) const {
  const SimTK::State& state = implementation_->at(SimTK::Stage::Position);
  const SimTK::MobilizedBody& mobilized = implementation_->body(body).mobilized;
  return from_simbody(mobilized.getBodyTransform(state) * mobilized.getOutboardFrame(state).p());
}

std::vector<Wrench> JointedTree::net_loads(const std::vector<Wrench>& joints) const {
  std::vector<Wrench> net(joints.size());
  for (int b = 0; b < num_bodies(); ++b) {
    const Wrench& load = joints[b];
    const Vec3 point = joint_point(b);
    const auto add = [&](int body, double sign) {
      const Vec3 force = sign * load.force;
      net[body] += {force, sign * load.torque + (point - pose(body).p).cross(force)};
    };
    add(b, 1);
    if (parent(b) >= 0) add(parent(b), -1);
  }
  return net;
}

VecX JointedTree::stretch() const {
  const Implementation& tree = *implementation_;
  VecX out = VecX::Zero(tree.speeds);
  for (std::size_t b = 1; b < tree.bodies.size(); ++b) {
    const PartModel& part = tree.bodies[b].part;
    const VecX x = part_coordinates(static_cast<int>(b) - 1);
    if (x.size() == 0) continue;
    out.segment(tree.bodies[b].first_u - tree.carried, x.size()) = x;
    if (has_one_coordinate(part.joint)) out[tree.bodies[b].first_u - tree.carried] -= part.rest;
  }
  return out;
}

VecX JointedTree::part_coordinates(int part) const {
  const Implementation& tree = *implementation_;
  const auto& body = tree.body(part + 1);
  const SimTK::Vector& q = tree.state.getQ();
  if (has_one_coordinate(body.part.joint)) return VecX::Constant(1, q[body.first_q]);
  if (body.part.joint != JointKind::ball) return {};
  return rotation_vector(SimTK::Vec4::getAs(&q[body.first_q]));
}

VecX JointedTree::part_rates(int part) const {
  const Implementation& tree = *implementation_;
  const auto& body = tree.body(part + 1);
  const SimTK::Vector& u = tree.state.getU();
  if (has_one_coordinate(body.part.joint)) return VecX::Constant(1, u[body.first_u]);
  if (body.part.joint != JointKind::ball) return {};
  return Vec3(u[body.first_u], u[body.first_u + 1], u[body.first_u + 2]);
}

int JointedTree::num_rods() const { return implementation_->rods.size(); }

double JointedTree::rod_distance(int rod) const {
  return implementation_->rods.distance(rod, implementation_->at(SimTK::Stage::Position));
}

double JointedTree::length_unit() const { return implementation_->length_unit; }

void JointedTree::set_rod_length(int rod, double length) {
  implementation_->rods.set_length(rod, length, implementation_->state);
}

VecX JointedTree::rod_errors() const {
  return implementation_->rods.errors(implementation_->at(SimTK::Stage::Position));
}

MatX JointedTree::rod_jacobian() const {
  const Implementation& tree = *implementation_;
  return tree.rods.jacobian(tree.matter, tree.at(SimTK::Stage::Position)).rightCols(tree.speeds);
}

VecX JointedTree::rod_rates() const { return implementation_->rods.rates(implementation_->at(SimTK::Stage::Velocity)); }

VecX JointedTree::rod_rates(const CarriageMotion::State& acceleration) const {
  const Implementation& tree = *implementation_;
  const MatX jacobian = tree.rods.jacobian(tree.matter, tree.at(SimTK::Stage::Position));
  const Vec3 given(acceleration.yaw_rate, acceleration.v.x(), acceleration.v.y());
  return jacobian.leftCols(tree.carried) * given.head(tree.carried);
}

VecX JointedTree::rod_bias() const {
  return implementation_->rods.bias(implementation_->matter, implementation_->at(SimTK::Stage::Velocity));
}

std::vector<Wrench> JointedTree::rod_loads(const VecX& tensions) const {
  const Implementation& tree = *implementation_;
  return tree.rods.loads(tensions, tree.bodies.size(), tree.at(SimTK::Stage::Position));
}

void JointedTree::displace(const VecX& along_speeds) {
  Implementation& tree = *implementation_;
  SimTK::Vector change;
  tree.matter.multiplyByN(tree.at(SimTK::Stage::Position), false, tree.all_accelerations(along_speeds, {}), change);
  tree.state.updQ() += change;
  normalise_quaternions();
}

}  // namespace nilas::vessel
