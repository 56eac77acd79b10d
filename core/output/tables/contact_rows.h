#pragma once
/// The contacts of a step as contacts.h5 holds them.
#include <cstdint>
#include <vector>

#include "core/bodies/bodies.h"
#include "core/sim/account/step_record.h"

namespace nilas {

/// What a contact does: open carries nothing (found because it could have closed within the step), crush presses as
/// hard as the ice bears.
enum class ContactStatus { open, stick, slip, crush };

/// Impulse and couple act on `body`: the hull or a part of the vessel where one takes part, else a structure, else the
/// one with the higher id.
struct ContactRow {
  std::int64_t body = 0, other = 0;  ///< ids
  Vec3 p_G = Vec3::Zero();           ///< midway between the two surfaces, where the contact was found [m]
  Vec3 p_V = Vec3::Zero();           ///< the same in V of the vessel there; zero without a vessel [m]
  Vec3 n = Vec3::UnitX();            ///< unit, into `body`, in G
  double gap = 0;                    ///< when the contact was found, < 0: penetration [m]
  Vec3 impulse = Vec3::Zero();       ///< over the step, in G [N s]
  Vec3 couple = Vec3::Zero();        ///< of rolling and spinning friction over the step, in G [N m s]
  ContactStatus status = ContactStatus::open;
  int part = 0, other_part = 0;  ///< convex parts, from 1
  std::uint64_t key = 0;         ///< stays while the same features touch
};

/// Status of contact c from its impulse and velocity, each weighed by the masses of its two bodies: open where it
/// leaves faster than its normal impulse can move them, slip where it slides faster than what its friction has left
/// can.
ContactStatus contact_status(const SolvedProblem& solved, std::size_t c);

/// The bodies whose contacts are stored by default, and whose side a row then takes.
struct LoadedBodies {
  int vessel = -1;                       ///< index of its hull, -1: none
  int num_parts = 0;                     ///< of the vessel, which follow the hull
  Vec3 com_V = Vec3::Zero();             ///< the vessel's centre of mass in V [m]
  std::vector<std::int64_t> structures;  ///< ids of the bodies that the scene holds fixed, but planes; ascending
  bool is_of_vessel(int body) const { return vessel >= 0 && body >= vessel && body <= vessel + num_parts; }
};
/// Those of a run; without structures where `info` names none.
LoadedBodies loaded_bodies(const Bodies& bodies, const RunInfo& info);

/// Rows of the contacts of the vessel and of structures, or of all bodies.
std::vector<ContactRow> contact_rows(const SolvedProblem& solved, const LoadedBodies& loaded, bool of_all_bodies);

}  // namespace nilas
