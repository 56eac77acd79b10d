#pragma once
/// Cholesky factors of 1 + sum over contacts of J^T G J, G symmetric and positive semidefinite: the matrix of a step in
/// the coordinates of the bodies.
///
///   P A P^T = C C^T   by 6 x 6 blocks, in the order of a NodePlan
///
/// Eigenvalues of A are at least 1, and so are the pivots: smaller ones are rounding and count as 1. Cost: 432
/// operations per product of two blocks, 15 million for 966 floes in a jam. newton's LU between contacts needs 8 to 16
/// times as many.
#include "contact/solvers/bodies/body_island.h"
#include "contact/solvers/bodies/node_tasks.h"

namespace nilas::solvers {

/// Symmetric 3 x 3 matrices, one per contact, stored by component: (00, 10, 20, 11, 21, 22).
struct ContactMatrices {
  std::array<std::vector<double>, 6> entry;

  explicit ContactMatrices(std::size_t num_contacts) {
    for (auto& one : entry) one.resize(num_contacts);
  }
};

class NodeCholesky {
 public:
  /// Both must outlive this.
  NodeCholesky(const BodyIsland& island, const NodePlan& plan);

  /// False when the matrix is not finite.
  bool factor(const ContactMatrices& g);
  /// x <- A^-1 x, in the order of the nodes.
  void solve(NodeVector& x);

 private:
  const BodyIsland& island_;
  const NodePlan& plan_;
  std::vector<NodeBlock> diagonal_, below_;
  NodeVector ordered_;
  TaskProgress progress_;
};

}  // namespace nilas::solvers
