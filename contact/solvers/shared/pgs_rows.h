#pragma once
/// The rows that the sweeps of projected Gauss-Seidel read and write, contiguous and in the order of the islands.
#include <vector>

#include "contact/law/law_map.h"
#include "contact/problem/prepared_problem.h"
#include "contact/problem/problem.h"

namespace nilas::solvers {

/// A row whose inverse mass is below this share of the contact's inverse mass, its trace or its scale, is held by what
/// cannot move; rounding alone gives the square of 1e-16.
constexpr double k_immovable_share = 1e-20;

/// Block sizes for which a sweep has unrolled code.
enum class PgsShape { six_six, six_none, none_six, general };

/// One contact. Row i = N, T1, T2 of its two blocks, A's numbers before B's, stands at rows + i * stride(), and what an
/// impulse along it adds to the velocities at responses + i * stride(). A block with M = L L^T has the velocities
/// z = L^T v, and then row and response are the same L^-1 J^T and stand there once. A block whose stored mass is
/// asymmetric keeps v, with row J and response M^-1 J^T.
struct PgsContact {
  double r[3] = {0, 0, 0};
  double w[3] = {0, 0, 0};
  double weight[3] = {0, 0, 0};    ///< impulse per velocity of each row's step: 1/(W_ii + c_i)
  double diagonal[3] = {0, 0, 0};  ///< W_ii
  double coupling[3] = {0, 0, 0};  ///< W_T1N, W_T2N, W_T2T1
  double mu = 0;
  double force_limit = 0;
  double compliance = 0, tangential_compliance = 0;
  Eigen::Index rows = 0, responses = 0;  ///< indices into PgsRows::coefficients
  int first_a = 0, first_b = 0;          ///< indices into PgsRows::velocities
  int size_a = 0, size_b = 0;
  PgsShape shape = PgsShape::general;
  bool unanswerable = false;  ///< its normal velocity cannot be changed and no force limit says what to do
  int moment = -1;            ///< place of its moment; -1: none
  int bound_by = -1;          ///< place of the contact whose normal impulse bounds this moment; -1 for a contact

  int stride() const { return size_a + size_b; }
};

/// Impulse per velocity of the step of rows N, T1, T2 of a contact.
struct RowWeights {
  double weight[3] = {0, 0, 0};
  bool unanswerable = false;  ///< same meaning as in PgsContact; the normal's weight is then 0
};
/// `w`: W_cc, its diagonal is read. A row that cannot move gets a weight that drives its impulse to its bound at once.
RowWeights row_weights(const Mat3& w, Law law, double compliance, double tangential_compliance, double force_limit);

/// How the contacts of a large island stand in the rows: in the problem's order, or grouped into colours of contacts
/// that share no moving block (solvers/shared/colouring.h).
enum class RowOrder { given, coloured };

struct PgsIsland {
  int first = 0, last = 0;  ///< contacts [first, last)
  std::vector<int> blocks;  ///< blocks that the contacts touch
  /// The order of a coloured island: contacts [runs[k], runs[k + 1]) join the same two blocks. Runs [colours[i],
  /// colours[i + 1]) may be visited at once. Contacts from runs.back() on are visited in turn. Both lists are empty
  /// where all contacts are visited in turn.
  std::vector<int> runs, colours;
};

struct PgsRows {
  Law law = Law::pyramid;
  std::vector<PgsContact> contacts;
  std::vector<int> source;                    ///< index in the problem of each contact
  std::vector<contact::ContactScale> scales;  ///< scales of the law's residual
  VecX coefficients;
  VecX velocities;                  ///< z or v with the impulses so far; each block begins at an even place
  std::vector<int> first_velocity;  ///< first velocity of each block
  std::vector<PgsIsland> islands;
  bool finite = true;  ///< false: some input is not
};

/// Writes the velocities that the sweeps keep of block k from its momentum M v.
void set_block_velocities(const contact::MassInverse& masses, int k, const double* momentum, PgsRows& rows);

/// Sets all up for the impulses `guess` (3 nc, or empty for none), made admissible.
PgsRows make_pgs_rows(const contact::PreparedProblem& prepared, const VecX& guess, RowOrder order, int threads);

}  // namespace nilas::solvers
