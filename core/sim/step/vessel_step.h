#pragma once
/// The vessel's share of a step: nothing happens in a world without a vessel, or with one that is fixed.
#include <vector>

#include "contact/assemble.h"
#include "contact/step_motion.h"
#include "core/sim/account/ledger.h"
#include "core/sim/world/world_state.h"

namespace nilas {

/// A vessel without parts on a carriage is booked from end to end of a substep, others from impulse to impulse.
bool is_booked_whole(const WorldParts& parts);

/// A vessel on a carriage at the substep's start: its momenta balance from there.
struct VesselStart {
  Vec3 v = Vec3::Zero(), w = Vec3::Zero();  ///< [m/s, rad/s]
  Mat3 inertia = Mat3::Zero();              ///< in G [kg m^2]
};

/// Moves the vessel to the pose where the impulses of a substep of length h [s] act.
void move_vessel_before_impulses(World& world, double h);
/// Takes that back, so that a shorter substep may begin.
void abandon_vessel_step(World& world);

/// The vessel's block of the contact problem under these loads; empty without a vessel that moves.
std::vector<ArticulatedBlock> begin_vessel_step(World& world, const Wrenches& loads, double h);
/// Ends the vessel's substep under the contact impulses of `motion`, and notes its velocities there.
void finish_vessel_step(World& world, StepMotion& motion);

VesselAccount vessel_account(const World& world, const VesselStart& start);
/// What joints and carriage did before and after the impulses.
JointAccount::Motion joint_work_before(const World& world);
JointAccount::Motion joint_work_after(const World& world);

}  // namespace nilas
