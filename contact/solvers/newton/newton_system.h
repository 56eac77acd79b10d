#pragma once
/// The linear systems of Newton's method on one island, in units of sqrt(J) where every contact's inverse mass is
/// about 1.
///
///   e_a = 1/sqrt(d_a),  r = e r',  u' = e u = W' r' + q',  W' = e (W + compliance) e,  q' = e q,
///   d_a = (trace(W_aa) + c_a)/3
///   F(r', u') = 0 where the law holds (law_slopes.h), with U = dF/du', R = dF/dr'
///   (U (W' + a I) + R) dr' = -F        a: proximal weight
///
/// Rows of open contacts say dr' = -r' and are taken out, so the matrix has only contacts that carry something. W' is
/// that of the problem as stored, asymmetric or not. The plan of the factors is kept while the contacts that are not
/// open stay among those that it was made for.
///
/// `order_free`: sums over contacts are OrderFreeSums and steps are those of rounded_solve.h, so that the numbers given
/// do not depend on the order of contacts and, but for the sign, on a mirror.
#include "contact/problem/local_problem.h"
#include "contact/solvers/linear/block_lu.h"
#include "contact/solvers/shared/law_slopes.h"

namespace nilas::solvers {

class NewtonSystem {
 public:
  /// `island`: every contact of it can move, or has compliance. It must outlive the system.
  explicit NewtonSystem(const contact::LocalProblem& island, bool order_free = false);

  VecX scaled(const VecX& r) const;           ///< r' of r
  VecX impulses(const VecX& scaled_r) const;  ///< r of r'
  VecX product(const VecX& r) const;          ///< W' r'
  VecX velocities(const VecX& r) const { return product(r) + q_; }

  /// Sets the place where the map is linearised; `u`: velocities, a proximal term included. Returns |F|.
  double linearise(const VecX& r, const VecX& u);
  /// |F| at another place.
  double map_size(const VecX& r, const VecX& u) const;
  /// Largest residual of any contact [m/s]; `r`: scaled.
  double law_map(const VecX& r) const;
  /// Newton's step from the last place linearised. False when the matrix is singular.
  bool step(double weight, const VecX& r, VecX& dr);

 private:
  LawSlopes slopes(int a, const VecX& r, const VecX& u) const;
  Vec3 row_product(int a, const VecX& r) const;
  Vec3 order_free_row_product(int a, const VecX& r) const;
  double length(const std::vector<double>& squares) const;
  void choose_contacts();
  void plan();
  void fill(double weight);

  const contact::LocalProblem& island_;
  bool order_free_;
  std::vector<double> scale_;  ///< e_a
  std::vector<Mat3> block_;    ///< blocks of W'
  VecX q_;
  std::vector<double> cap_;
  std::vector<LawSlopes> slopes_;

  std::vector<int> planned_;                    ///< contacts in the matrix
  std::vector<int> place_;                      ///< place of each contact in the matrix, -1: not in it
  std::vector<int> row_start_, column_, from_;  ///< pattern of the matrix; from_: place in block_ of each of its blocks
  std::vector<Mat3> matrix_;
  BlockLu factors_;
};

}  // namespace nilas::solvers
