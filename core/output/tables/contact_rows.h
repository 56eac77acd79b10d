#pragma once
/// The rows of contacts.h5 for a step.
#include <cstdint>
#include <vector>

#include "core/bodies/bodies.h"
#include "core/sim/account/step_record.h"

namespace nilas::output {

/// State of a contact. open: carries nothing (it was found because it could have closed within the step). crush:
/// carries the crushing strength of the ice.
enum class ContactStatus { open, stick, slip, crush };

/// A contact of a step. Impulse and couple act on `body`: the hull or a part of the vessel if one is involved, else a
/// structure, else the body with the higher id.
struct ContactRow {
  std::int64_t body = 0, other = 0;  ///< ids
  Vec3 p_G = Vec3::Zero();           ///< midpoint between the two surfaces where the contact was found [m]
  Vec3 p_V = Vec3::Zero();           ///< the same in frame V of the vessel at that instant; zero without a vessel [m]
  Vec3 n = Vec3::UnitX();            ///< unit normal into `body`, frame G
  double gap = 0;                    ///< gap when the contact was found; < 0: penetration [m]
  Vec3 impulse = Vec3::Zero();       ///< impulse over the step, frame G [N s]
  Vec3 couple = Vec3::Zero();        ///< couple of rolling and spinning friction over the step, frame G [N m s]
  ContactStatus status = ContactStatus::open;
  int part = 0, other_part = 0;  ///< convex pieces, counted from 1
  std::uint64_t key = 0;         ///< constant while the same features touch
};

/// Status of contact c from its impulse and velocity, scaled with the masses of its two bodies. It is open where it
/// separates faster than its normal impulse can move them. It slips where it slides faster than its remaining friction
/// can move them.
ContactStatus contact_status(const contact::SolvedProblem& solved, std::size_t c);

/// The bodies whose contacts are stored by default, and whose side a row then takes.
struct LoadedBodies {
  int vessel = -1;                       ///< index of its hull, -1: none
  int num_parts = 0;                     ///< number of the vessel's parts, which follow the hull
  Vec3 com_V = Vec3::Zero();             ///< the vessel's centre of mass in V [m]
  std::vector<std::int64_t> structures;  ///< ids of the bodies that the scene holds fixed, without planes; ascending
  bool is_of_vessel(int body) const { return vessel >= 0 && body >= vessel && body <= vessel + num_parts; }
};
/// The loaded bodies of a run; without structures where `info` names none.
LoadedBodies loaded_bodies(const bodies::Bodies& bodies, const sim::RunInfo& info);

/// Rows of the contacts of the vessel and of structures, or of all bodies.
std::vector<ContactRow> contact_rows(const contact::SolvedProblem& solved, const LoadedBodies& loaded,
                                     bool of_all_bodies);

}  // namespace nilas::output
