#pragma once
/// Newton's systems between the contacts of a local problem. Rows of open contacts say dr' = -r' and are taken out, so
/// the matrix has only contacts that carry something. W' is that of the problem as stored, asymmetric or not. The plan
/// of the factors is kept while the contacts that are not open stay among those that it was made for.
///
/// `order_free`: sums over contacts are OrderFreeSums and steps are those of rounded_solve.h, so that the numbers given
/// do not depend on the order of contacts and, but for the sign, on a mirror.
#include "contact/problem/local_problem.h"
#include "contact/solvers/linear/block_lu.h"
#include "contact/solvers/newton/newton_system.h"

namespace nilas::solvers {

class DelassusSystem final : public NewtonSystem {
 public:
  /// `island`: every contact of it can move, or has compliance. It must outlive the system.
  explicit DelassusSystem(const contact::LocalProblem& island, bool order_free = false);

  VecX product(const VecX& r) const override;
  bool step(double weight, const VecX& r, VecX& dr) override;
  double residual(const VecX& r) const override;

 private:
  Vec3 row_product(int a, const VecX& r) const;
  Vec3 order_free_row_product(int a, const VecX& r) const;
  void choose_contacts();
  void plan();
  void fill(double weight);

  const contact::LocalProblem& island_;
  std::vector<Mat3> block_;  ///< blocks of W'

  std::vector<int> planned_;                    ///< contacts in the matrix
  std::vector<int> place_;                      ///< place of each contact in the matrix, -1: not in it
  std::vector<int> row_start_, column_, from_;  ///< pattern of the matrix; from_: place in block_ of each of its blocks
  std::vector<Mat3> matrix_;
  BlockLu factors_;
};

}  // namespace nilas::solvers
