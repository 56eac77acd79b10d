#pragma once
/// Splits the degrees of freedom of FCLIB's global form, which names no bodies, into the blocks of a ContactProblem.
///
/// Blocks must hold the connected parts of M's sparsity whole, and no contact may touch more than two. Tried in turn:
/// the connected parts themselves; consecutive parts gathered into bodies of up to 6, then 3 degrees of freedom (a
/// diagonal M says nothing of bodies, but files list them one after another); parts that share a contact, merged.
#include <vector>

#include "contact/fclib/fclib_matrix.h"

namespace nilas::contact {

/// One list of degrees of freedom per block, rising, blocks by their first. `jacobian`: entries of H, ndof x 3 nc.
std::vector<std::vector<int>> split_into_blocks(int ndof, const std::vector<MatrixEntry>& mass,
                                                const std::vector<MatrixEntry>& jacobian, int num_contacts);

}  // namespace nilas::contact
