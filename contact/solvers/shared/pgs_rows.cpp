#include "contact/solvers/shared/pgs_rows.h"

#include <algorithm>
#include <cmath>

#include "contact/problem/operators.h"
#include "contact/problem/row_of.h"
#include "contact/solvers/shared/colouring.h"
#include "contact/solvers/shared/pgs_sweep.h"
#include "core/base/parallel.h"

namespace nilas::solvers {

/// Stands for the mass of what cannot move: any velocity drives the impulse to its bound in one step [kg].
constexpr double k_immovable_mass = 1e100;

static void place_velocities(const contact::ContactProblem& problem, PgsRows& rows) {
  int place = 0;
  for (int k = 0; k < problem.num_blocks(); ++k) {
    rows.first_velocity.push_back(place);
    place += problem.block_size(k) + problem.block_size(k) % 2;
  }
  rows.velocities = VecX::Zero(place);
}

static PgsShape shape_of(const contact::ContactProblem::Pair& pair, int size_a, int size_b) {
  if (pair.a == pair.b) return PgsShape::general;
  if (size_a == 6 && size_b == 6) return PgsShape::six_six;
  if (size_a == 6 && size_b == 0) return PgsShape::six_none;
  if (size_a == 0 && size_b == 6) return PgsShape::none_six;
  return PgsShape::general;
}

/// Where contact c reads and writes; its numbers follow later.
static PgsContact place_contact(const contact::ContactProblem& problem, const PgsRows& rows, int c) {
  const auto& pair = problem.pairs[c];
  PgsContact contact;
  if (pair.a >= 0) contact.first_a = rows.first_velocity[pair.a];
  if (pair.b >= 0) contact.first_b = rows.first_velocity[pair.b];
  contact.size_a = pair.a < 0 ? 0 : problem.block_size(pair.a);
  contact.size_b = pair.b < 0 ? 0 : problem.block_size(pair.b);
  contact.shape = shape_of(pair, contact.size_a, contact.size_b);
  return contact;
}

static bool has_roots(const contact::MassInverse& masses, const contact::ContactProblem::Pair& pair) {
  return (pair.a < 0 || masses.has_root(pair.a)) && (pair.b < 0 || masses.has_root(pair.b));
}

static void place_islands(const contact::PreparedProblem& prepared, RowOrder order, PgsRows& rows) {
  const contact::ContactProblem& problem = prepared.problem();
  const contact::MassInverse& masses = prepared.masses();
  const int rows_per_contact = rows.law == Law::frictionless ? 1 : 3;
  std::vector<char> listed(static_cast<std::size_t>(problem.num_blocks()), 0);
  Eigen::Index coefficients = 0;
  for (auto members : prepared.islands()) {
    PgsIsland island;
    island.first = static_cast<int>(rows.source.size());
    if (order == RowOrder::coloured && members.size() >= k_fewest_coloured)
      colour(problem, members, island.first, island.runs, island.colours);
    for (const int c : members) {
      for (const int k : {problem.pairs[c].a, problem.pairs[c].b}) {
        if (k < 0 || listed[k] != 0) continue;
        listed[k] = 1;
        island.blocks.push_back(k);
      }
      PgsContact& contact = rows.contacts.emplace_back(place_contact(problem, rows, c));
      Eigen::Index count = rows_per_contact * contact.stride();
      count += count % 2;  // the unrolled sweeps load pairs
      const bool once = has_roots(masses, problem.pairs[c]);
      contact.rows = coefficients;
      contact.responses = once ? coefficients : coefficients + count;
      coefficients += once ? count : 2 * count;
      rows.source.push_back(c);
    }
    island.last = static_cast<int>(rows.source.size());
    rows.islands.push_back(std::move(island));
  }
  rows.coefficients.resize(coefficients);
  rows.scales.resize(rows.contacts.size());
}

static void link_moments(const contact::ContactProblem& problem, PgsRows& rows) {
  if (!problem.has_moments()) return;
  std::vector<int> place(problem.pairs.size());
  for (std::size_t k = 0; k < rows.source.size(); ++k) place[rows.source[k]] = static_cast<int>(k);
  for (std::size_t k = 0; k < rows.source.size(); ++k) {
    const auto& moment = problem.moments[rows.source[k]];
    if (moment.moment >= 0) rows.contacts[k].moment = place[moment.moment];
    if (moment.contact >= 0) rows.contacts[k].bound_by = place[moment.contact];
  }
}

RowWeights row_weights(const Mat3& w, Law law, double compliance, double tangential_compliance, double force_limit) {
  const double smallest = k_immovable_share * contact::inverse_mass_scale(w);
  const auto weight = [&](double inverse_mass) {
    return inverse_mass > smallest ? 1 / inverse_mass : k_immovable_mass;
  };
  RowWeights rows;
  rows.weight[0] = compliance > 0 ? 1 / (w(0, 0) + compliance) : weight(w(0, 0));
  rows.unanswerable = rows.weight[0] == k_immovable_mass && std::isinf(force_limit);
  if (rows.unanswerable) rows.weight[0] = 0;
  const double first = w(1, 1) + tangential_compliance, second = w(2, 2) + tangential_compliance;
  const double larger = std::max(first, second);
  rows.weight[1] = weight(law == Law::coulomb ? larger : first);
  rows.weight[2] = weight(law == Law::coulomb ? larger : second);
  return rows;
}

static void set_weights(const Mat3& w, Law law, PgsContact& contact) {
  for (int i = 0; i < 3; ++i) contact.diagonal[i] = w(i, i);
  contact.coupling[0] = w(1, 0);
  contact.coupling[1] = w(2, 0);
  contact.coupling[2] = w(2, 1);
  const RowWeights rows = row_weights(w, law, contact.compliance, contact.tangential_compliance, contact.force_limit);
  std::copy_n(rows.weight, 3, contact.weight);
  contact.unanswerable = rows.unanswerable;
}

/// Row i of one side and its response, written to their places.
static void write_row(const contact::MassInverse& masses, int block, const double* jacobian, Eigen::Index n,
                      double* row, double* response) {
  if (masses.has_root(block)) {
    masses.apply_root(block, jacobian, row);
    if (response != row) std::copy_n(row, n, response);
    return;
  }
  std::copy_n(jacobian, n, row);
  masses.apply(block, jacobian, response);
}

/// All three rows of contact c and their responses.
static void write_rows(const contact::ContactProblem& problem, const contact::MassInverse& masses, int c, double* rows,
                       double* responses) {
  const auto& pair = problem.pairs[c];
  const auto a = problem.jacobian_a(c), b = problem.jacobian_b(c);
  const Eigen::Index n_a = a.cols(), n_b = b.cols(), stride = n_a + n_b;
  for (Eigen::Index i = 0; i < 3; ++i) {
    double *const row = rows + i * stride, *const response = responses + i * stride;
    if (pair.a >= 0) write_row(masses, pair.a, a.data() + i * n_a, n_a, row, response);
    if (pair.b >= 0) write_row(masses, pair.b, b.data() + i * n_b, n_b, row + n_a, response + n_a);
  }
}

/// Lower triangle of W_cc from the rows. `same_block`: both sides belong to one tree, and each moves the other.
[[gnu::always_inline]] static inline Mat3 own_block(const double* rows, const double* responses, Eigen::Index n_a,
                                                    Eigen::Index n_b, bool same_block) {
  const Eigen::Index stride = n_a + n_b;
  Mat3 w = Mat3::Zero();
  for (Eigen::Index i = 0; i < 3; ++i)
    for (Eigen::Index j = 0; j <= i; ++j) {
      const double *const row = rows + i * stride, *const response = responses + j * stride;
      double side_a = 0, side_b = 0;  // apart, so that it does not matter which side is which
      for (Eigen::Index k = 0; k < n_a; ++k) side_a += row[k] * response[k];
      for (Eigen::Index k = n_a; k < stride; ++k) side_b += row[k] * response[k];
      double sum = side_a + side_b;
      if (same_block)
        for (Eigen::Index k = 0; k < n_a; ++k) sum += row[k] * response[n_a + k] + row[n_a + k] * response[k];
      w(i, j) = sum;
    }
  return w;
}

/// The same, unrolled for the usual sizes.
static Mat3 own_block(const PgsContact& contact, const double* rows, const double* responses, bool same_block) {
  constexpr Eigen::Index k_body = 6;
  switch (contact.shape) {
    case PgsShape::six_six:
      return own_block(rows, responses, k_body, k_body, false);
    case PgsShape::six_none:
      return own_block(rows, responses, k_body, 0, false);
    case PgsShape::none_six:
      return own_block(rows, responses, 0, k_body, false);
    case PgsShape::general:
      break;
  }
  return own_block(rows, responses, contact.size_a, contact.size_b, same_block);
}

static void set_impulse(const Vec3& guess, Law law, PgsContact& contact) {
  if (contact.unanswerable) return;
  const double normal = std::clamp(guess[0], 0.0, contact.force_limit);
  const double bound = contact.mu * normal;
  contact.r[0] = normal;
  if (law == Law::pyramid) {
    contact.r[1] = std::clamp(guess[1], -bound, bound);
    contact.r[2] = std::clamp(guess[2], -bound, bound);
  } else if (law != Law::frictionless) {
    const double length = std::sqrt(guess[1] * guess[1] + guess[2] * guess[2]);
    const double share = length > bound ? bound / length : 1;
    contact.r[1] = share * guess[1];
    contact.r[2] = share * guess[2];
  }
}

/// `room`: for the rows of a contact that keeps only its first.
static void fill_contact(const contact::ContactProblem& problem, const contact::MassInverse& masses, const VecX& guess,
                         PgsRows& rows, std::size_t place, double* room) {
  PgsContact& contact = rows.contacts[place];
  const int c = rows.source[place];
  const auto i = static_cast<std::size_t>(c);
  const auto first = contact::row_of(c);
  const auto& pair = problem.pairs[i];
  const bool normal_only = rows.law == Law::frictionless, once = contact.rows == contact.responses;
  double* const all_rows = normal_only ? room : rows.coefficients.data() + contact.rows;
  double* const all_responses =
      once ? all_rows : (normal_only ? room + 3 * contact.stride() : rows.coefficients.data() + contact.responses);
  write_rows(problem, masses, c, all_rows, all_responses);
  if (normal_only) {
    std::copy_n(all_rows, contact.stride(), rows.coefficients.data() + contact.rows);
    if (!once) std::copy_n(all_responses, contact.stride(), rows.coefficients.data() + contact.responses);
  }
  const Mat3 w = own_block(contact, all_rows, all_responses, pair.a == pair.b);
  const double d = contact::inverse_mass_scale(w);
  rows.scales[place] = contact::contact_scale(problem, c, d);
  contact.mu = problem.mu[i];
  contact.force_limit = problem.force_limit[i];
  contact.compliance = problem.compliance[i];
  contact.tangential_compliance = problem.tangential_compliance[i];
  Eigen::Map<Vec3>{contact.w} = problem.w.segment<3>(first);
  set_weights(w, rows.law, contact);
  if (contact.bound_by >= 0) {  // bounded at its first visit
    contact.unanswerable = false;
    if (guess.size() > 0) Eigen::Map<Vec3>{contact.r} = guess.segment<3>(first);
  } else if (guess.size() > 0) {
    set_impulse(guess.segment<3>(first), rows.law, contact);
  }
}

static bool all_finite(const PgsRows& rows) {
  if (!rows.velocities.allFinite()) return false;
  return std::all_of(rows.contacts.begin(), rows.contacts.end(), [](const PgsContact& contact) {
    bool finite = std::isfinite(contact.mu) && std::isfinite(contact.compliance) &&
                  std::isfinite(contact.tangential_compliance) && !std::isnan(contact.force_limit);
    for (int i = 0; i < 3; ++i)
      finite =
          finite && std::isfinite(contact.w[i]) && std::isfinite(contact.diagonal[i]) && std::isfinite(contact.r[i]);
    return finite;
  });
}

void set_block_velocities(const contact::MassInverse& masses, int k, const double* momentum, PgsRows& rows) {
  double* const out = rows.velocities.data() + rows.first_velocity[k];
  if (masses.has_root(k))
    masses.apply_root(k, momentum, out);
  else
    masses.apply(k, momentum, out);
}

static void set_velocities(const contact::ContactProblem& problem, const contact::MassInverse& masses, PgsRows& rows,
                           int threads) {
  parallel_for(problem.num_blocks(), threads, [&](std::ptrdiff_t k) {
    set_block_velocities(masses, static_cast<int>(k), problem.f.data() + problem.block_offset[k], rows);
  });
  rows.finite = all_finite(rows);
  for (const auto& contact : rows.contacts) apply_impulse(contact, rows);
}

PgsRows make_pgs_rows(const contact::PreparedProblem& prepared, const VecX& guess, RowOrder order, int threads) {
  const contact::ContactProblem& problem = prepared.problem();
  const contact::MassInverse& masses = prepared.masses();
  PgsRows rows;
  rows.law = problem.law;
  place_velocities(problem, rows);
  place_islands(prepared, order, rows);
  link_moments(problem, rows);
  const std::size_t room = 2 * contact::largest_response(problem);
  const auto count = static_cast<std::ptrdiff_t>(rows.contacts.size());
  parallel_chunks(count, k_chunk, threads, [&](std::ptrdiff_t, std::ptrdiff_t first, std::ptrdiff_t last) {
    std::vector<double> scratch(room);
    for (std::ptrdiff_t place = first; place < last; ++place)
      fill_contact(problem, masses, guess, rows, static_cast<std::size_t>(place), scratch.data());
  });
  set_velocities(problem, masses, rows, threads);
  return rows;
}

}  // namespace nilas::solvers
