#include "contact/solvers/pgs_rows.h"

#include <algorithm>
#include <cmath>

#include "contact/islands.h"
#include "contact/operators.h"
#include "contact/solvers/pgs_sweep.h"
#include "core/base/parallel.h"

namespace nilas {

/// A row whose inverse mass is below this share of the contact's mean is held by what cannot move; rounding alone gives
/// the square of 1e-16.
constexpr double k_immovable_share = 1e-20;
/// Stands for the mass of what cannot move: any velocity drives the impulse to its bound in one step [kg].
constexpr double k_immovable_mass = 1e100;

static void place_velocities(const ContactProblem& problem, PgsRows& rows) {
  int place = 0;
  for (int k = 0; k < problem.num_blocks(); ++k) {
    rows.first_velocity.push_back(place);
    place += problem.block_size(k) + problem.block_size(k) % 2;
  }
  rows.velocities = VecX::Zero(place);
}

static PgsShape shape_of(const ContactProblem::Pair& pair, int size_a, int size_b) {
  if (pair.a == pair.b) return PgsShape::general;
  if (size_a == 6 && size_b == 6) return PgsShape::six_six;
  if (size_a == 6 && size_b == 0) return PgsShape::six_none;
  if (size_a == 0 && size_b == 6) return PgsShape::none_six;
  return PgsShape::general;
}

/// Where contact c reads and writes; its numbers follow later.
static PgsContact place_contact(const ContactProblem& problem, const PgsRows& rows, int c) {
  const auto& pair = problem.pairs[static_cast<std::size_t>(c)];
  PgsContact contact;
  if (pair.a >= 0) contact.first_a = rows.first_velocity[static_cast<std::size_t>(pair.a)];
  if (pair.b >= 0) contact.first_b = rows.first_velocity[static_cast<std::size_t>(pair.b)];
  contact.size_a = pair.a < 0 ? 0 : problem.block_size(pair.a);
  contact.size_b = pair.b < 0 ? 0 : problem.block_size(pair.b);
  contact.shape = shape_of(pair, contact.size_a, contact.size_b);
  return contact;
}

static void place_islands(const ContactProblem& problem, PgsRows& rows) {
  const int rows_per_contact = rows.law == Law::frictionless ? 1 : 3;
  std::vector<char> listed(static_cast<std::size_t>(problem.num_blocks()), 0);
  Eigen::Index coefficients = 0;
  for (const auto& members : find_islands(problem)) {
    PgsIsland island;
    island.first = static_cast<int>(rows.source.size());
    for (const int c : members) {
      for (const int k : {problem.pairs[static_cast<std::size_t>(c)].a, problem.pairs[static_cast<std::size_t>(c)].b}) {
        if (k < 0 || listed[static_cast<std::size_t>(k)] != 0) continue;
        listed[static_cast<std::size_t>(k)] = 1;
        island.blocks.push_back(k);
      }
      rows.contacts.push_back(place_contact(problem, rows, c));
      rows.contacts.back().rows = coefficients;
      coefficients += rows_per_contact * rows.contacts.back().stride();
      rows.source.push_back(c);
    }
    island.last = static_cast<int>(rows.source.size());
    rows.islands.push_back(std::move(island));
  }
  rows.coefficients.resize(coefficients);
  rows.scales.resize(rows.contacts.size());
}

static void set_weights(const Mat3& w, Law law, double d, PgsContact& contact) {
  const double smallest = k_immovable_share * d;
  const auto weight = [&](double inverse_mass) {
    return inverse_mass > smallest ? 1 / inverse_mass : k_immovable_mass;
  };
  for (int i = 0; i < 3; ++i) contact.diagonal[i] = w(i, i);
  contact.coupling[0] = w(1, 0);
  contact.coupling[1] = w(2, 0);
  contact.coupling[2] = w(2, 1);
  contact.weight[0] = contact.compliance > 0 ? 1 / (w(0, 0) + contact.compliance) : weight(w(0, 0));
  contact.unanswerable = contact.weight[0] == k_immovable_mass && std::isinf(contact.force_limit);
  if (contact.unanswerable) contact.weight[0] = 0;
  const double larger = std::max(w(1, 1), w(2, 2));
  contact.weight[1] = weight(law == Law::coulomb ? larger : w(1, 1));
  contact.weight[2] = weight(law == Law::coulomb ? larger : w(2, 2));
}

/// Copies one contact's rows and responses to their place.
static void copy_rows(const ContactProblem& problem, int c, const double* response, int row_count,
                      const PgsContact& contact, double* out) {
  const auto a = problem.jacobian_a(c), b = problem.jacobian_b(c);
  const Eigen::Index n_a = contact.size_a, n_b = contact.size_b;
  const double* const response_b = response + 3 * n_a;
  for (int i = 0; i < row_count; ++i) {
    out = std::copy_n(a.data() + i * n_a, n_a, out);
    out = std::copy_n(b.data() + i * n_b, n_b, out);
    out = std::copy_n(response + i * n_a, n_a, out);
    out = std::copy_n(response_b + i * n_b, n_b, out);
  }
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

static void fill_contact(const ContactProblem& problem, const MassInverse& masses, const VecX& guess, PgsRows& rows,
                         std::size_t place, double* response) {
  PgsContact& contact = rows.contacts[place];
  const int c = rows.source[place];
  const auto i = static_cast<std::size_t>(c);
  const auto first = 3 * static_cast<Eigen::Index>(c);
  const Mat3 w = delassus_block(problem, masses, c, response);
  const double d = inverse_mass_scale(w);
  rows.scales[place] = contact_scale(problem, c, d);
  contact.mu = problem.mu[i];
  contact.force_limit = problem.force_limit[i];
  contact.compliance = problem.compliance[i];
  Eigen::Map<Vec3>{contact.w} = problem.w.segment<3>(first);
  set_weights(w, rows.law, d, contact);
  copy_rows(problem, c, response, rows.law == Law::frictionless ? 1 : 3, contact,
            rows.coefficients.data() + contact.rows);
  if (guess.size() > 0) set_impulse(guess.segment<3>(first), rows.law, contact);
}

static bool all_finite(const PgsRows& rows) {
  double sum = rows.velocities.sum();
  for (const auto& contact : rows.contacts) {
    for (int i = 0; i < 3; ++i) sum += contact.w[i] + contact.diagonal[i] + contact.r[i];
    sum += contact.mu + contact.compliance;
    if (std::isnan(contact.force_limit)) return false;
  }
  return std::isfinite(sum);
}

static void set_velocities(const ContactProblem& problem, const MassInverse& masses, PgsRows& rows, int threads) {
  parallel_for(problem.num_blocks(), threads, [&](std::ptrdiff_t k) {
    const auto i = static_cast<std::size_t>(k);
    masses.apply(static_cast<int>(k), problem.f.data() + problem.block_offset[i],
                 rows.velocities.data() + rows.first_velocity[i]);
  });
  rows.finite = all_finite(rows);
  for (const auto& contact : rows.contacts) apply_impulse(contact, rows);
}

PgsRows make_pgs_rows(const ContactProblem& problem, const MassInverse& masses, const VecX& guess, int threads) {
  PgsRows rows;
  rows.law = problem.law;
  place_velocities(problem, rows);
  place_islands(problem, rows);
  // one scratch area per chunk; the chunks do not depend on the number of threads
  constexpr std::ptrdiff_t chunk = 256;
  const auto count = static_cast<std::ptrdiff_t>(rows.contacts.size());
  const std::size_t scratch = largest_response(problem);
  parallel_for((count + chunk - 1) / chunk, threads, [&](std::ptrdiff_t k) {
    std::vector<double> response(scratch);
    for (std::ptrdiff_t place = k * chunk; place < std::min(count, (k + 1) * chunk); ++place)
      fill_contact(problem, masses, guess, rows, static_cast<std::size_t>(place), response.data());
  });
  set_velocities(problem, masses, rows, threads);
  return rows;
}

}  // namespace nilas
