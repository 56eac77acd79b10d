#include "contact/solvers/shared/row_residual.h"

#include <algorithm>
#include <cmath>

#include "contact/law/moment_cone.h"
#include "contact/problem/operators.h"
#include "contact/problem/row_of.h"
#include "core/base/parallel.h"

namespace nilas::solvers {

/// Closing slower than this is rounding where nothing can move [m/s].
constexpr double k_closing_speed = 1e-9;

static const PgsContact& moment_of(const PgsRows& rows, const PgsContact& contact) {
  return rows.contacts[contact.moment];
}

static int moment_source(const PgsRows& rows, const PgsContact& contact) { return rows.source[contact.moment]; }

/// law_map of the contact at a place of the rows; 0 for a moment, which is judged with its contact.
double RowResidual::law_map_of(const PgsRows& rows, std::size_t place) const {
  const PgsContact& contact = rows.contacts[place];
  if (contact.bound_by >= 0) return 0;
  const int c = rows.source[place];
  const Vec3 r = Eigen::Map<const Vec3>(contact.r);
  const Vec3 u = contact::compliant_velocity(problem_, c, r, contact::contact_velocity(problem_, c, v_.data()));
  if (contact.moment < 0) return nilas::contact::law_map(problem_.law, problem_.facets, rows.scales[place], r, u);
  return nilas::contact::law_map(problem_.law, rows.scales[place],
                                 {r, Eigen::Map<const Vec3>(moment_of(rows, contact).r)},
                                 {u, contact::contact_velocity(problem_, moment_source(rows, contact), v_.data())});
}

double RowResidual::law_map(const PgsRows& rows, const PgsIsland& island) {
  set_velocities(rows, island);
  const std::ptrdiff_t count = island.last - island.first;
  const auto graver = [](double map, double worst) { return !(map <= worst) && !std::isnan(worst) ? map : worst; };
  std::vector<double> worst_of(static_cast<std::size_t>(num_chunks(count)), 0.0);
  parallel_chunks(count, k_chunk, count >= k_large_island ? threads_ : 1,
                  [&](std::ptrdiff_t chunk, std::ptrdiff_t first, std::ptrdiff_t last) {
                    double worst = 0;
                    for (std::ptrdiff_t k = first; k < last; ++k)
                      worst = graver(law_map_of(rows, static_cast<std::size_t>(island.first + k)), worst);
                    worst_of[chunk] = worst;
                  });
  double worst = 0;
  for (const double of_chunk : worst_of) worst = graver(of_chunk, worst);
  return worst;
}

void RowResidual::set_velocities(const PgsRows& rows, const PgsIsland& island) {
  for (const int k : island.blocks) {
    const int first = problem_.block_offset[k];
    momentum_.segment(first, problem_.block_size(k)) = problem_.f.segment(first, problem_.block_size(k));
  }
  for (int k = island.first; k < island.last; ++k) {
    const auto i = static_cast<std::size_t>(k);
    contact::add_impulse(problem_, rows.source[i], Eigen::Map<const Vec3>(rows.contacts[i].r), momentum_.data());
  }
  for (const int k : island.blocks) {
    const int first = problem_.block_offset[k];
    masses_.apply(k, momentum_.data() + first, v_.data() + first);
  }
}

void RowResidual::correct(PgsRows& rows, const PgsIsland& island) const {
  for (const int k : island.blocks) set_block_velocities(masses_, k, momentum_.data() + problem_.block_offset[k], rows);
}

RowResidual::Culprit RowResidual::find_culprit(const PgsRows& rows, const PgsIsland& island, double tolerance) {
  for (int k = island.first; k < island.last; ++k) {
    const auto i = static_cast<std::size_t>(k);
    if (!rows.contacts[i].unanswerable) continue;
    set_velocities(rows, island);
    const double u_n = contact::contact_velocity(problem_, rows.source[i], v_.data())[0];
    if (u_n < -std::max(k_closing_speed, tolerance)) return {rows.source[i], -u_n};
  }
  return {};
}

std::string find_culprit(const contact::LocalProblem& problem, const VecX& r, double tolerance) {
  VecX u;
  for (int c = 0; c < problem.num_contacts(); ++c) {
    const auto i = static_cast<std::size_t>(c);
    const Mat3& w = problem.diagonal(c);
    if (w(0, 0) > k_immovable_share * w.trace() || problem.compliance[i] > 0 || std::isfinite(problem.force_limit[i]))
      continue;
    if (u.size() == 0) u = contact::contact_velocities(problem, r);
    const double u_n = u[contact::row_of(c)];
    if (u_n < -std::max(k_closing_speed, tolerance)) return closing_message(c, problem.key[i], -u_n);
  }
  return "";
}

std::string closing_message(int contact, std::uint64_t key, double speed) {
  return "contact " + std::to_string(contact) + " (key " + std::to_string(key) + ") closes at " +
         std::to_string(speed) + " m/s, but neither side can move and it has no force limit";
}

}  // namespace nilas::solvers
