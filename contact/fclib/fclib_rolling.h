#pragma once
/// Converts between FCLIB's rolling form and the form of ContactProblem. FCLIB has five rows (N, T1, T2, R1, R2) per
/// contact. A ContactProblem has all contacts (N, T1, T2) first, then for each with mu_r > 0 its moment (S, R1, R2)
/// divided by mu_r. S has no row in the file and stays zero.
#include <vector>

#include "contact/fclib/fclib_matrix.h"
#include "contact/problem/problem.h"

namespace nilas::contact {

constexpr const char* k_rolling_root = "fclib_global_rolling";
constexpr int k_rolling_rows = 5;

struct RollingRows {
  std::vector<double> length;  ///< mu_r per contact [m]
  std::vector<int> moment;     ///< index of each contact's moment in the ContactProblem, -1: none
  std::vector<int> contact;    ///< index of the contact itself in the ContactProblem

  /// Numbers the moments after all contacts.
  void number();
  /// Returns the rows of a ContactProblem. Throws InputError where a moment has a spinning row.
  static RollingRows of(const ContactProblem& problem);

  int num_points() const { return static_cast<int>(length.size()); }
  int num_rows() const;  ///< number of row triples in the ContactProblem

  std::vector<MatrixEntry> jacobian(const std::vector<MatrixEntry>& of_file) const;
  VecX velocities(const VecX& of_file) const;
  VecX impulses(const VecX& of_file) const;
  std::vector<MatrixEntry> jacobian_for_file(const std::vector<MatrixEntry>& ours) const;
  VecX velocities_for_file(const VecX& ours) const;
  VecX impulses_for_file(const VecX& ours) const;
};

}  // namespace nilas::contact
