#include "contact/problem/local_problem.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "contact/problem/islands.h"
#include "contact/problem/operators.h"
#include "core/base/error.h"

namespace nilas {

namespace {

std::size_t at(int i) { return static_cast<std::size_t>(i); }
Eigen::Index row_of(int c) { return 3 * static_cast<Eigen::Index>(c); }

/// Place of block (a, b) in the lists, or -1.
std::ptrdiff_t find_block(const LocalProblem& problem, int a, int b) {
  const auto first = problem.column.begin() + problem.row_start[at(a)];
  const auto last = problem.column.begin() + problem.row_start[at(a) + 1];
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
struct Side {
  int contact;
  ContactProblem::ConstJacobian jacobian;
};

std::vector<std::vector<Side>> sides_by_block(const ContactProblem& problem) {
  std::vector<std::vector<Side>> sides(at(problem.num_blocks()));
  for (int c = 0; c < problem.num_contacts(); ++c) {
    const auto& pair = problem.pairs[at(c)];
    if (pair.a >= 0) sides[at(pair.a)].push_back({c, problem.jacobian_a(c)});
    if (pair.b >= 0) sides[at(pair.b)].push_back({c, problem.jacobian_b(c)});
  }
  return sides;
}

/// Contacts that share a block with each contact, rising, itself among them.
std::vector<std::vector<int>> neighbours(const ContactProblem& problem,
                                         const std::vector<std::vector<Side>>& sides_of_block) {
  std::vector<std::vector<int>> lists(at(problem.num_contacts()));
  for (int c = 0; c < problem.num_contacts(); ++c) {
    auto& list = lists[at(c)];
    list.push_back(c);
    for (const int k : {problem.pairs[at(c)].a, problem.pairs[at(c)].b})
      if (k >= 0)
        for (const Side& side : sides_of_block[at(k)]) list.push_back(side.contact);
    std::sort(list.begin(), list.end());
    list.erase(std::unique(list.begin(), list.end()), list.end());
  }
  return lists;
}

void copy_scalars(const ContactProblem& from, LocalProblem& to) {
  to.law = from.law;
  to.facets = from.facets;
  to.mu = from.mu;
  to.mu_static = from.mu_static;
  to.force_limit = from.force_limit;
  to.compliance = from.compliance;
  to.key = from.key;
}

int root_of(std::vector<int>& parent, int k) {
  while (parent[at(k)] != k) {
    parent[at(k)] = parent[at(parent[at(k)])];
    k = parent[at(k)];
  }
  return k;
}

}  // namespace

const Mat3& LocalProblem::diagonal(int a) const {
  const std::ptrdiff_t place = find_block(*this, a, a);
  NILAS_DEMAND(place >= 0);
  return block[static_cast<std::size_t>(place)];
}

VecX contact_velocities(const LocalProblem& problem, const VecX& r) {
  NILAS_DEMAND(r.size() == row_of(problem.num_contacts()));
  VecX u = problem.q;
  for (int a = 0; a < problem.num_contacts(); ++a) {
    Vec3 sum = Vec3::Zero();
    for (int k = problem.row_start[at(a)]; k < problem.row_start[at(a) + 1]; ++k)
      sum += problem.block[at(k)] * r.segment<3>(row_of(problem.column[at(k)]));
    u.segment<3>(row_of(a)) += sum;
  }
  return u;
}

LocalProblem reduce(const ContactProblem& problem) {
  NILAS_DEMAND(!problem.has_moments());
  LocalProblem local;
  copy_scalars(problem, local);
  const MassInverse masses(problem);
  const auto sides_of_block = sides_by_block(problem);
  for (const auto& list : neighbours(problem, sides_of_block)) {
    local.column.insert(local.column.end(), list.begin(), list.end());
    local.row_start.push_back(static_cast<int>(local.column.size()));
  }
  local.block.assign(local.column.size(), Mat3::Zero());
  for (int k = 0; k < problem.num_blocks(); ++k)
    for (const Side& to : sides_of_block[at(k)]) {
      const MatX response = response_of(masses, k, to.jacobian);
      for (const Side& from : sides_of_block[at(k)])
        local.block[static_cast<std::size_t>(find_block(local, from.contact, to.contact))] +=
            from.jacobian.lazyProduct(response);
    }
  local.q = contact_velocities(problem, velocities(problem, masses, VecX::Zero(row_of(problem.num_contacts()))));
  return local;
}

std::vector<std::vector<int>> find_islands(const LocalProblem& problem) {
  std::vector<int> parent(at(problem.num_contacts()));
  std::iota(parent.begin(), parent.end(), 0);
  for (int a = 0; a < problem.num_contacts(); ++a)
    for (int k = problem.row_start[at(a)]; k < problem.row_start[at(a) + 1]; ++k) {
      if (problem.block[at(k)].isZero(0)) continue;
      const int one = root_of(parent, a), other = root_of(parent, problem.column[at(k)]);
      parent[at(std::max(one, other))] = std::min(one, other);
    }
  std::vector<std::vector<int>> islands;
  std::vector<int> island_of(parent.size(), -1);
  for (int a = 0; a < problem.num_contacts(); ++a) {
    int& island = island_of[at(root_of(parent, a))];
    if (island < 0) {
      island = static_cast<int>(islands.size());
      islands.emplace_back();
    }
    islands[at(island)].push_back(a);
  }
  return islands;
}

LocalProblem select(const LocalProblem& problem, const std::vector<int>& contacts) {
  LocalProblem part;
  part.law = problem.law;
  part.facets = problem.facets;
  part.q.resize(row_of(static_cast<int>(contacts.size())));
  std::vector<int> place(at(problem.num_contacts()), -1);
  for (std::size_t i = 0; i < contacts.size(); ++i) place[at(contacts[i])] = static_cast<int>(i);
  for (std::size_t i = 0; i < contacts.size(); ++i) {
    const std::size_t c = at(contacts[i]);
    for (int k = problem.row_start[c]; k < problem.row_start[c + 1]; ++k) {
      if (place[at(problem.column[at(k)])] < 0) continue;
      part.column.push_back(place[at(problem.column[at(k)])]);
      part.block.push_back(problem.block[at(k)]);
    }
    part.row_start.push_back(static_cast<int>(part.column.size()));
    part.q.segment<3>(row_of(static_cast<int>(i))) = problem.q.segment<3>(row_of(contacts[i]));
    part.mu.push_back(problem.mu[c]);
    part.mu_static.push_back(problem.mu_static[c]);
    part.force_limit.push_back(problem.force_limit[c]);
    part.compliance.push_back(problem.compliance[c]);
    part.key.push_back(problem.key[c]);
  }
  return part;
}

double asymmetry(const LocalProblem& problem) {
  double largest = 0, difference = 0;
  for (int a = 0; a < problem.num_contacts(); ++a)
    for (int k = problem.row_start[at(a)]; k < problem.row_start[at(a) + 1]; ++k) {
      const Mat3& w = problem.block[at(k)];
      largest = std::max(largest, w.cwiseAbs().maxCoeff());
      const std::ptrdiff_t mirror = find_block(problem, problem.column[at(k)], a);
      const Mat3 other =
          mirror < 0 ? Mat3(Mat3::Zero()) : Mat3(problem.block[static_cast<std::size_t>(mirror)].transpose());
      difference = std::max(difference, (w - other).cwiseAbs().maxCoeff());
    }
  return largest > 0 ? difference / largest : 0;
}

Eigen::SparseMatrix<double> sparse_matrix(const LocalProblem& problem) {
  std::vector<Eigen::Triplet<double>> entries;
  entries.reserve(9 * problem.block.size());
  for (int a = 0; a < problem.num_contacts(); ++a)
    for (int k = problem.row_start[at(a)]; k < problem.row_start[at(a) + 1]; ++k)
      for (int i = 0; i < 3; ++i)
        for (int j = 0; j < 3; ++j)
          entries.emplace_back(3 * a + i, 3 * problem.column[at(k)] + j, problem.block[at(k)](i, j));
  Eigen::SparseMatrix<double> w(row_of(problem.num_contacts()), row_of(problem.num_contacts()));
  w.setFromTriplets(entries.begin(), entries.end());
  return w;
}

}  // namespace nilas
