#include "contact/solvers/bodies/node_lu.h"

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
inline void divide_by_upper(NodeBlock& b, const NodeBlock& factors) {
  for (int k = 0; k < k_node_size; ++k) {
    for (int j = 0; j < k; ++j) subtract_column(factors.column[k][j], b.column[j], b.column[k]);
    scale_column(factors.column[k][k], b.column[k]);
  }
}

/// b <- b L^-T with the unit lower factor of a diagonal block
inline void divide_by_lower(NodeBlock& b, const NodeBlock& factors) {
  for (int k = 0; k < k_node_size; ++k)
    for (int j = 0; j < k; ++j) subtract_column(factors.column[j][k], b.column[j], b.column[k]);
}

NILAS_WIDE_CLONES bool eliminate_both(const NodePlan& plan, NodeBlock* diagonal, NodeBlock* lower, NodeBlock* upper) {
  for (int j = 0; j < plan.size(); ++j) {
    if (!factors_of_diagonal(diagonal[j])) return false;
    const std::size_t first = plan.start[j], last = plan.start[j + 1];
    for (std::size_t s = first; s < last; ++s) {
      divide_by_upper(lower[s], diagonal[j]);
      divide_by_lower(upper[s], diagonal[j]);
    }
    const int* target = plan.target.data() + plan.target_start[j];
    for (std::size_t s = first; s < last; ++s) {
      subtract_product(lower[s], upper[s], diagonal[plan.rows[s]]);
      for (std::size_t t = s + 1; t < last; ++t, ++target) {
        subtract_product(lower[t], upper[s], lower[*target]);
        subtract_product(upper[t], lower[s], upper[*target]);
      }
    }
  }
  return true;
}

NILAS_WIDE_CLONES void substitute_both(const NodePlan& plan, const NodeBlock* diagonal, const NodeBlock* lower,
                                       const NodeBlock* upper, NodeNumbers* y) {
  for (int j = 0; j < plan.size(); ++j) {
    double* const at = y[j].value;
    const auto& x = diagonal[j].column;
    for (int k = 0; k < k_node_size; ++k)
      for (int i = k + 1; i < k_node_size; ++i) at[i] -= x[k][i] * at[k];
    for (std::size_t s = plan.start[j]; s < plan.start[j + 1]; ++s) subtract_times(lower[s], at, y[plan.rows[s]].value);
  }
  for (int j = plan.size() - 1; j >= 0; --j) {
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

NILAS_WIDE_CLONES void add_contacts_to_both(const BodyIsland& island, const NodePlan& plan, const Mat3* g,
                                            NodeBlock* diagonal, NodeBlock* lower, NodeBlock* upper) {
  for (int c = 0; c < island.num_contacts(); ++c) {
    const double* const of = g[c].data();
    double full[3][3];
    bool is_out = true;
    for (int i = 0; i < 3; ++i)
      for (int k = 0; k < 3; ++k) {
        full[i][k] = of[3 * k + i];
        is_out = is_out && full[i][k] == 0;
      }
    if (is_out) continue;
    const auto sides = island.sides(c);
    const int* pair = plan.pair.data() + plan.pair_start[c];
    for (std::size_t s = 0; s < sides.size(); ++s) {
      NodeRows scaled;
      multiply(full, sides[s].rows, scaled);
      const int place = plan.place[sides[s].node];
      add_outer(sides[s].rows, scaled, diagonal[place]);
      for (std::size_t t = s + 1; t < sides.size(); ++t, ++pair) {
        NodeRows other;
        multiply(full, sides[t].rows, other);
        const bool is_later = place > plan.place[sides[t].node];
        const NodeRows &late = is_later ? sides[s].rows : sides[t].rows,
                       &early = is_later ? sides[t].rows : sides[s].rows;
        add_outer(late, is_later ? other : scaled, lower[*pair]);
        add_outer(is_later ? scaled : other, early, upper[*pair]);
      }
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
      ordered_(plan.size()) {}

bool NodeLu::factor(const std::vector<Mat3>& g) {
  NodeBlock one;
  for (int k = 0; k < k_node_size; ++k) one.column[k][k] = 1;
  diagonal_.assign(diagonal_.size(), one);
  lower_.assign(lower_.size(), {});
  upper_.assign(upper_.size(), {});
  add_contacts_to_both(island_, plan_, g.data(), diagonal_.data(), lower_.data(), upper_.data());
  return eliminate_both(plan_, diagonal_.data(), lower_.data(), upper_.data());
}

void NodeLu::solve(NodeVector& x) {
  for (int k = 0; k < plan_.size(); ++k) ordered_[k] = x[plan_.source[k]];
  substitute_both(plan_, diagonal_.data(), lower_.data(), upper_.data(), ordered_.data());
  for (int k = 0; k < plan_.size(); ++k) x[plan_.source[k]] = ordered_[k];
}

}  // namespace nilas::solvers
