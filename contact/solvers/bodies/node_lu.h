#pragma once
/// LU factors of 1 + sum over contacts of J^T G J where G is not symmetric, as slip makes it: the matrix of a Newton
/// step in the coordinates of the bodies.
///
///   P A P^T = L U,   L unit lower, U upper, in the order of a NodePlan and without exchanges
///
/// Cost: twice that of node_cholesky.h.
#include "contact/solvers/bodies/body_island.h"
#include "contact/solvers/bodies/node_tasks.h"

namespace nilas::solvers {

class NodeLu {
 public:
  /// Both must outlive this.
  NodeLu(const BodyIsland& island, const NodePlan& plan);

  /// `g`: one matrix per contact; zero takes the contact out. False when a pivot vanishes or is not a number.
  bool factor(const std::vector<Mat3>& g);
  /// x <- A^-1 x, in the order of the nodes.
  void solve(NodeVector& x);

 private:
  const BodyIsland& island_;
  const NodePlan& plan_;
  std::vector<NodeBlock> diagonal_;
  std::vector<NodeBlock> lower_;  ///< blocks (later, earlier) of L
  std::vector<NodeBlock> upper_;  ///< blocks (earlier, later) of U, transposed
  NodeVector ordered_;
  TaskProgress progress_;
};

}  // namespace nilas::solvers
