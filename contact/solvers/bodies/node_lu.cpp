#include "contact/solvers/bodies/node_lu.h"

#include <atomic>
#include <cmath>

#include "contact/solvers/bodies/node_products.h"
#include "contact/solvers/linear/wide_clones.h"

namespace nilas::solvers {

namespace {

/// Turns a block into its factors, with the inverses of the pivots on the diagonal.
inline bool factors_of_diagonal(NodeBlock& block) {
  auto& x = block.column;
  for (int k = 0; k < k_node_size; ++k) {
    const double inverse = 1 / x[k][k];
    if (!std::isfinite(inverse) || inverse == 0) return false;
    x[k][k] = inverse;
    for (int i = k + 1; i < k_node_size; ++i) x[k][i] *= inverse;
    for (int j = k + 1; j < k_node_size; ++j)
      for (int i = k + 1; i < k_node_size; ++i) x[j][i] -= x[k][i] * x[j][k];
  }
  return true;
}

/// b <- b U^-1 with the upper factor of a diagonal block
template <class Numbers>
NILAS_PART_OF_CLONES void divide_by_upper(NodeBlock& b, const NodeBlock& factors) {
  for (int k = 0; k < k_node_size; ++k) {
    for (int j = 0; j < k; ++j) subtract_column<Numbers>(factors.column[k][j], b.column[j], b.column[k]);
    scale_column<Numbers>(factors.column[k][k], b.column[k]);
  }
}

/// b <- b L^-T with the unit lower factor of a diagonal block
template <class Numbers>
NILAS_PART_OF_CLONES void divide_by_lower(NodeBlock& b, const NodeBlock& factors) {
  for (int k = 0; k < k_node_size; ++k)
    for (int j = 0; j < k; ++j) subtract_column<Numbers>(factors.column[j][k], b.column[j], b.column[k]);
}

/// G of a contact as rows. False where it is zero.
inline bool rows_of(const Mat3& g, double (&full)[3][3]) {
  const double* const of = g.data();
  bool is_in = false;
  for (int i = 0; i < 3; ++i)
    for (int k = 0; k < 3; ++k) {
      full[i][k] = of[3 * k + i];
      is_in = is_in || full[i][k] != 0;
    }
  return is_in;
}

/// Sets a column of the lower and a row of the upper triangle to their parts of 1 + sum J^T G J.
template <class Numbers>
NILAS_PART_OF_CLONES void assemble_both(const NodeRows* all_rows, const NodePlan& plan, const Mat3* g, int j,
                                        NodeBlock* diagonal, NodeBlock* lower, NodeBlock* upper) {
  NodeBlock own;
  for (int k = 0; k < k_node_size; ++k) own.column[k][k] = 1;
  for (std::size_t s = plan.start[j]; s < plan.start[j + 1]; ++s) lower[s] = upper[s] = {};
  const ColumnSide *side = plan.sides.data() + plan.side_start[j], *end = plan.sides.data() + plan.side_start[j + 1];
  const ColumnPair *pairs = plan.pairs.data(), *pair = pairs;
  if (plan.side_start[j] > 0) pair += side[-1].last_pair;
  for (; side < end; ++side) {
    const ColumnPair* const last = pairs + side->last_pair;
    double full[3][3];
    if (!rows_of(g[side->contact], full)) {
      pair = last;
      continue;
    }
    const NodeRows& rows = all_rows[side->side];
    NodeRows scaled;
    multiply<Numbers>(full, rows, scaled);
    add_outer<Numbers>(rows, scaled, own);
    for (; pair < last; ++pair) {
      const NodeRows& later = all_rows[pair->side];
      NodeRows other;
      multiply<Numbers>(full, later, other);
      add_outer<Numbers>(later, scaled, lower[pair->block]);
      add_outer<Numbers>(other, rows, upper[pair->block]);
    }
  }
  diagonal[j] = own;
}

/// Fills the columns of a task with the factors. Returns whether no pivot vanished.
template <class Numbers>
NILAS_PART_OF_CLONES bool eliminate_both(const NodeRows* all_rows, const NodePlan& plan, const Mat3* g,
                                         const TaskRun& run, NodeBlock* diagonal, NodeBlock* lower, NodeBlock* upper) {
  bool has_factors = true;
  for (const int j : run.columns) {
    assemble_both<Numbers>(all_rows, plan, g, j, diagonal, lower, upper);
    for (std::size_t e = plan.earlier_start[j]; e < plan.earlier_start[j + 1]; ++e) {
      const EarlierBlock& earlier = plan.earlier[e];
      run.wait_for(earlier.column);
      const NodeBlock &by_upper = upper[earlier.place], &by_lower = lower[earlier.place];
      subtract_product<Numbers>(by_lower, by_upper, diagonal[j]);
      const int* target = plan.target.data() + earlier.target;
      for (std::size_t t = earlier.place + 1; t < plan.start[earlier.column + 1]; ++t, ++target) {
        subtract_product<Numbers>(lower[t], by_upper, lower[*target]);
        subtract_product<Numbers>(upper[t], by_lower, upper[*target]);
      }
    }
    has_factors = factors_of_diagonal(diagonal[j]) && has_factors;
    for (std::size_t s = plan.start[j]; s < plan.start[j + 1]; ++s) {
      divide_by_upper<Numbers>(lower[s], diagonal[j]);
      divide_by_lower<Numbers>(upper[s], diagonal[j]);
    }
  }
  return has_factors;
}

NILAS_WIDEST bool eliminate_both_in_eights(const NodeRows* all_rows, const NodePlan& plan, const Mat3* g,
                                           const TaskRun& run, NodeBlock* diagonal, NodeBlock* lower,
                                           NodeBlock* upper) {
  return eliminate_both<EightNumbers>(all_rows, plan, g, run, diagonal, lower, upper);
}
NILAS_WIDE_CLONES bool eliminate_both_in_fours(const NodeRows* all_rows, const NodePlan& plan, const Mat3* g,
                                               const TaskRun& run, NodeBlock* diagonal, NodeBlock* lower,
                                               NodeBlock* upper) {
  return eliminate_both<FourNumbers>(all_rows, plan, g, run, diagonal, lower, upper);
}

/// y <- L^-1 y
NILAS_WIDE_CLONES void substitute_lower(const NodePlan& plan, const TaskRun& run, const NodeBlock* diagonal,
                                        const NodeBlock* lower, NodeNumbers* y) {
  for (const int j : run.columns) {
    double* const at = y[j].value;
    for (std::size_t e = plan.earlier_start[j]; e < plan.earlier_start[j + 1]; ++e) {
      const EarlierBlock& earlier = plan.earlier[e];
      run.wait_for(earlier.column);
      subtract_times<FourNumbers>(lower[earlier.place], y[earlier.column].value, at);
    }
    const auto& x = diagonal[j].column;
    for (int k = 0; k < k_node_size; ++k)
      for (int i = k + 1; i < k_node_size; ++i) at[i] -= x[k][i] * at[k];
  }
}

/// y <- U^-1 y
NILAS_WIDE_CLONES void substitute_upper(const NodePlan& plan, const TaskRun& run, const NodeBlock* diagonal,
                                        const NodeBlock* upper, NodeNumbers* y) {
  for (auto column = run.columns.rbegin(); column != run.columns.rend(); ++column) {
    const int j = *column;
    double* const at = y[j].value;
    double sum[k_node_size] = {};
    for (std::size_t s = plan.start[j]; s < plan.start[j + 1]; ++s)
      add_transposed_times(upper[s], y[plan.rows[s]].value, sum);
    const auto& x = diagonal[j].column;
    for (int k = k_node_size - 1; k >= 0; --k) {
      double rest = at[k] - sum[k];
      for (int i = k + 1; i < k_node_size; ++i) rest -= x[i][k] * at[i];
      at[k] = rest * x[k][k];
    }
  }
}

}  // namespace

NodeLu::NodeLu(const BodyIsland& island, const NodePlan& plan)
    : island_(island),
      plan_(plan),
      diagonal_(plan.size()),
      lower_(plan.num_blocks()),
      upper_(plan.num_blocks()),
      ordered_(plan.size()),
      progress_(plan.num_tasks()) {}

bool NodeLu::factor(const std::vector<Mat3>& g) {
  std::atomic<bool> has_factors = true;
  const auto eliminate = has_widest_registers() ? eliminate_both_in_eights : eliminate_both_in_fours;
  run_tasks(plan_, progress_, island_.threads(), [&](const TaskRun& run) {
    if (!eliminate(&island_.rows(0), plan_, g.data(), run, diagonal_.data(), lower_.data(), upper_.data()))
      has_factors = false;
  });
  return has_factors;
}

void NodeLu::solve(NodeVector& x) {
  for (int k = 0; k < plan_.size(); ++k) ordered_[k] = x[plan_.source[k]];
  run_tasks(plan_, progress_, island_.threads(), [&](const TaskRun& run) {
    substitute_lower(plan_, run, diagonal_.data(), lower_.data(), ordered_.data());
  });
  run_tasks_back(plan_, island_.threads(), [&](const TaskRun& run) {
    substitute_upper(plan_, run, diagonal_.data(), upper_.data(), ordered_.data());
  });
  for (int k = 0; k < plan_.size(); ++k) x[plan_.source[k]] = ordered_[k];
}

}  // namespace nilas::solvers
