#include "contact/measure/measure.h"

#include <cmath>
#include <vector>

#include "contact/law/cone.h"
#include "contact/law/law_map.h"
#include "contact/law/moment_cone.h"
#include "contact/problem/local_problem.h"
#include "contact/problem/operators.h"
#include "contact/problem/row_of.h"
#include "core/base/error.h"
#include "core/base/parallel.h"

namespace nilas::contact {

/// Contacts slower than this do not count as sliding: ten times the default tolerance of solvers [m/s].
constexpr double k_slide_speed = 1e-5;

/// Keeps the larger; once NaN, always NaN.
static void keep_worst(double& worst, double x) {
  if (!(x <= worst) && !std::isnan(worst)) worst = x;
}

/// Closing speed that the law does not allow: at its force limit a contact may close, which is crushing.
static double forbidden_closing(const ContactScale& scale, double r_n, double u_n) {
  if (u_n >= 0) return 0;
  return std::isinf(scale.force_limit) ? -u_n : std::min(-u_n, scale.d * std::max(0.0, scale.force_limit - r_n));
}

static double complementarity(const ContactScale& scale, double r_n, double u_n) {
  const bool crushing = u_n < 0 && std::isfinite(scale.force_limit);
  return std::abs((crushing ? scale.force_limit - r_n : r_n) * u_n);
}

/// u.r + mu |u_T| r_N, plus the work of crushing at the limit: zero when the law holds, else positive.
static double bipotential(const ContactScale& scale, const Vec3& r, const Vec3& u, double slip) {
  const bool crushing = u[0] < 0 && std::isfinite(scale.force_limit);
  return u.dot(r) + scale.mu * slip * r[0] - (crushing ? scale.force_limit * u[0] : 0);
}

static double slip_angle_deg(const Vec3& r, const Vec3& u, double slip) {
  if (slip <= k_slide_speed || r[0] <= 0) return 0;
  const double friction = tangential_norm(r);
  if (friction == 0) return 0;
  const double along = -(r[1] * u[1] + r[2] * u[2]);
  const double across = r[1] * u[2] - r[2] * u[1];
  return std::atan2(std::abs(across), along) / k_deg;
}

static double creep(const ContactScale& scale, const Vec3& r, double slip) {
  const double bound = scale.mu * r[0];
  if (bound <= 0) return 0;
  return slip * std::max(0.0, 1 - tangential_norm(r) / bound);
}

/// The natural-map residuals of one contact for three laws [m/s].
struct Maps {
  double law = 0, natural = 0, ccp = 0;
};

static Maps maps_of(Law asked, int facets, const ContactScale& scale, const Vec3& r, const Vec3& u) {
  const double natural = natural_map(scale, r, u), ccp = ccp_map(scale, r, u);
  const double law = asked == Law::coulomb ? natural : asked == Law::ccp ? ccp : law_map(asked, facets, scale, r, u);
  return {law, natural, ccp};
}

/// What one contact adds to sums. Added up in the order of the contacts, they give the same bits for any number of
/// threads.
struct Shares {
  double natural_squared = 0, bipotential = 0, of_moment = 0;
};

static Shares measure_contact(const Maps& maps, const ContactScale& scale, const Vec3& r, const Vec3& u,
                              Residuals& out) {
  const double slip = tangential_norm(u);
  keep_worst(out.law_map_m_s, maps.law);
  keep_worst(out.natural_map_m_s, maps.natural);
  keep_worst(out.ccp_map_m_s, maps.ccp);
  keep_worst(out.penetration_rate_m_s, forbidden_closing(scale, r[0], u[0]));
  keep_worst(out.complementarity_J, complementarity(scale, r[0], u[0]));
  keep_worst(out.cone_violation_m_s, scale.d * std::max(0.0, tangential_norm(r) - scale.mu * r[0]));
  keep_worst(out.slip_angle_deg, slip_angle_deg(r, u, slip));
  keep_worst(out.creep_m_s, creep(scale, r, slip));
  return {maps.natural * maps.natural, bipotential(scale, r, u, slip)};
}

/// Adds a moment to the residuals of its contact, except those of the maps. Returns what it adds to the bipotential.
static double measure_moment(const ContactScale& scale, double r_n, const Vec3& r, const Vec3& u, Residuals& out) {
  const double largest = std::max(std::abs(r[0]), tangential_norm(r));
  keep_worst(out.cone_violation_m_s, scale.d * std::max(0.0, largest - r_n));
  return u.dot(r) + (std::abs(u[0]) + tangential_norm(u)) * r_n;
}

/// Keeps the worst of two parts of a problem.
static void keep_worst_of(const Residuals& part, Residuals& out) {
  for (const auto worst : {&Residuals::law_map_m_s, &Residuals::natural_map_m_s, &Residuals::ccp_map_m_s,
                           &Residuals::penetration_rate_m_s, &Residuals::complementarity_J,
                           &Residuals::cone_violation_m_s, &Residuals::slip_angle_deg, &Residuals::creep_m_s})
    keep_worst(out.*worst, part.*worst);
}

static void add_shares(const Shares& shares, Residuals& out) {
  out.natural_map_rms_m_s += shares.natural_squared;
  out.bipotential_J += shares.bipotential;
  out.bipotential_J += shares.of_moment;
}

/// Measures contact c, which is no moment, with its moment if it has one.
static Shares measure_with_moment(const PreparedProblem& prepared, int c, const VecX& r, const VecX& v,
                                  Residuals& out) {
  const ContactProblem& problem = prepared.problem();
  const Vec3 r_c = r.segment<3>(row_of(c));
  const ContactScale scale = contact_scale(problem, c, prepared.inverse_mass_scales()[c]);
  const Vec3 u = compliant_velocity(problem, c, r_c, contact_velocity(problem, c, v.data()));
  const int m = problem.moment_of(c);
  if (m < 0) return measure_contact(maps_of(problem.law, problem.facets, scale, r_c, u), scale, r_c, u, out);
  const ForceAndMoment r_all{r_c, r.segment<3>(row_of(m))};
  const ForceAndMoment u_all{u, contact_velocity(problem, m, v.data())};
  Shares shares = measure_contact(
      {law_map(problem.law, scale, r_all, u_all), natural_map(scale, r_all, u_all), ccp_map(scale, r_all, u_all)},
      scale, r_c, u, out);
  shares.of_moment = measure_moment(scale, r_c[0], r_all.moment, u_all.moment, out);
  return shares;
}

/// |diag(M)^-1/2 (M v - f - H r)|; `excess` holds -f - H r on entry.
static double momentum_residual(const ContactProblem& problem, const VecX& v, VecX& excess) {
  double sum = 0;
  for (int k = 0; k < problem.num_blocks(); ++k) {
    const auto mass = problem.mass(k);
    const int first = problem.block_offset[k];
    auto block = excess.segment(first, mass.rows());
    block += mass.lazyProduct(v.segment(first, mass.rows()));
    sum += (block.array().square() / mass.diagonal().array()).sum();
  }
  return std::sqrt(sum);
}

Residuals measure(const PreparedProblem& prepared, const VecX& r, const VecX& v, int threads) {
  const ContactProblem& problem = prepared.problem();
  const std::ptrdiff_t count = problem.num_contacts();
  NILAS_DEMAND(r.size() == 3 * count && v.size() == problem.num_velocities());
  Residuals out;
  VecX excess = -problem.f;
  const auto add_up = [&](int c, const Shares& shares) {
    add_impulse(problem, c, -r.segment<3>(row_of(c)), excess.data());
    add_shares(shares, out);
  };
  const auto shares_of = [&](int c, Residuals& worst) {
    return problem.is_moment(c) ? Shares{} : measure_with_moment(prepared, c, r, v, worst);
  };
  if (threads == 1) {  // one pass, which reads the rows of a contact once
    for (int c = 0; c < problem.num_contacts(); ++c) add_up(c, shares_of(c, out));
  } else {
    std::vector<Shares> shares(static_cast<std::size_t>(count));
    std::vector<Residuals> worst(static_cast<std::size_t>(num_chunks(count)));
    parallel_chunks(count, k_chunk, threads, [&](std::ptrdiff_t chunk, std::ptrdiff_t first, std::ptrdiff_t last) {
      Residuals of_chunk;
      for (auto c = static_cast<int>(first); c < last; ++c) shares[c] = shares_of(c, of_chunk);
      worst[chunk] = of_chunk;
    });
    for (const Residuals& of_chunk : worst) keep_worst_of(of_chunk, out);
    for (int c = 0; c < problem.num_contacts(); ++c) add_up(c, shares[c]);
  }
  if (problem.num_contacts() > 0) out.natural_map_rms_m_s = std::sqrt(out.natural_map_rms_m_s / problem.num_points());
  out.momentum_sqrtJ = momentum_residual(problem, v, excess);
  return out;
}

/// law_map of contact c, which is no moment [m/s].
static double law_map_of(const PreparedProblem& prepared, int c, const VecX& r, const VecX& v) {
  const ContactProblem& problem = prepared.problem();
  const Vec3 r_c = r.segment<3>(row_of(c));
  const ContactScale scale = contact_scale(problem, c, prepared.inverse_mass_scales()[c]);
  const Vec3 u = compliant_velocity(problem, c, r_c, contact_velocity(problem, c, v.data()));
  const int m = problem.moment_of(c);
  if (m < 0) return law_map(problem.law, problem.facets, scale, r_c, u);
  return law_map(problem.law, scale, {r_c, r.segment<3>(row_of(m))}, {u, contact_velocity(problem, m, v.data())});
}

double largest_law_map(const PreparedProblem& prepared, const VecX& r, int threads) {
  const ContactProblem& problem = prepared.problem();
  const std::ptrdiff_t count = problem.num_contacts();
  const VecX v = velocities(prepared, r);
  std::vector<double> worst_of(static_cast<std::size_t>(num_chunks(count)), 0.0);
  parallel_chunks(count, k_chunk, threads, [&](std::ptrdiff_t chunk, std::ptrdiff_t first, std::ptrdiff_t last) {
    double worst = 0;
    for (auto c = static_cast<int>(first); c < last; ++c)
      if (!problem.is_moment(c)) keep_worst(worst, law_map_of(prepared, c, r, v));
    worst_of[chunk] = worst;
  });
  double worst = 0;
  for (const double of_chunk : worst_of) keep_worst(worst, of_chunk);
  return worst;
}

Residuals measure(const PreparedProblem& prepared, const VecX& r) {
  return measure(prepared, r, velocities(prepared, r));
}

Residuals measure(const ContactProblem& problem, const VecX& r, const VecX& v) {
  return measure(PreparedProblem(problem), r, v);
}

Residuals measure(const PreparedProblem& prepared, const VecX& r, const VecX& v, std::vector<double>& d, int threads) {
  const ContactProblem& problem = prepared.problem();
  d.clear();
  for (int c = 0; c < problem.num_contacts(); ++c)
    d.push_back(problem.is_moment(c) ? 0 : contact_scale(problem, c, prepared.inverse_mass_scales()[c]).d);
  return measure(prepared, r, v, threads);
}

Residuals measure(const LocalProblem& problem, const VecX& r) {
  const VecX velocity = contact_velocities(problem, r);
  Residuals out;
  for (int c = 0; c < problem.num_contacts(); ++c) {
    const auto first = row_of(c);
    const ContactScale scale = contact_scale(problem, c);
    const Vec3 r_c = r.segment<3>(first);
    const Vec3 u = compliant_velocity(problem, c, r_c, velocity.segment<3>(first));
    add_shares(measure_contact(maps_of(problem.law, problem.facets, scale, r_c, u), scale, r_c, u, out), out);
  }
  if (problem.num_contacts() > 0) out.natural_map_rms_m_s = std::sqrt(out.natural_map_rms_m_s / problem.num_contacts());
  return out;
}

Residuals measure(const ContactProblem& problem, const VecX& r) { return measure(PreparedProblem(problem), r); }

const std::vector<NamedResidual>& residual_columns() {
  static const std::vector<NamedResidual> columns{
      {"law_map_m_s", &Residuals::law_map_m_s},
      {"natural_map_m_s", &Residuals::natural_map_m_s},
      {"natural_map_rms_m_s", &Residuals::natural_map_rms_m_s},
      {"ccp_map_m_s", &Residuals::ccp_map_m_s},
      {"penetration_rate_m_s", &Residuals::penetration_rate_m_s},
      {"complementarity_J", &Residuals::complementarity_J},
      {"cone_violation_m_s", &Residuals::cone_violation_m_s},
      {"slip_angle_deg", &Residuals::slip_angle_deg},
      {"creep_m_s", &Residuals::creep_m_s},
      {"bipotential_J", &Residuals::bipotential_J},
      {"momentum_sqrtJ", &Residuals::momentum_sqrtJ},
  };
  return columns;
}

}  // namespace nilas::contact
