#include "contact/problem/islands.h"

#include <algorithm>

#include "contact/problem/row_of.h"
#include "core/base/union_find.h"

namespace nilas::contact {

namespace {

/// Copies the blocks that the contacts touch, in their order. Returns the place of each block in `part`, -1: not there.
std::vector<int> select_blocks(const ContactProblem& problem, const std::vector<int>& contacts, ContactProblem& part) {
  std::vector<int> place(problem.num_blocks(), -1);
  for (const int c : contacts)
    for (const int k : {problem.pairs[c].a, problem.pairs[c].b})
      if (k >= 0) place[k] = 0;
  std::vector<double> momenta;
  for (int k = 0; k < problem.num_blocks(); ++k) {
    if (place[k] < 0) continue;
    place[k] = part.num_blocks();
    const auto mass = problem.mass(k);
    part.mass_data.insert(part.mass_data.end(), mass.data(), mass.data() + mass.size());
    part.mass_offset.push_back(part.mass_data.size());
    part.block_offset.push_back(part.block_offset.back() + problem.block_size(k));
    const double* const first = problem.f.data() + problem.block_offset[k];
    momenta.insert(momenta.end(), first, first + problem.block_size(k));
  }
  part.f = Eigen::Map<const VecX>(momenta.data(), static_cast<Eigen::Index>(momenta.size()));
  return place;
}

void select_rows(const ContactProblem& problem, const std::vector<int>& contacts, const std::vector<int>& place,
                 ContactProblem& part) {
  const auto placed = [&](int k) { return k < 0 ? -1 : place[k]; };
  const auto rows = problem.jacobian_data.begin();
  part.w.resize(row_of(contacts.size()));
  part.pairs.reserve(contacts.size());
  part.jacobian_offset.reserve(contacts.size() + 1);
  std::size_t coefficients = 0;
  for (const int c : contacts) coefficients += problem.jacobian_offset[c + 1] - problem.jacobian_offset[c];
  part.jacobian_data.reserve(coefficients);
  for (std::size_t i = 0; i < contacts.size(); ++i) {
    const std::size_t c = contacts[i];
    part.w.segment<3>(row_of(i)) = problem.w.segment<3>(row_of(c));
    part.pairs.push_back({placed(problem.pairs[c].a), placed(problem.pairs[c].b)});
    part.jacobian_data.insert(part.jacobian_data.end(), rows + static_cast<std::ptrdiff_t>(problem.jacobian_offset[c]),
                              rows + static_cast<std::ptrdiff_t>(problem.jacobian_offset[c + 1]));
    part.jacobian_offset.push_back(part.jacobian_data.size());
  }
}

std::vector<ContactProblem::Moment> select_moments(const ContactProblem& problem, const std::vector<int>& contacts) {
  const auto placed = [&](int c) {
    return c < 0 ? -1 : static_cast<int>(std::lower_bound(contacts.begin(), contacts.end(), c) - contacts.begin());
  };
  std::vector<ContactProblem::Moment> moments;
  for (const int c : contacts) {
    const auto& moment = problem.moments[c];
    moments.push_back({placed(moment.contact), placed(moment.moment), moment.rolling});
  }
  return moments;
}

}  // namespace

std::vector<std::vector<int>> find_islands(const ContactProblem& problem) {
  UnionFind blocks(problem.num_blocks());
  for (const auto& pair : problem.pairs)
    if (pair.a >= 0 && pair.b >= 0) blocks.join(pair.a, pair.b);
  std::vector<std::size_t> block_of;
  block_of.reserve(problem.pairs.size());
  for (const auto& pair : problem.pairs)  // where nothing can move a contact is an island of its own
    block_of.push_back(pair.a >= 0   ? static_cast<std::size_t>(pair.a)
                       : pair.b >= 0 ? static_cast<std::size_t>(pair.b)
                                     : UnionFind::k_nothing);
  return blocks.groups_of(block_of);
}

std::vector<std::vector<int>> find_islands(const LocalProblem& problem) {
  UnionFind contacts(problem.num_contacts());
  for (int a = 0; a < problem.num_contacts(); ++a)
    for (int k = problem.row_start[a]; k < problem.row_start[a + 1]; ++k)
      if (!problem.block[k].isZero(0)) contacts.join(a, problem.column[k]);
  return contacts.groups();
}

ContactProblem select(const ContactProblem& problem, const std::vector<int>& contacts) {
  ContactProblem part;
  static_cast<ContactCoefficients&>(part) = select(static_cast<const ContactCoefficients&>(problem), contacts);
  part.h = problem.h;
  select_rows(problem, contacts, select_blocks(problem, contacts, part), part);
  if (problem.has_moments()) part.moments = select_moments(problem, contacts);
  return part;
}

LocalProblem select(const LocalProblem& problem, const std::vector<int>& contacts) {
  LocalProblem part;
  static_cast<ContactCoefficients&>(part) = select(static_cast<const ContactCoefficients&>(problem), contacts);
  part.q.resize(row_of(contacts.size()));
  std::vector<int> place(problem.num_contacts(), -1);
  for (std::size_t i = 0; i < contacts.size(); ++i) place[contacts[i]] = static_cast<int>(i);
  for (std::size_t i = 0; i < contacts.size(); ++i) {
    const std::size_t c = contacts[i];
    for (int k = problem.row_start[c]; k < problem.row_start[c + 1]; ++k) {
      if (place[problem.column[k]] < 0) continue;
      part.column.push_back(place[problem.column[k]]);
      part.block.push_back(problem.block[k]);
    }
    part.row_start.push_back(static_cast<int>(part.column.size()));
    part.q.segment<3>(row_of(i)) = problem.q.segment<3>(row_of(c));
  }
  return part;
}

}  // namespace nilas::contact
