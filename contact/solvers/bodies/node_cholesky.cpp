#include "contact/solvers/bodies/node_cholesky.h"

#include <cmath>

#include "contact/solvers/bodies/node_products.h"
#include "contact/solvers/linear/wide_clones.h"

namespace nilas::solvers {

namespace {

/// Turns the lower triangle of a block into its Cholesky factor, with the inverses of its diagonal on the diagonal. The
/// matrix is 1 and a positive semidefinite one, so pivots are 1 at least, and smaller ones are rounding.
inline bool root_of_diagonal(NodeBlock& block) {
  auto& x = block.column;
  for (int k = 0; k < k_node_size; ++k) {
    if (!std::isfinite(x[k][k])) return false;
    const double inverse = 1 / std::sqrt(x[k][k] < 1 ? 1 : x[k][k]);
    for (int i = k + 1; i < k_node_size; ++i) x[k][i] *= inverse;
    for (int j = k + 1; j < k_node_size; ++j)
      for (int i = j; i < k_node_size; ++i) x[j][i] -= x[k][i] * x[k][j];
    x[k][k] = inverse;
  }
  return true;
}

/// b <- b C^-T
inline void divide_by_root(NodeBlock& b, const NodeBlock& c) {
  for (int k = 0; k < k_node_size; ++k) {
    scale_column(c.column[k][k], b.column[k]);
    for (int j = k + 1; j < k_node_size; ++j) subtract_column(c.column[k][j], b.column[k], b.column[j]);
  }
}

NILAS_WIDE_CLONES bool eliminate_symmetric(const NodePlan& plan, NodeBlock* diagonal, NodeBlock* below) {
  for (int j = 0; j < plan.size(); ++j) {
    if (!root_of_diagonal(diagonal[j])) return false;
    const std::size_t first = plan.start[j], last = plan.start[j + 1];
    for (std::size_t s = first; s < last; ++s) divide_by_root(below[s], diagonal[j]);
    const int* target = plan.target.data() + plan.target_start[j];
    for (std::size_t s = first; s < last; ++s) {
      subtract_product(below[s], below[s], diagonal[plan.rows[s]]);
      for (std::size_t t = s + 1; t < last; ++t) subtract_product(below[t], below[s], below[*target++]);
    }
  }
  return true;
}

/// y <- C^-1 y, y <- C^-T y
NILAS_WIDE_CLONES void substitute_symmetric(const NodePlan& plan, const NodeBlock* diagonal, const NodeBlock* below,
                                            NodeNumbers* y) {
  for (int j = 0; j < plan.size(); ++j) {
    double* const at = y[j].value;
    const auto& c = diagonal[j].column;
    for (int k = 0; k < k_node_size; ++k) {
      at[k] *= c[k][k];
      for (int i = k + 1; i < k_node_size; ++i) at[i] -= c[k][i] * at[k];
    }
    for (std::size_t s = plan.start[j]; s < plan.start[j + 1]; ++s) subtract_times(below[s], at, y[plan.rows[s]].value);
  }
  for (int j = plan.size() - 1; j >= 0; --j) {
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

NILAS_WIDE_CLONES void add_symmetric_contacts(const BodyIsland& island, const NodePlan& plan, const ContactMatrices& g,
                                              NodeBlock* diagonal, NodeBlock* below) {
  for (int c = 0; c < island.num_contacts(); ++c) {
    const auto sides = island.sides(c);
    const int* pair = plan.pair.data() + plan.pair_start[c];
    const auto entry = [&](std::size_t i) { return g.entry[i][static_cast<std::size_t>(c)]; };
    const double full[3][3] = {
        {entry(0), entry(1), entry(2)}, {entry(1), entry(3), entry(4)}, {entry(2), entry(4), entry(5)}};
    for (std::size_t s = 0; s < sides.size(); ++s) {
      NodeRows scaled;
      multiply(full, sides[s].rows, scaled);
      const int place = plan.place[sides[s].node];
      add_outer(scaled, sides[s].rows, diagonal[place]);
      for (std::size_t t = s + 1; t < sides.size(); ++t, ++pair) {
        // Block (later place, earlier place): the later node's coordinates along the columns.
        if (place > plan.place[sides[t].node])
          add_outer(scaled, sides[t].rows, below[*pair]);
        else
          add_outer(sides[t].rows, scaled, below[*pair]);
      }
    }
  }
}

}  // namespace

NodeCholesky::NodeCholesky(const BodyIsland& island, const NodePlan& plan)
    : island_(island), plan_(plan), diagonal_(plan.size()), below_(plan.num_blocks()), ordered_(plan.size()) {}

void NodeCholesky::assemble(const ContactMatrices& g) {
  NodeBlock one;
  for (int k = 0; k < k_node_size; ++k) one.column[k][k] = 1;
  diagonal_.assign(diagonal_.size(), one);
  below_.assign(below_.size(), {});
  add_symmetric_contacts(island_, plan_, g, diagonal_.data(), below_.data());
}

bool NodeCholesky::factor(const ContactMatrices& g) {
  assemble(g);
  return eliminate_symmetric(plan_, diagonal_.data(), below_.data());
}

void NodeCholesky::solve(NodeVector& x) {
  for (int k = 0; k < plan_.size(); ++k) ordered_[k] = x[plan_.source[k]];
  substitute_symmetric(plan_, diagonal_.data(), below_.data(), ordered_.data());
  for (int k = 0; k < plan_.size(); ++k) x[plan_.source[k]] = ordered_[k];
}

}  // namespace nilas::solvers
