#pragma once
/// Contacts that share no block, visited four at a time. The turns keep the order of contacts that share one, so a
/// sweep gives the same bits as visiting the contacts one after another.
#include <vector>

#include "contact/solvers/lanes/four_lanes.h"
#include "contact/solvers/shared/pgs_sweep.h"

namespace nilas::solvers {

/// Up to four contacts of shape six_six whose rows serve as responses; see PgsContact. Lanes from `count` on are zero.
struct alignas(32) PgsLanes {
  FourLanes rows[3][12] = {};
  FourLanes r[3] = {}, w[3] = {}, weight[3] = {}, coupling[3] = {};
  FourLanes mu = {}, force_limit = {}, compliance = {}, tangential_compliance = {};
  int first_a[k_lanes] = {}, first_b[k_lanes] = {};
  int count = 0;
  int place[k_lanes] = {};     ///< places in PgsRows::contacts
  FourLanes diagonal[3] = {};  ///< read only where changes are wanted
};

/// The turns of an island. Turn k visits lanes[k], then the contacts alone[ends[k - 1]] to alone[ends[k]], which have
/// another shape. No two contacts of one turn share a block.
class PgsTurns {
 public:
  /// Without turns where the island is small or the law has no lanes. `track`: whether sweeps tell the largest change.
  PgsTurns(const PgsRows& rows, const PgsIsland& island, bool track);

  bool exist() const { return !lanes_.empty(); }
  /// Visits all contacts once, or in the reverse order. Returns the same as PgsSweep.
  double sweep(PgsRows& rows, bool backward) { return sweep_(*this, rows, backward); }
  /// Writes the impulses of the lanes to the contacts.
  void keep_impulses(PgsRows& rows) const;

 private:
  friend struct TurnSweep;
  void add(const PgsRows& rows, int place, int turn);

  std::vector<PgsLanes> lanes_;
  std::vector<int> alone_, ends_;
  PgsVisit visit_alone_ = nullptr;
  double (*sweep_)(PgsTurns& turns, PgsRows& rows, bool backward) = nullptr;
};

}  // namespace nilas::solvers
