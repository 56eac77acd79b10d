#include "contact/solvers/island_operator.h"

#include <cmath>

#include "contact/problem/row_of.h"
#include "contact/solvers/shared/block_sums.h"
#include "contact/solvers/shared/contact_sides.h"
#include "contact/solvers/shared/order_free_velocities.h"
#include "contact/solvers/solver.h"
#include "core/base/parallel.h"

namespace nilas::solvers {

namespace {

class LocalOperator final : public IslandOperator {
 public:
  explicit LocalOperator(const contact::LocalProblem& problem) : problem_(problem) {
    law_ = problem.law;
    facets_ = problem.facets;
    for (int c = 0; c < problem.num_contacts(); ++c) scales_.push_back(contact::contact_scale(problem, c));
  }

  void velocities(const VecX& r, VecX& u) override {
    u = contact::contact_velocities(problem_, r);
    for (int c = 0; c < num_contacts(); ++c) {
      const auto first = contact::row_of(c);
      u.segment<3>(first) = contact::compliant_velocity(problem_, c, r.segment<3>(first), u.segment<3>(first));
    }
  }

  double law_map(const VecX& r) override {
    VecX u;
    velocities(r, u);
    return estimate(r, u);
  }

 private:
  const contact::LocalProblem& problem_;
};

class RowsOperator final : public IslandOperator {
 public:
  RowsOperator(const RowIsland& island, bool order_free)
      : island_(island), order_free_(order_free), sums_(island, order_free) {
    law_ = island.problem.law;
    facets_ = island.problem.facets;
    threads_ = island.threads;
    const auto& scales = island.rows.scales;
    scales_.assign(scales.begin() + island.island.first, scales.begin() + island.island.last);
  }

  void velocities(const VecX& r, VecX& u) override {
    u.resize(r.size());
    sums_.set_velocities(r);
    parallel_for(num_contacts(), threads_,
                 [&](std::ptrdiff_t c) { gather(contact(static_cast<int>(c)), r.data() + 3 * c, u.data() + 3 * c); });
  }

  double law_map(const VecX& r) override {
    for (int c = 0; c < num_contacts(); ++c) std::copy_n(r.data() + contact::row_of(c), 3, contact(c).r);
    if (!order_free_) return island_.residual.law_map(island_.rows, island_.island);
    VecX u;
    velocities(r, u);
    return estimate(r, u);
  }

 private:
  PgsContact& contact(int c) { return island_.rows.contacts[island_.island.first + c]; }

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

  void gather(const PgsContact& c, const double* r, double* u) {
    with_sides(c, [&](const auto& sides) {
      u[0] = sides.velocity(0) + c.w[0] + c.compliance * r[0];
      for (int i = 1; i < 3; ++i)
        u[i] = law_ == Law::frictionless ? 0 : sides.velocity(i) + c.w[i] + c.tangential_compliance * r[i];
    });
  }

  RowIsland island_;
  bool order_free_;
  BlockSums sums_;
};

}  // namespace

double IslandOperator::estimate(const VecX& r, const VecX& u) const {
  std::vector<double> worst_of(static_cast<std::size_t>(num_chunks(num_contacts())), 0.0);
  const auto keep = [](double map, double& worst) {
    if (!(map <= worst) && !std::isnan(worst)) worst = map;
  };
  parallel_chunks(num_contacts(), k_chunk, threads_, [&](std::ptrdiff_t k, std::ptrdiff_t first, std::ptrdiff_t last) {
    for (std::ptrdiff_t c = first; c < last; ++c)
      keep(nilas::contact::law_map(law_, facets_, scales_[c], r.segment<3>(3 * c), u.segment<3>(3 * c)), worst_of[k]);
  });
  double worst = 0;
  for (const double map : worst_of) keep(map, worst);
  return worst;
}

std::unique_ptr<IslandOperator> make_operator(const contact::LocalProblem& island) {
  return std::make_unique<LocalOperator>(island);
}

std::unique_ptr<IslandOperator> make_operator(const RowIsland& island, bool order_free) {
  return std::make_unique<RowsOperator>(island, order_free);
}

contact::ContactSolution solve_by_operator(const contact::LocalProblem& problem, const VecX& guess,
                                           const contact::SolverSettings& shared, const OperatorSolve& solve) {
  return solve_islands(problem, guess, [&](const contact::LocalProblem& island, const VecX& start) {
    const auto as_operator = make_operator(island);
    contact::ContactSolution solution =
        solve(*as_operator, start.size() > 0 ? start : VecX(VecX::Zero(island.q.size())));
    const std::string culprit = find_culprit(island, solution.r, shared.tolerance);
    if (!culprit.empty()) {
      solution.status = contact::SolveStatus::numerical_error;
      solution.message = culprit;
    }
    return solution;
  });
}

contact::ContactSolution solve_by_operator(const contact::PreparedProblem& problem, const VecX& guess,
                                           const contact::SolverSettings& shared, bool order_free,
                                           const OperatorSolve& solve) {
  contact::ContactSolution out =
      solve_row_islands(problem, guess, shared, RowOrder::given, [&](const RowIsland& island) {
        VecX start(contact::row_of(island.island.last - island.island.first));
        for (int k = island.island.first; k < island.island.last; ++k)
          start.segment<3>(contact::row_of(k - island.island.first)) =
              Eigen::Map<const Vec3>(island.rows.contacts[k].r);
        const auto as_operator = make_operator(island, order_free);
        contact::ContactSolution solution = solve(*as_operator, start);
        for (int k = island.island.first; k < island.island.last; ++k)
          std::copy_n(solution.r.data() + contact::row_of(k - island.island.first), 3, island.rows.contacts[k].r);
        return solution;
      });
  if (order_free) {
    out.v = order_free_velocities(problem, out.r);
    out.u = contact::contact_velocities(problem.problem(), out.v);
  }
  return out;
}

}  // namespace nilas::solvers
