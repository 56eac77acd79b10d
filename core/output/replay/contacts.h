#pragma once
/// The contacts of a replay frame and the islands that they make.
#include <cstdint>
#include <vector>

#include "core/bodies/bodies.h"
#include "core/output/tables/contact_rows.h"

namespace nilas::output::replay {

/// A contact by the places of its bodies. `second` equals `first` where the second body has broken since. Those that
/// are not exact are sums, one a pair of bodies.
struct FrameContact {
  int first = 0, second = 0;
  ContactStatus status = ContactStatus::open;
  bool exact = false;                          ///< of the vessel or of a fixed body: the force is stored as it is
  bool stored = false;                         ///< contacts.h5 has it too
  Vec3 p_G = Vec3::Zero(), n = Vec3::UnitX();  ///< [m]; normal into `first`
  Vec3 force = Vec3::Zero();                   ///< on `first` [N]
};

/// An island: bodies that move and hang together by contacts.
struct FrameIsland {
  int contacts = 0, iterations = 0;
  double residual = 0;  ///< largest natural-map residual of the chosen law [m/s]
};

struct FrameContacts {
  std::vector<FrameContact> contacts;
  std::vector<FrameIsland> islands;
  std::vector<int> island_of;  ///< per body, from 1; 0: none
};

/// Which contacts a replay shows exactly: those of the vessel and of structures, or all as contacts.h5 does. Others are
/// summed over each pair of bodies.
struct ContactChoice {
  LoadedBodies loaded;
  bool in_table = false;       ///< the run writes contacts.h5
  bool of_all_bodies = false;  ///< contacts.h5 has those of all bodies
};

/// `substeps`: the solved problems of a step of length `h` [s]; forces are means over it.
FrameContacts frame_contacts(const std::vector<contact::SolvedProblem>& substeps, const bodies::Bodies& bodies,
                             const ContactChoice& choice, double h);

}  // namespace nilas::output::replay
