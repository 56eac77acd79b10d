#include "contact/problem/problem.h"

#include <algorithm>

#include "contact/problem/operators.h"
#include "contact/problem/row_of.h"
#include "core/base/error.h"

namespace nilas::contact {

ContactProblem::ConstMatrix ContactProblem::mass(int k) const {
  const int n = block_size(k);
  return ConstMatrix(mass_data.data() + mass_offset[k], n, n);
}

ContactProblem::ConstJacobian ContactProblem::jacobian_a(int c) const {
  const auto i = static_cast<std::size_t>(c);
  const int n = pairs[i].a < 0 ? 0 : block_size(pairs[i].a);
  return ConstJacobian(jacobian_data.data() + jacobian_offset[i], 3, n);
}

ContactProblem::ConstJacobian ContactProblem::jacobian_b(int c) const {
  const auto i = static_cast<std::size_t>(c);
  const int n_a = pairs[i].a < 0 ? 0 : block_size(pairs[i].a);
  const int n_b = pairs[i].b < 0 ? 0 : block_size(pairs[i].b);
  return ConstJacobian(jacobian_data.data() + jacobian_offset[i] + 3 * static_cast<std::size_t>(n_a), 3, n_b);
}

int ContactProblem::add_block(const Eigen::Ref<const MatX>& mass) {
  NILAS_DEMAND(mass.rows() == mass.cols() && mass.rows() > 0);
  const auto n = mass.rows();
  block_offset.push_back(block_offset.back() + static_cast<int>(n));
  for (Eigen::Index j = 0; j < n; ++j)
    for (Eigen::Index i = 0; i < n; ++i) mass_data.push_back(mass(i, j));
  mass_offset.push_back(mass_data.size());
  f.conservativeResizeLike(VecX::Zero(block_offset.back()));
  return num_blocks() - 1;
}

int ContactProblem::add_contact(int block_a, const Eigen::Ref<const MatX>& jacobian_a, int block_b,
                                const Eigen::Ref<const MatX>& jacobian_b, std::uint64_t contact_key) {
  const auto append = [&](int block, const Eigen::Ref<const MatX>& jacobian) {
    NILAS_DEMAND(block < num_blocks());
    if (block < 0) return;
    NILAS_DEMAND(jacobian.rows() == 3 && jacobian.cols() == block_size(block));
    for (Eigen::Index i = 0; i < 3; ++i)
      for (Eigen::Index j = 0; j < jacobian.cols(); ++j) jacobian_data.push_back(jacobian(i, j));
  };
  append(block_a, jacobian_a);
  append(block_b, jacobian_b);
  jacobian_offset.push_back(jacobian_data.size());
  pairs.push_back({block_a, block_b});
  w.conservativeResizeLike(VecX::Zero(row_of(pairs.size())));
  mu.push_back(0);
  mu_static.push_back(0);
  force_limit.push_back(std::numeric_limits<double>::infinity());
  compliance.push_back(0);
  tangential_compliance.push_back(0);
  key.push_back(contact_key);
  if (has_moments()) moments.emplace_back();
  return num_contacts() - 1;
}

int ContactProblem::add_moment(int contact, const Eigen::Ref<const MatX>& jacobian_a,
                               const Eigen::Ref<const MatX>& jacobian_b, double rolling, std::uint64_t moment_key) {
  NILAS_DEMAND(contact >= 0 && contact < num_contacts() && !is_moment(contact) && moment_of(contact) < 0);
  const Pair pair = pairs[contact];
  if (!has_moments()) moments.resize(pairs.size());
  const int moment = add_contact(pair.a, jacobian_a, pair.b, jacobian_b, moment_key);
  mu.back() = mu_static.back() = 1;  // its lengths are in the rows
  moments[contact].moment = moment;
  moments.back().contact = contact;
  moments.back().rolling = rolling;
  return moment;
}

int ContactProblem::num_points() const {
  return num_contacts() - static_cast<int>(std::count_if(moments.begin(), moments.end(),
                                                         [](const Moment& m) { return m.contact >= 0; }));
}

std::vector<Mat3> delassus_diagonal(const ContactProblem& problem) {
  const MassInverse masses(problem);
  std::vector<double> response(largest_response(problem));
  std::vector<Mat3> blocks;
  blocks.reserve(problem.pairs.size());
  for (int c = 0; c < problem.num_contacts(); ++c)
    blocks.push_back(delassus_block(problem, masses, c, response.data()));
  return blocks;
}

VecX velocities(const ContactProblem& problem, const VecX& r) { return velocities(problem, MassInverse(problem), r); }

VecX contact_velocities(const ContactProblem& problem, const VecX& v) {
  NILAS_DEMAND(v.size() == problem.num_velocities());
  VecX u(3 * problem.num_contacts());
  for (int c = 0; c < problem.num_contacts(); ++c) u.segment<3>(row_of(c)) = contact_velocity(problem, c, v.data());
  return u;
}

}  // namespace nilas::contact
