#include "contact/solvers/shared/order_free_velocities.h"

#include "contact/problem/row_of.h"
#include "core/base/order_free_sum.h"

namespace nilas::solvers {

VecX order_free_velocities(const contact::PreparedProblem& prepared, const VecX& r) {
  const contact::ContactProblem& problem = prepared.problem();
  std::vector<OrderFreeSum> momenta(static_cast<std::size_t>(problem.num_velocities()));
  for (std::size_t i = 0; i < momenta.size(); ++i) momenta[i].add(problem.f[static_cast<Eigen::Index>(i)]);
  for (int c = 0; c < problem.num_contacts(); ++c) {
    const auto& pair = problem.pairs[c];
    const Vec3 own = r.segment<3>(contact::row_of(c));
    const auto add = [&](int block, const auto& jacobian) {
      if (block < 0) return;
      const auto first = static_cast<std::size_t>(problem.block_offset[block]);
      for (Eigen::Index j = 0; j < jacobian.cols(); ++j)
        momenta[first + static_cast<std::size_t>(j)].add(jacobian.col(j).dot(own));
    };
    add(pair.a, problem.jacobian_a(c));
    add(pair.b, problem.jacobian_b(c));
  }
  VecX v(problem.num_velocities());
  for (std::size_t i = 0; i < momenta.size(); ++i) v[static_cast<Eigen::Index>(i)] = momenta[i].value();
  for (int k = 0; k < problem.num_blocks(); ++k) {
    double* const block = v.data() + problem.block_offset[k];
    prepared.masses().apply(k, block, block);
  }
  return v;
}

}  // namespace nilas::solvers
