#pragma once
/// The vessel's share of a step. Nothing happens in a world without a vessel, or with a fixed one.
#include <vector>

#include "contact/assemble.h"
#include "contact/step_motion.h"
#include "core/sim/account/ledger.h"
#include "core/sim/step/substep.h"
#include "core/sim/world/world_state.h"

namespace nilas::sim {

/// Whether the vessel is booked from end to end of a substep: on a carriage and without parts. Others are booked from
/// impulse to impulse.
bool is_booked_whole(const WorldParts& parts);

/// State of a vessel on a carriage at the substep's start, from where its momenta are balanced.
struct VesselStart {
  Vec3 v = Vec3::Zero(), w = Vec3::Zero();  ///< [m/s, rad/s]
  Mat3 inertia = Mat3::Zero();              ///< frame G [kg m^2]
};

/// Moves the vessel to the pose where the impulses of a substep of length h [s] act.
void move_vessel_before_impulses(World& world, double h);
/// Undoes that motion, so that a shorter substep can begin.
void abandon_vessel_step(World& world);

/// The vessel's block of the contact problem under these loads; empty without a vessel that moves.
std::vector<contact::ArticulatedBlock> begin_vessel_step(World& world, const bodies::Wrenches& loads, double h);
/// Ends the vessel's substep under the contact impulses of `motion`, and writes the vessel's velocities to `motion`.
/// The reaction of the water that moves with the hull joins the loads of its module.
void finish_vessel_step(World& world, Loads& loads, contact::StepMotion& motion);

/// The load of the water that moves with a body, apart from its reaction to changes of the body's velocities
/// [Kirchhoff; Lamb, Hydrodynamics, 124]. added_G: about the centre of mass, in the axes of G; v: velocity of the
/// centre of mass through the water [m/s]; w: angular velocity [rad/s], both in G. It holds the Munk moment.
Wrench quadratic_water_load(const Mat6& added_G, const Vec3& v, const Vec3& w);

VesselAccount vessel_account(const World& world, const VesselStart& start);
/// Works of joints and carriage before and after the impulses.
vessel::JointAccount::Motion joint_work_before(const World& world);
vessel::JointAccount::Motion joint_work_after(const World& world);

}  // namespace nilas::sim
