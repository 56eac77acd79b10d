#include "contact/solvers/shared/nsgs_sweep.h"

#include <algorithm>
#include <cmath>

#include "contact/solvers/shared/contact_sides.h"
#include "core/base/parallel.h"

namespace nilas::solvers {

namespace {

/// Exact Coulomb has its own path, all other laws share one.
enum class Path { coulomb, ccp, other };

/// (d |dr|)^2
template <Path path, int NA, int NB>
double visit(PgsContact& c, NsgsContact& own, const double* coefficients, double* velocities, Law law, int facets) {
  const Sides<NA, NB> sides(c, coefficients, velocities);
  Vec3 u(sides.velocity(0) + c.w[0] + c.compliance * c.r[0], 0, 0);
  if (path != Path::ccp && u[0] >= 0 && c.r[0] == 0) return 0;
  const bool normal_only = law == Law::frictionless;
  if (!normal_only) {
    u[1] = sides.velocity(1) + c.w[1] + c.tangential_compliance * c.r[1];
    u[2] = sides.velocity(2) + c.w[2] + c.tangential_compliance * c.r[2];
  }
  const Vec3 old(c.r[0], c.r[1], c.r[2]);
  const Vec3 b = own.block.without(old, u);
  const Vec3 r = contact::solve_in_sweep(path == Path::coulomb ? Law::coulomb : law, facets, own.block, b, own.start);
  const Vec3 change = r - old;
  const double square = change.squaredNorm();
  if (square == 0) return 0;
  if (normal_only)
    sides.apply_normal(change[0]);
  else
    sides.apply(change[0], change[1], change[2]);
  for (int i = 0; i < 3; ++i) c.r[i] = r[i];
  return own.d * own.d * square;
}

template <Path path>
double visit_any(PgsContact& c, NsgsContact& own, const double* coefficients, double* velocities, Law law, int facets) {
  switch (c.shape) {
    case PgsShape::six_six:
      return visit<path, 6, 6>(c, own, coefficients, velocities, law, facets);
    case PgsShape::six_none:
      return visit<path, 6, 0>(c, own, coefficients, velocities, law, facets);
    case PgsShape::none_six:
      return visit<path, 0, 6>(c, own, coefficients, velocities, law, facets);
    case PgsShape::general:
      return visit<path, k_any, k_any>(c, own, coefficients, velocities, law, facets);
  }
  return 0;
}

/// The moment of a contact with this normal impulse; (d |dr|)^2.
double visit_moment(PgsContact& c, NsgsContact& own, double normal, const double* coefficients, double* velocities,
                    bool boxes) {
  const Sides<k_any, k_any> sides(c, coefficients, velocities);
  Vec3 u;
  for (int i = 0; i < 3; ++i) u[i] = sides.velocity(i) + c.w[i];
  const Vec3 old(c.r[0], c.r[1], c.r[2]);
  const Vec3 r = contact::solve_moment(own.block, own.block.without(old, u), normal, old, boxes, own.start);
  const Vec3 change = r - old;
  sides.apply(change[0], change[1], change[2]);
  for (int i = 0; i < 3; ++i) c.r[i] = r[i];
  return own.d * own.d * change.squaredNorm();
}

/// Contacts [first, last) in turn; the largest (d |dr|)^2.
template <Path path>
double visit_in_turn(PgsRows& rows, std::vector<NsgsContact>& blocks, int island_first, int first, int last, int facets,
                     bool backward) {
  const double* const coefficients = rows.coefficients.data();
  double* const velocities = rows.velocities.data();
  double largest = 0;
  for (int k = first; k < last; ++k) {
    const auto i = static_cast<std::size_t>(backward ? first + last - 1 - k : k);
    NsgsContact& own = blocks[i - static_cast<std::size_t>(island_first)];
    PgsContact& contact = rows.contacts[i];
    const double change = contact.bound_by < 0
                              ? visit_any<path>(contact, own, coefficients, velocities, rows.law, facets)
                              : visit_moment(contact, own, rows.contacts[contact.bound_by].r[0], coefficients,
                                             velocities, rows.law == Law::pyramid);
    if (!(change <= largest)) largest = change;
  }
  return largest;
}

/// Runs that one thread visits in one go: few, so that a colour can be shared out evenly.
constexpr std::ptrdiff_t k_runs = 16;

/// The runs of one colour at once; as above.
template <Path path>
double visit_colour(PgsRows& rows, const PgsIsland& island, std::vector<NsgsContact>& blocks, std::size_t colour,
                    int facets, bool backward, int threads) {
  const std::ptrdiff_t begin = island.colours[colour], count = island.colours[colour + 1] - begin;
  std::vector<double> changes(static_cast<std::size_t>(num_chunks(count, k_runs)), 0.0);
  parallel_chunks(count, k_runs, threads, [&](std::ptrdiff_t chunk, std::ptrdiff_t first, std::ptrdiff_t last) {
    const auto from = static_cast<std::size_t>(begin + first), to = static_cast<std::size_t>(begin + last);
    changes[chunk] =
        visit_in_turn<path>(rows, blocks, island.first, island.runs[from], island.runs[to], facets, backward);
  });
  double largest = 0;
  for (const double change : changes)
    if (!(change <= largest)) largest = change;
  return largest;
}

template <Path path>
double sweep(PgsRows& rows, const PgsIsland& island, std::vector<NsgsContact>& blocks, int facets, bool backward,
             int threads) {
  const int first_in_turn = island.runs.empty() ? island.first : island.runs.back();
  const std::size_t colours = island.colours.empty() ? 0 : island.colours.size() - 1;
  double largest = 0;
  const auto keep = [&](double change) {
    if (!(change <= largest)) largest = change;
  };
  const auto in_turn = [&] {
    keep(visit_in_turn<path>(rows, blocks, island.first, first_in_turn, island.last, facets, backward));
  };
  if (backward) in_turn();
  for (std::size_t k = 0; k < colours; ++k)
    keep(visit_colour<path>(rows, island, blocks, backward ? colours - 1 - k : k, facets, backward, threads));
  if (!backward) in_turn();
  return std::sqrt(largest);
}

Mat3 block_of(const PgsContact& c, Law law) {
  Mat3 w = Mat3::Zero();
  w.diagonal() << c.diagonal[0], c.diagonal[1], c.diagonal[2];
  if (law == Law::frictionless) return w;
  w(1, 0) = w(0, 1) = c.coupling[0];
  w(2, 0) = w(0, 2) = c.coupling[1];
  w(2, 1) = w(1, 2) = c.coupling[2];
  return w;
}

}  // namespace

std::vector<NsgsContact> make_nsgs_contacts(const PgsRows& rows, const PgsIsland& island) {
  std::vector<NsgsContact> blocks;
  blocks.reserve(static_cast<std::size_t>(island.last - island.first));
  for (int k = island.first; k < island.last; ++k) {
    const PgsContact& c = rows.contacts[k];
    const Mat3 w = block_of(c, rows.law);
    blocks.push_back({contact::ContactBlock(w, c.mu, c.force_limit, c.compliance, c.tangential_compliance),
                      {0, c.r[0]},
                      w.trace() / 3});
  }
  return blocks;
}

double nsgs_sweep(PgsRows& rows, const PgsIsland& island, std::vector<NsgsContact>& blocks, int facets, bool backward,
                  int threads) {
  if (rows.law == Law::coulomb) return sweep<Path::coulomb>(rows, island, blocks, facets, backward, threads);
  if (rows.law == Law::ccp) return sweep<Path::ccp>(rows, island, blocks, facets, backward, threads);
  return sweep<Path::other>(rows, island, blocks, facets, backward, threads);
}

double visit_coulomb_run(PgsRows& rows, const PgsIsland& island, std::vector<NsgsContact>& blocks, int first, int last,
                         bool backward) {
  return visit_in_turn<Path::coulomb>(rows, blocks, island.first, first, last, 0, backward);
}

}  // namespace nilas::solvers
