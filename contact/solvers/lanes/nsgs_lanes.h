#pragma once
/// Contacts with Coulomb's law that share no block, solved four at a time. Within a colour the order of contacts that
/// share a block is kept, and each lane does the arithmetic of a single visit, so a sweep gives the same bits as one
/// that visits the contacts one after another.
#include <cstddef>
#include <vector>

#include "contact/solvers/lanes/four_lanes.h"
#include "contact/solvers/shared/nsgs_sweep.h"

namespace nilas::solvers {

/// Up to four contacts; the names are those of PgsContact, ContactBlock and ContactStart. As A is symmetric, the third
/// number of tt and schur is the last of ContactBlock. Lanes from `count` on are
/// zero, so that they stay at rest, and read the velocities of the first.
struct alignas(32) NsgsLanes {
  FourLanes rows[3][12] = {};
  FourLanes r[3] = {}, before[3] = {}, w[3] = {};
  FourLanes compliance = {}, tangential_compliance = {};
  FourLanes nn = {}, inverse_nn = {}, nt[2] = {}, tt[3] = {}, schur[3] = {}, stick[3] = {};
  FourLanes x_min = {}, mu = {}, force_limit = {};
  FourLanes slip = {}, d = {};
  int first_a[k_lanes] = {}, first_b[k_lanes] = {};
  int count = 0;
  int place[k_lanes] = {};  ///< places in PgsRows::contacts
};

/// The contacts of a coloured island in lanes. Each colour is cut into pieces of a few runs, which threads share. Runs
/// whose contacts have another shape are visited one by one.
class NsgsTurns {
 public:
  /// Without lanes where the island has no colours or the law is not Coulomb's.
  NsgsTurns(const PgsRows& rows, const PgsIsland& island, const std::vector<NsgsContact>& blocks);

  bool exist() const { return !lanes_.empty(); }
  /// The same as nsgs_sweep, with the impulses of the lanes kept here.
  double sweep(PgsRows& rows, const PgsIsland& island, std::vector<NsgsContact>& blocks, bool backward, int threads);
  /// Writes the impulses of the lanes to the contacts.
  void keep_impulses(PgsRows& rows) const;
  /// The next sweep moves each impulse by beta times its change since the last sweep began, before it visits it. The
  /// first sweep must have 0.
  void set_momentum(double beta) { beta_ = beta; }
  /// Places of the island's contacts that are not in lanes.
  std::vector<int> alone(const PgsIsland& island) const;

 private:
  /// Lanes [lanes of the piece before, lanes), then alone[runs of the piece before] to alone[runs].
  struct Piece {
    std::size_t lanes = 0, runs = 0;
  };
  struct Run {
    int first = 0, last = 0;
  };
  void add_piece(const PgsRows& rows, const PgsIsland& island, const std::vector<NsgsContact>& blocks,
                 const std::vector<Run>& runs);
  double visit_colour(PgsRows& rows, const PgsIsland& island, std::vector<NsgsContact>& blocks, std::size_t colour,
                      bool backward, int threads);
  double visit_piece(PgsRows& rows, const PgsIsland& island, std::vector<NsgsContact>& blocks, std::size_t piece,
                     bool backward);

  std::vector<NsgsLanes> lanes_;
  std::vector<Run> alone_;
  std::vector<Piece> pieces_ = {{}};  ///< the first is empty
  double beta_ = 0;
  std::vector<std::size_t> colours_{};  ///< last piece of each colour, and before them 0
};

}  // namespace nilas::solvers
