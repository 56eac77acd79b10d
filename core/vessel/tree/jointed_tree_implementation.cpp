#include "core/vessel/tree/jointed_tree_implementation.h"

#include <array>

#include "core/base/error.h"
#include "core/vessel/tree/carried_vessel.h"

namespace nilas::vessel {

namespace {

void demand_body(double mass, const Mat3& inertia, const std::string& where) {
  if (!(mass > 0)) throw InputError(where + ": the mass must be > 0 kg");
  if (!geometry::physically_valid_inertia(inertia))
    throw InputError(where +
                     ": the inertia about the centre of mass must be symmetric, its principal moments positive and "
                     "none larger than the sum of the other two");
}

}  // namespace

SimTK::Vector_<SimTK::SpatialVec> JointedTree::Implementation::spatial(const std::vector<Wrench>& loads) const {
  NILAS_DEMAND(loads.size() == bodies.size());
  SimTK::Vector_<SimTK::SpatialVec> out(matter.getNumBodies(), SimTK::SpatialVec(SimTK::Vec3(0), SimTK::Vec3(0)));
  for (std::size_t b = 0; b < bodies.size(); ++b)
    out[bodies[b].mobilized.getMobilizedBodyIndex()] =
        SimTK::SpatialVec(to_simbody(loads[b].torque), to_simbody(loads[b].force));
  return out;
}

SimTK::Vector JointedTree::Implementation::all_accelerations(const VecX& accelerations,
                                                             const CarriageMotion::State& of_carriage) const {
  SimTK::Vector all(state.getNU(), 0.0);
  if (carried > 0)
    all(0, carried) = SimTK::Vector(SimTK::Vec3(of_carriage.yaw_rate, of_carriage.v.x(), of_carriage.v.y()));
  for (int i = 0; i < accelerations.size(); ++i) all[carried + i] = accelerations[i];
  return all;
}

/// Mobility forces that are missing for these accelerations under these loads.
SimTK::Vector JointedTree::Implementation::residual(const SimTK::Vector& accelerations,
                                                    const SimTK::Vector_<SimTK::SpatialVec>& loads) const {
  SimTK::Vector residual;
  matter.calcResidualForceIgnoringConstraints(at(SimTK::Stage::Velocity), SimTK::Vector(state.getNU(), 0.0), loads,
                                              accelerations, residual);
  return residual;
}

void JointedTree::Implementation::add_hull(const VesselModel& model, const Pose& hull_in_G) {
  const Pose hull_in_V{Quat::Identity(), model.mass.com};
  const double mass = model.fixed ? 1 : model.mass.mass;
  const Mat3 inertia = model.fixed ? Mat3(Mat3::Identity()) : model.mass.inertia;
  demand_body(mass, inertia, "vessel");
  const SimTK::Body::Rigid hull = rigid_body(mass, inertia);
  SimTK::MobilizedBody hull_mobilized;
  if (model.fixed) {
    hull_mobilized = SimTK::MobilizedBody::Weld(matter.updGround(), to_simbody(hull_in_G), hull, SimTK::Transform());
  } else if (model.carriage) {
    const TreeJoint joint = carriage_joint(model);
    carriage = add_carriage(matter, joint);
    carried = 3;  // Simbody's planar mobilizer
    hull_mobilized = add_carried(carriage, hull, joint);
    cells.add(forces, hull_mobilized, carriage_cells(*model.carriage));
  } else {
    hull_mobilized = SimTK::MobilizedBody::Free(matter.updGround(), hull);
    free_hull = true;
  }
  bodies.push_back({hull_mobilized, mass, inertia, hull_in_V, -1, {}, 0, 0});
}

void JointedTree::Implementation::add_parts(const VesselModel& model) {
  for (std::size_t k = 0; k < model.parts.size(); ++k) {
    const PartModel& part = model.parts[k];
    NILAS_DEMAND(part.to >= -1 && part.to < static_cast<int>(k));
    demand_body(part.mass, part.inertia_B, "part " + std::to_string(k + 1) + " of the vessel");
    Body& parent = bodies[part.to + 1];
    const SimTK::MobilizedBody mobilized = add_part(parent.mobilized, parent.in_V, part);
    bodies.push_back({mobilized, part.mass, part.inertia_B, part.in_V, part.to + 1, part, 0, 0});
  }
}

void JointedTree::Implementation::add_rods(const VesselModel& model) {
  for (const RodModel& rod : model.rods) {
    NILAS_DEMAND(rod.on >= -1 && rod.on < static_cast<int>(model.parts.size()));
    Body& holder = bodies[rod.on + 1];
    const Vec3 at_B = holder.in_V.q.conjugate() * (rod.at_V - holder.in_V.p);
    rods.add(matter, holder.mobilized, rod.on + 1, at_B, rod.to_G);
  }
}

/// Makes the state of the bodies and rods that were added.
void JointedTree::Implementation::begin_state() {
  state = system.realizeTopology();
  system.realizeModel(state);
  speeds = state.getNU() - carried;
  if (carried > 0) NILAS_DEMAND(static_cast<int>(carriage.getFirstUIndex(state)) == 0);
}

/// Sets the places of all bodies among the coordinates and speeds, and the springs, dampers and initial coordinates of
/// the parts.
void JointedTree::Implementation::place_parts() {
  stiffness = VecX::Zero(speeds);
  damping = VecX::Zero(speeds);
  for (auto& one : bodies) {
    const int count = one.mobilized.getNumU(state);
    if (count == 0) continue;
    one.first_q = static_cast<int>(one.mobilized.getFirstQIndex(state));
    one.first_u = static_cast<int>(one.mobilized.getFirstUIndex(state));
    if (&one == &bodies.front()) continue;
    stiffness.segment(one.first_u - carried, count).setConstant(one.part.stiffness);
    damping.segment(one.first_u - carried, count).setConstant(one.part.damping);
    if (!has_one_coordinate(one.part.joint)) continue;
    state.updQ()[one.first_q] = one.part.coordinate;
    state.updU()[one.first_u] = one.part.rate;
  }
}

void JointedTree::Implementation::place_free_hull(const VesselModel& model, const Pose& hull_in_G) {
  SimTK::Vector& q = state.updQ();
  const int at_q = bodies.front().first_q, at_u = bodies.front().first_u;
  const Quat& attitude = hull_in_G.q;
  const std::array<double, 7> start{attitude.w(),    attitude.x(),    attitude.y(),   attitude.z(),
                                    hull_in_G.p.x(), hull_in_G.p.y(), hull_in_G.p.z()};
  for (int i = 0; i < 7; ++i) q[at_q + i] = start[i];
  for (int i = 0; i < 3; ++i) {
    state.updU()[at_u + i] = model.w[i];
    state.updU()[at_u + 3 + i] = model.v[i];
  }
}

}  // namespace nilas::vessel
