#pragma once
/// One sweep of block Gauss-Seidel over an island of a problem with bodies.
#include "contact/law/local_solve.h"
#include "contact/solvers/shared/pgs_rows.h"

namespace nilas::solvers {

/// The data that the exact solve of one contact needs besides its rows.
struct NsgsContact {
  contact::ContactBlock block;
  contact::ContactStart start;
  double d = 0;  ///< trace(W_aa)/3
};

/// Returns one entry per contact, in the order of the island's contacts.
std::vector<NsgsContact> make_nsgs_contacts(const PgsRows& rows, const PgsIsland& island);

/// Visits the island's contacts in order (or backwards), those of one colour with `threads` at once. Returns the
/// largest d |dr| [m/s].
double nsgs_sweep(PgsRows& rows, const PgsIsland& island, std::vector<NsgsContact>& blocks, int facets, bool backward,
                  int threads);

/// Visits contacts [first, last) with Coulomb's law in turn, or backwards. Returns the largest (d |dr|)^2 [m^2/s^2].
double visit_coulomb_run(PgsRows& rows, const PgsIsland& island, std::vector<NsgsContact>& blocks, int first, int last,
                         bool backward);

}  // namespace nilas::solvers
