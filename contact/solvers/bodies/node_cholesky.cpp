#include "contact/solvers/bodies/node_cholesky.h"

#include <atomic>
#include <cmath>

#include "contact/solvers/bodies/node_products.h"
#include "contact/solvers/linear/wide_clones.h"

namespace nilas::solvers {

namespace {

/// The entries of symmetric matrices, one per contact.
struct SymmetricEntries {
  const double *e00, *e10, *e20, *e11, *e21, *e22;
  SymmetricEntries(const ContactMatrices& g)
      : e00(g.entry[0].data()),
        e10(g.entry[1].data()),
        e20(g.entry[2].data()),
        e11(g.entry[3].data()),
        e21(g.entry[4].data()),
        e22(g.entry[5].data()) {}
};

/// Turns the lower triangle of a block into its Cholesky factor, with the inverses of its diagonal on the diagonal. The
/// matrix is 1 and a positive semidefinite one, so pivots are 1 at least, and smaller ones are rounding. Whole columns
/// are faster than their lower parts; what this leaves above the diagonal is not used.
template <class Numbers>
NILAS_PART_OF_CLONES bool root_of_diagonal(NodeBlock& block) {
  auto& x = block.column;
  for (int k = 0; k < k_node_size; ++k) {
    if (!std::isfinite(x[k][k])) return false;
    const double inverse = 1 / std::sqrt(x[k][k] < 1 ? 1 : x[k][k]);
    scale_column<Numbers>(inverse, x[k]);
    for (int j = k + 1; j < k_node_size; ++j) subtract_column<Numbers>(x[k][j], x[k], x[j]);
    x[k][k] = inverse;
  }
  return true;
}

/// b <- b C^-T
template <class Numbers>
NILAS_PART_OF_CLONES void divide_by_root(NodeBlock& b, const NodeBlock& c) {
  for (int k = 0; k < k_node_size; ++k) {
    scale_column<Numbers>(c.column[k][k], b.column[k]);
    for (int j = k + 1; j < k_node_size; ++j) subtract_column<Numbers>(c.column[k][j], b.column[k], b.column[j]);
  }
}

/// Sets a column to its part of 1 + sum J^T G J.
template <class Numbers>
NILAS_PART_OF_CLONES void assemble_column(const NodeRows* all_rows, const NodePlan& plan, const SymmetricEntries& g,
                                          int j, NodeBlock* diagonal, NodeBlock* below) {
  NodeBlock own;
  for (int k = 0; k < k_node_size; ++k) own.column[k][k] = 1;
  for (std::size_t s = plan.start[j]; s < plan.start[j + 1]; ++s) below[s] = {};
  const ColumnSide *side = plan.sides.data() + plan.side_start[j], *end = plan.sides.data() + plan.side_start[j + 1];
  const ColumnPair *pairs = plan.pairs.data(), *pair = pairs;
  if (plan.side_start[j] > 0) pair += side[-1].last_pair;
  for (; side < end; ++side) {
    const int c = side->contact;
    const double full[3][3] = {
        {g.e00[c], g.e10[c], g.e20[c]}, {g.e10[c], g.e11[c], g.e21[c]}, {g.e20[c], g.e21[c], g.e22[c]}};
    const NodeRows& rows = all_rows[side->side];
    NodeRows scaled;
    multiply<Numbers>(full, rows, scaled);
    add_outer<Numbers>(scaled, rows, own);
    for (const ColumnPair* const last = pairs + side->last_pair; pair < last; ++pair) {
      // Block (later place, earlier place): the later node's coordinates along the columns.
      const NodeRows& later = all_rows[pair->side];
      if (!pair->comes_first) {
        add_outer<Numbers>(later, scaled, below[pair->block]);
        continue;
      }
      NodeRows other;
      multiply<Numbers>(full, later, other);
      add_outer<Numbers>(other, rows, below[pair->block]);
    }
  }
  diagonal[j] = own;
}

/// Fills the columns of a task with the factor. Returns whether all are finite.
template <class Numbers>
NILAS_PART_OF_CLONES bool eliminate_in(const NodeRows* all_rows, const NodePlan& plan, const SymmetricEntries& g,
                                       const TaskRun& run, NodeBlock* diagonal, NodeBlock* below) {
  bool is_finite = true;
  const EarlierBlock* const all_earlier = plan.earlier.data();
  const int* const all_targets = plan.target.data();
  const std::size_t *const starts = plan.start.data(), *const earlier_starts = plan.earlier_start.data();
  for (const int j : run.columns) {
    assemble_column<Numbers>(all_rows, plan, g, j, diagonal, below);
    for (std::size_t e = earlier_starts[j]; e < earlier_starts[j + 1]; ++e) {
      const EarlierBlock earlier = all_earlier[e];
      run.wait_for(earlier.column);
      const NodeBlock& by = below[earlier.place];
      subtract_product<Numbers>(by, by, diagonal[j]);
      const int* target = all_targets + earlier.target;
      for (std::size_t t = earlier.place + 1, last = starts[earlier.column + 1]; t < last; ++t)
        subtract_product<Numbers>(below[t], by, below[*target++]);
    }
    is_finite = root_of_diagonal<Numbers>(diagonal[j]) && is_finite;
    for (std::size_t s = starts[j]; s < starts[j + 1]; ++s) divide_by_root<Numbers>(below[s], diagonal[j]);
  }
  return is_finite;
}

NILAS_WIDEST bool eliminate_in_eights(const NodeRows* all_rows, const NodePlan& plan, const SymmetricEntries& g,
                                      const TaskRun& run, NodeBlock* diagonal, NodeBlock* below) {
  return eliminate_in<EightNumbers>(all_rows, plan, g, run, diagonal, below);
}
NILAS_WIDE_CLONES bool eliminate_in_fours(const NodeRows* all_rows, const NodePlan& plan, const SymmetricEntries& g,
                                          const TaskRun& run, NodeBlock* diagonal, NodeBlock* below) {
  return eliminate_in<FourNumbers>(all_rows, plan, g, run, diagonal, below);
}

/// y <- C^-1 y
NILAS_WIDE_CLONES void substitute_down(const NodePlan& plan, const TaskRun& run, const NodeBlock* diagonal,
                                       const NodeBlock* below, NodeNumbers* y) {
  for (const int j : run.columns) {
    double* const at = y[j].value;
    for (std::size_t e = plan.earlier_start[j]; e < plan.earlier_start[j + 1]; ++e) {
      const EarlierBlock& earlier = plan.earlier[e];
      run.wait_for(earlier.column);
      subtract_times<FourNumbers>(below[earlier.place], y[earlier.column].value, at);
    }
    const auto& c = diagonal[j].column;
    for (int k = 0; k < k_node_size; ++k) {
      at[k] *= c[k][k];
      for (int i = k + 1; i < k_node_size; ++i) at[i] -= c[k][i] * at[k];
    }
  }
}

/// y <- C^-T y
NILAS_WIDE_CLONES void substitute_up(const NodePlan& plan, const TaskRun& run, const NodeBlock* diagonal,
                                     const NodeBlock* below, NodeNumbers* y) {
  for (auto column = run.columns.rbegin(); column != run.columns.rend(); ++column) {
    const int j = *column;
    double* const at = y[j].value;
    double sum[k_node_size] = {};
    for (std::size_t s = plan.start[j]; s < plan.start[j + 1]; ++s)
      add_transposed_times(below[s], y[plan.rows[s]].value, sum);
    const auto& c = diagonal[j].column;
    for (int k = k_node_size - 1; k >= 0; --k) {
      double rest = at[k] - sum[k];
      for (int i = k + 1; i < k_node_size; ++i) rest -= c[k][i] * at[i];
      at[k] = rest * c[k][k];
    }
  }
}

}  // namespace

NodeCholesky::NodeCholesky(const BodyIsland& island, const NodePlan& plan)
    : island_(island),
      plan_(plan),
      diagonal_(plan.size()),
      below_(plan.num_blocks()),
      ordered_(plan.size()),
      progress_(plan.num_tasks()) {}

bool NodeCholesky::factor(const ContactMatrices& g) {
  std::atomic<bool> is_finite = true;
  const auto eliminate = has_widest_registers() ? eliminate_in_eights : eliminate_in_fours;
  run_tasks(plan_, progress_, island_.threads(), [&](const TaskRun& run) {
    if (!eliminate(&island_.rows(0), plan_, g, run, diagonal_.data(), below_.data())) is_finite = false;
  });
  return is_finite;
}

void NodeCholesky::solve(NodeVector& x) {
  for (int k = 0; k < plan_.size(); ++k) ordered_[k] = x[plan_.source[k]];
  run_tasks(plan_, progress_, island_.threads(),
            [&](const TaskRun& run) { substitute_down(plan_, run, diagonal_.data(), below_.data(), ordered_.data()); });
  run_tasks_back(plan_, island_.threads(), [&](const TaskRun& run) {
    substitute_up(plan_, run, diagonal_.data(), below_.data(), ordered_.data());
  });
  for (int k = 0; k < plan_.size(); ++k) x[plan_.source[k]] = ordered_[k];
}

}  // namespace nilas::solvers
