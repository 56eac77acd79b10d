#include "core/vessel/tree/vessel_tree.h"

#include "core/base/error.h"
#include "core/vessel/tree/cell_force.h"
#include "core/vessel/tree/simbody_bodies.h"

namespace nilas::vessel {

struct VesselTree::Implementation {
  /// Completes the tree and fills the state. `carriage_speeds`: number of the carriage's speeds, which come first.
  void complete(int carriage_speeds) {
    carriage = carriage_speeds;
    state = system.realizeTopology();
    system.realizeModel(state);
    speeds = state.getNU() - carriage;
  }
  const SimTK::State& at(const SimTK::Stage& stage) const {
    system.realize(state, stage);
    return state;
  }
  SimTK::Vector_<SimTK::SpatialVec> on_vessel(const Wrench& load) const;
  SimTK::Vector missing_forces(const SimTK::Vector_<SimTK::SpatialVec>& loads, const VecX& accelerations,
                               const CarriageMotion::State& acceleration) const;

  SimTK::MultibodySystem system;
  SimTK::SimbodyMatterSubsystem matter{system};
  SimTK::GeneralForceSubsystem forces{system};
  /// Loads that are known before a step. Weight, water and contact act once per step and are evaluated for all bodies
  /// at once, so Simbody receives their sums. A force element that summed the drag of wetted triangles itself would do
  /// so for each state of the tree in a step (docs/theory/vessel.md).
  SimTK::Force::DiscreteForces applied{forces, matter};
  CellForces cells;
  SimTK::MobilizedBody::Planar planar;  ///< the carriage
  SimTK::MobilizedBody vessel;
  SimTK::State state;
  int carriage = 0, speeds = 0;
};

SimTK::Vector_<SimTK::SpatialVec> VesselTree::Implementation::on_vessel(const Wrench& load) const {
  SimTK::Vector_<SimTK::SpatialVec> loads(matter.getNumBodies(), SimTK::SpatialVec(SimTK::Vec3(0), SimTK::Vec3(0)));
  loads[vessel.getMobilizedBodyIndex()] = SimTK::SpatialVec(to_simbody(load.torque), to_simbody(load.force));
  return loads;
}

/// Forces along the speeds that are missing for these accelerations under these loads.
SimTK::Vector VesselTree::Implementation::missing_forces(const SimTK::Vector_<SimTK::SpatialVec>& loads,
                                                         const VecX& accelerations,
                                                         const CarriageMotion::State& acceleration) const {
  SimTK::Vector known(state.getNU(), 0.0), missing;
  if (carriage > 0)
    known(0, carriage) = SimTK::Vector(SimTK::Vec3(acceleration.yaw_rate, acceleration.v.x(), acceleration.v.y()));
  for (int i = 0; i < accelerations.size(); ++i) known[carriage + i] = accelerations[i];
  matter.calcResidualForceIgnoringConstraints(at(SimTK::Stage::Velocity), SimTK::Vector(state.getNU(), 0.0), loads,
                                              known, missing);
  return missing;
}

VesselTree::VesselTree(const geometry::MassProperties& mass) : implementation_(std::make_unique<Implementation>()) {
  Implementation& tree = *implementation_;
  tree.vessel = SimTK::MobilizedBody::Free(tree.matter.updGround(), rigid_body(mass.mass, mass.inertia));
  tree.complete(0);
}

VesselTree::VesselTree(const geometry::MassProperties& mass, const TreeJoint& joint, const std::vector<TreeCell>& cells)
    : implementation_(std::make_unique<Implementation>()) {
  Implementation& tree = *implementation_;
  tree.planar = add_carriage(tree.matter, joint);
  tree.vessel = add_carried(tree.planar, rigid_body(mass.mass, mass.inertia), joint);
  tree.cells.add(tree.forces, tree.vessel, cells);
  constexpr int k_planar_speeds = 3;
  tree.complete(k_planar_speeds);
}

VesselTree::~VesselTree() = default;
VesselTree::VesselTree(VesselTree&&) noexcept = default;
VesselTree& VesselTree::operator=(VesselTree&&) noexcept = default;

int VesselTree::size() const { return implementation_->speeds; }

void VesselTree::set_carriage(const CarriageMotion::State& state) {
  Implementation& tree = *implementation_;
  NILAS_DEMAND(tree.carriage > 0);
  tree.state.updQ()(0, tree.carriage) = SimTK::Vector(SimTK::Vec3(state.yaw, state.p.x(), state.p.y()));
  tree.state.updU()(0, tree.carriage) = SimTK::Vector(SimTK::Vec3(state.yaw_rate, state.v.x(), state.v.y()));
}

void VesselTree::set_coordinates(const VecX& q) {
  Implementation& tree = *implementation_;
  NILAS_DEMAND(q.size() == tree.state.getNQ() - tree.carriage);
  SimTK::Vector& all = tree.state.updQ();
  for (int i = 0; i < q.size(); ++i) all[tree.carriage + i] = q[i];
}

void VesselTree::set_speeds(const VecX& u) {
  Implementation& tree = *implementation_;
  NILAS_DEMAND(u.size() == tree.speeds);
  SimTK::Vector& all = tree.state.updU();
  for (int i = 0; i < u.size(); ++i) all[tree.carriage + i] = u[i];
}

Pose VesselTree::pose() const {
  return from_simbody(implementation_->vessel.getBodyTransform(implementation_->at(SimTK::Stage::Position)));
}

Vec6 VesselTree::twist() const {
  const SimTK::SpatialVec& V = implementation_->vessel.getBodyVelocity(implementation_->at(SimTK::Stage::Velocity));
  Vec6 twist;
  twist << from_simbody(V[1]), from_simbody(V[0]);
  return twist;
}

MatX VesselTree::mass_matrix() const {
  const Implementation& tree = *implementation_;
  SimTK::Matrix all;
  tree.matter.calcM(tree.at(SimTK::Stage::Position), all);
  MatX mass(tree.speeds, tree.speeds);
  for (int i = 0; i < tree.speeds; ++i)
    for (int j = 0; j < tree.speeds; ++j)
      mass(i, j) = 0.5 * (all(tree.carriage + i, tree.carriage + j) + all(tree.carriage + j, tree.carriage + i));
  return mass;
}

MatX VesselTree::jacobian() const {
  const Implementation& tree = *implementation_;
  SimTK::RowVector_<SimTK::SpatialVec> all;
  tree.matter.calcFrameJacobian(tree.at(SimTK::Stage::Position), tree.vessel, SimTK::Vec3(0), all);
  MatX jacobian(6, tree.speeds);
  for (int j = 0; j < tree.speeds; ++j) {
    const SimTK::SpatialVec& column = all[tree.carriage + j];
    jacobian.col(j) << from_simbody(column[1]), from_simbody(column[0]);
  }
  return jacobian;
}

VecX VesselTree::force(const Wrench& load, const CarriageMotion::State& acceleration) const {
  const Implementation& tree = *implementation_;
  // The force that drives the vessel is the negative of the force that is missing to keep its speeds constant.
  const SimTK::Vector missing = tree.missing_forces(tree.on_vessel(load), VecX::Zero(tree.speeds), acceleration);
  VecX force(tree.speeds);
  for (int i = 0; i < tree.speeds; ++i) force[i] = -missing[tree.carriage + i];
  return force;
}

VecX VesselTree::cell_force() const {
  const Implementation& tree = *implementation_;
  return tree.cells.along_speeds(tree.at(SimTK::Stage::Velocity)).tail(tree.speeds);
}

double VesselTree::cell_energy() const {
  const Implementation& tree = *implementation_;
  return tree.cells.energy(tree.at(SimTK::Stage::Position));
}

Wrench VesselTree::reaction(const Wrench& load, const VecX& accelerations, const CarriageMotion::State& acceleration) {
  Implementation& tree = *implementation_;
  NILAS_DEMAND(tree.carriage > 0 && accelerations.size() == tree.speeds);
  const SimTK::Vector_<SimTK::SpatialVec> loads = tree.on_vessel(load);
  SimTK::Vector drive = tree.missing_forces(loads, accelerations, acceleration);
  drive(0, tree.carriage) = SimTK::Vector(tree.carriage, 0.0);
  const VecX cells = cell_force();
  for (int i = 0; i < tree.speeds; ++i) drive[tree.carriage + i] -= cells[i];
  tree.planar.lockAt(tree.state, SimTK::Vec3(acceleration.yaw_rate, acceleration.v.x(), acceleration.v.y()),
                     SimTK::Motion::Acceleration);
  tree.applied.setAllMobilityForces(tree.state, drive);
  tree.applied.setAllBodyForces(tree.state, loads);
  SimTK::Vector_<SimTK::SpatialVec> reactions;
  const SimTK::State& state = tree.at(SimTK::Stage::Acceleration);
  tree.matter.calcMobilizerReactionForces(state, reactions);
  const SimTK::SpatialVec& at_joint = reactions[tree.vessel.getMobilizedBodyIndex()];
  const SimTK::Transform& X = tree.vessel.getBodyTransform(state);
  const Vec3 arm = from_simbody(X.R() * tree.vessel.getOutboardFrame(state).p());
  const Vec3 force = from_simbody(at_joint[1]);
  return {force, from_simbody(at_joint[0]) + arm.cross(force)};
}

}  // namespace nilas::vessel
