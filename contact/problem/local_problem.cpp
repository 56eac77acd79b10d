#include "contact/problem/local_problem.h"

#include <algorithm>
#include <cmath>

#include "contact/problem/operators.h"
#include "contact/problem/row_of.h"
#include "core/base/error.h"

namespace nilas::contact {

namespace {

/// Place of block (a, b) in the lists, or -1.
std::ptrdiff_t find_block(const LocalProblem& problem, int a, int b) {
  const auto first = problem.column.begin() + problem.row_start[a];
  const auto last = problem.column.begin() + problem.row_start[a + 1];
  const auto found = std::lower_bound(first, last, b);
  return found != last && *found == b ? found - problem.column.begin() : -1;
}

/// M_k^-1 J^T of one side of a contact, n x 3.
MatX response_of(const MassInverse& masses, int block, const ContactProblem::ConstJacobian& jacobian) {
  MatX response(jacobian.cols(), 3);
  for (int i = 0; i < 3; ++i)
    masses.apply(block, jacobian.data() + i * jacobian.cols(), response.data() + i * jacobian.cols());
  return response;
}

/// One side of a contact on a block.
struct BlockSide {
  int contact;
  ContactProblem::ConstJacobian jacobian;
};

std::vector<std::vector<BlockSide>> sides_by_block(const ContactProblem& problem) {
  std::vector<std::vector<BlockSide>> sides(problem.num_blocks());
  for (int c = 0; c < problem.num_contacts(); ++c) {
    const auto& pair = problem.pairs[c];
    if (pair.a >= 0) sides[pair.a].push_back({c, problem.jacobian_a(c)});
    if (pair.b >= 0) sides[pair.b].push_back({c, problem.jacobian_b(c)});
  }
  return sides;
}

/// Contacts that share a block with each contact, rising, itself among them.
std::vector<std::vector<int>> neighbours(const ContactProblem& problem,
                                         const std::vector<std::vector<BlockSide>>& sides_of_block) {
  std::vector<std::vector<int>> lists(problem.num_contacts());
  for (int c = 0; c < problem.num_contacts(); ++c) {
    auto& list = lists[c];
    list.push_back(c);
    for (const int k : {problem.pairs[c].a, problem.pairs[c].b})
      if (k >= 0)
        for (const BlockSide& side : sides_of_block[k]) list.push_back(side.contact);
    std::sort(list.begin(), list.end());
    list.erase(std::unique(list.begin(), list.end()), list.end());
  }
  return lists;
}

}  // namespace

const Mat3& LocalProblem::diagonal(int a) const {
  const std::ptrdiff_t place = find_block(*this, a, a);
  NILAS_DEMAND(place >= 0);
  return block[place];
}

VecX contact_velocities(const LocalProblem& problem, const VecX& r) {
  NILAS_DEMAND(r.size() == row_of(problem.num_contacts()));
  VecX u = problem.q;
  for (int a = 0; a < problem.num_contacts(); ++a) {
    Vec3 sum = Vec3::Zero();
    for (int k = problem.row_start[a]; k < problem.row_start[a + 1]; ++k)
      sum += problem.block[k] * r.segment<3>(row_of(problem.column[k]));
    u.segment<3>(row_of(a)) += sum;
  }
  return u;
}

LocalProblem reduce(const ContactProblem& problem) {
  NILAS_DEMAND(!problem.has_moments());
  LocalProblem local;
  static_cast<ContactCoefficients&>(local) = problem;
  const MassInverse masses(problem);
  const auto sides_of_block = sides_by_block(problem);
  for (const auto& list : neighbours(problem, sides_of_block)) {
    local.column.insert(local.column.end(), list.begin(), list.end());
    local.row_start.push_back(static_cast<int>(local.column.size()));
  }
  local.block.assign(local.column.size(), Mat3::Zero());
  for (int k = 0; k < problem.num_blocks(); ++k)
    for (const BlockSide& to : sides_of_block[k]) {
      const MatX response = response_of(masses, k, to.jacobian);
      for (const BlockSide& from : sides_of_block[k])
        local.block[find_block(local, from.contact, to.contact)] += from.jacobian.lazyProduct(response);
    }
  local.q = contact_velocities(problem, velocities(problem, masses, VecX::Zero(row_of(problem.num_contacts()))));
  return local;
}

double asymmetry(const LocalProblem& problem) {
  double largest = 0, difference = 0;
  for (int a = 0; a < problem.num_contacts(); ++a)
    for (int k = problem.row_start[a]; k < problem.row_start[a + 1]; ++k) {
      const Mat3& w = problem.block[k];
      largest = std::max(largest, w.cwiseAbs().maxCoeff());
      const std::ptrdiff_t mirror = find_block(problem, problem.column[k], a);
      const Mat3 other = mirror < 0 ? Mat3(Mat3::Zero()) : Mat3(problem.block[mirror].transpose());
      difference = std::max(difference, (w - other).cwiseAbs().maxCoeff());
    }
  return largest > 0 ? difference / largest : 0;
}

Eigen::SparseMatrix<double> sparse_matrix(const LocalProblem& problem) {
  std::vector<Eigen::Triplet<double>> entries;
  entries.reserve(9 * problem.block.size());
  for (int a = 0; a < problem.num_contacts(); ++a)
    for (int k = problem.row_start[a]; k < problem.row_start[a + 1]; ++k)
      for (int i = 0; i < 3; ++i)
        for (int j = 0; j < 3; ++j) entries.emplace_back(3 * a + i, 3 * problem.column[k] + j, problem.block[k](i, j));
  Eigen::SparseMatrix<double> w(row_of(problem.num_contacts()), row_of(problem.num_contacts()));
  w.setFromTriplets(entries.begin(), entries.end());
  return w;
}

}  // namespace nilas::contact
