#include "contact/solvers/order_free_velocities.h"

#include <algorithm>
#include <cmath>

#include "contact/mass_inverse.h"
#include "contact/solvers/order_free_sum.h"

namespace nilas {

VecX order_free_velocities(const ContactProblem& problem, const VecX& r) {
  // J^T r of every side, listed by block: what each velocity's momentum sums
  std::vector<std::vector<VecX>> terms(static_cast<std::size_t>(problem.num_blocks()));
  for (int c = 0; c < problem.num_contacts(); ++c) {
    const auto& pair = problem.pairs[static_cast<std::size_t>(c)];
    const Vec3 own = r.segment<3>(3 * static_cast<Eigen::Index>(c));
    const auto add = [&](int block, const auto& jacobian) {
      if (block >= 0) terms[static_cast<std::size_t>(block)].emplace_back(jacobian.transpose().lazyProduct(own));
    };
    add(pair.a, problem.jacobian_a(c));
    add(pair.b, problem.jacobian_b(c));
  }
  const MassInverse masses(problem);
  VecX v = problem.f;
  for (int k = 0; k < problem.num_blocks(); ++k) {
    const auto& own = terms[static_cast<std::size_t>(k)];
    auto block = v.segment(problem.block_offset[static_cast<std::size_t>(k)], problem.block_size(k));
    for (Eigen::Index j = 0; j < block.size(); ++j) {
      double largest = std::abs(block[j]);
      for (const VecX& term : own) largest = std::max(largest, std::abs(term[j]));
      OrderFreeSum sum(largest, static_cast<std::ptrdiff_t>(own.size()) + 1);
      sum.add(block[j]);
      for (const VecX& term : own) sum.add(term[j]);
      block[j] = sum.value();
    }
    masses.apply(k, block.data(), block.data());
  }
  return v;
}

}  // namespace nilas
