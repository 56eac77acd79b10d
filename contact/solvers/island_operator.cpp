#include "contact/solvers/island_operator.h"

#include <cmath>

#include "contact/solvers/contact_sides.h"

namespace nilas {

namespace {

Eigen::Index row_of(int c) { return 3 * static_cast<Eigen::Index>(c); }

class LocalOperator final : public IslandOperator {
 public:
  explicit LocalOperator(const LocalProblem& problem) : problem_(problem) {
    law_ = problem.law;
    facets_ = problem.facets;
    for (int c = 0; c < problem.num_contacts(); ++c) scales_.push_back(contact_scale(problem, c));
  }

  void velocities(const VecX& r, VecX& u) override {
    u = contact_velocities(problem_, r);
    for (int c = 0; c < num_contacts(); ++c)
      u[row_of(c)] += problem_.compliance[static_cast<std::size_t>(c)] * r[row_of(c)];
  }

  double law_map(const VecX& r) override {
    VecX u;
    velocities(r, u);
    return estimate(r, u);
  }

 private:
  const LocalProblem& problem_;
};

class RowsOperator final : public IslandOperator {
 public:
  explicit RowsOperator(const RowIsland& island) : island_(island) {
    law_ = island.problem.law;
    facets_ = island.problem.facets;
    const auto& scales = island.rows.scales;
    scales_.assign(scales.begin() + island.island.first, scales.begin() + island.island.last);
    for (const int k : island.island.blocks) {
      const auto i = static_cast<std::size_t>(k);
      blocks_.push_back({island.rows.first_velocity[i], island.problem.block_size(k)});
    }
    for (int c = 0; c < num_contacts(); ++c) add<-1>(contact(c), contact(c).r);
    for (const Block& block : blocks_) {
      const auto part = island.rows.velocities.segment(block.first, block.size);
      free_.insert(free_.end(), part.begin(), part.end());
    }
  }

  void velocities(const VecX& r, VecX& u) override {
    u.resize(r.size());
    set_free();
    for (int c = 0; c < num_contacts(); ++c) add<1>(contact(c), r.data() + row_of(c));
    for (int c = 0; c < num_contacts(); ++c) gather(contact(c), r.data() + row_of(c), u.data() + row_of(c));
  }

  double law_map(const VecX& r) override {
    for (int c = 0; c < num_contacts(); ++c) std::copy_n(r.data() + row_of(c), 3, contact(c).r);
    return island_.residual.law_map(island_.rows, island_.island);
  }

 private:
  struct Block {
    int first, size;
  };

  PgsContact& contact(int c) { return island_.rows.contacts[static_cast<std::size_t>(island_.island.first + c)]; }

  void set_free() {
    const double* from = free_.data();
    for (const Block& block : blocks_) {
      std::copy_n(from, block.size, island_.rows.velocities.data() + block.first);
      from += block.size;
    }
  }

  template <class Work>
  void with_sides(const PgsContact& c, const Work& work) {
    const double* const rows = island_.rows.coefficients.data();
    double* const v = island_.rows.velocities.data();
    if (c.shape == PgsShape::six_six)
      work(Sides<6, 6>(c, rows, v));
    else if (c.shape == PgsShape::six_none)
      work(Sides<6, 0>(c, rows, v));
    else if (c.shape == PgsShape::none_six)
      work(Sides<0, 6>(c, rows, v));
    else
      work(Sides<k_any, k_any>(c, rows, v));
  }

  /// Velocities of the bodies with the impulse added (sign 1) or taken out (-1).
  template <int sign>
  void add(const PgsContact& c, const double* r) {
    if (r[0] == 0 && r[1] == 0 && r[2] == 0) return;
    with_sides(c, [&](const auto& sides) {
      if (law_ == Law::frictionless)
        sides.apply_normal(sign * r[0]);
      else
        sides.apply(sign * r[0], sign * r[1], sign * r[2]);
    });
  }

  void gather(const PgsContact& c, const double* r, double* u) {
    with_sides(c, [&](const auto& sides) {
      u[0] = sides.velocity(0) + c.w[0] + c.compliance * r[0];
      for (int i = 1; i < 3; ++i) u[i] = law_ == Law::frictionless ? 0 : sides.velocity(i) + c.w[i];
    });
  }

  RowIsland island_;
  std::vector<Block> blocks_;
  std::vector<double> free_;  ///< velocities without impulses, block by block
};

}  // namespace

double IslandOperator::estimate(const VecX& r, const VecX& u) const {
  double worst = 0;
  for (int c = 0; c < num_contacts(); ++c) {
    const double map = nilas::law_map(law_, facets_, scales_[static_cast<std::size_t>(c)], r.segment<3>(row_of(c)),
                                      u.segment<3>(row_of(c)));
    if (!(map <= worst)) worst = map;
    if (std::isnan(worst)) break;
  }
  return worst;
}

std::unique_ptr<IslandOperator> make_operator(const LocalProblem& island) {
  return std::make_unique<LocalOperator>(island);
}

std::unique_ptr<IslandOperator> make_operator(const RowIsland& island) {
  return std::make_unique<RowsOperator>(island);
}

ContactSolution solve_by_operator(const LocalProblem& problem, const VecX& guess, const SolverSettings& shared,
                                  const OperatorSolve& solve) {
  return solve_islands(problem, guess, [&](const LocalProblem& island, const VecX& start) {
    const auto as_operator = make_operator(island);
    ContactSolution solution = solve(*as_operator, start.size() > 0 ? start : VecX(VecX::Zero(island.q.size())));
    const std::string culprit = find_culprit(island, solution.r, shared.tolerance);
    if (!culprit.empty()) {
      solution.status = SolveStatus::numerical_error;
      solution.message = culprit;
    }
    return solution;
  });
}

ContactSolution solve_by_operator(const ContactProblem& problem, const VecX& guess, const SolverSettings& shared,
                                  const OperatorSolve& solve) {
  return solve_row_islands(problem, guess, shared, [&](const RowIsland& island) {
    VecX start(row_of(island.island.last - island.island.first));
    for (int k = island.island.first; k < island.island.last; ++k)
      start.segment<3>(row_of(k - island.island.first)) =
          Eigen::Map<const Vec3>(island.rows.contacts[static_cast<std::size_t>(k)].r);
    const auto as_operator = make_operator(island);
    ContactSolution solution = solve(*as_operator, start);
    for (int k = island.island.first; k < island.island.last; ++k)
      std::copy_n(solution.r.data() + row_of(k - island.island.first), 3,
                  island.rows.contacts[static_cast<std::size_t>(k)].r);
    return solution;
  });
}

}  // namespace nilas
