#include "contact/solvers/newton/interior_point.h"

#include <algorithm>
#include <cmath>

#include "contact/problem/row_of.h"

namespace nilas::solvers {

namespace {

/// Share of the distance to the boundary that a step takes; the rest keeps the next scaling finite.
constexpr double k_step_share = 0.99;
/// A cone cut at its apex has no inside: limits count as at least this share of the largest velocity.
constexpr double k_least_cap = 1e-10;
/// Steps shorter than this gain less than a factorisation costs.
constexpr double k_shortest_step = 1e-4;
/// Iterations without the gap falling to k_gap_fall of its best: rounding has won.
constexpr int k_patience = 5;
constexpr double k_gap_fall = 0.7;

VecX slopes(const MassScaled& problem) {
  VecX slope(3 * problem.num_contacts());
  for (int a = 0; a < problem.num_contacts(); ++a) {
    const double mu = problem.mu[a];
    slope.segment<3>(contact::row_of(a)) = mu > 1 ? Vec3(1 / mu, 1, 1) : Vec3(1, mu, mu);
  }
  return slope;
}

/// Returns the caps of x_0.
VecX caps(const MassScaled& problem, const VecX& slope) {
  const double least = k_least_cap * problem.q.cwiseAbs().maxCoeff();
  VecX cap(problem.num_contacts());
  for (int a = 0; a < problem.num_contacts(); ++a) cap[a] = std::max(problem.cap[a], least) / slope[contact::row_of(a)];
  return cap;
}

/// A point that rounding put on the boundary goes back by a hair.
void keep_inside(Eigen::Ref<VecX> x, const VecX& fallback) {
  constexpr double hair = 4e-16;
  for (Eigen::Index i = 0; i < x.size(); i += 3) {
    const double t = contact::tangential_norm(x.segment<3>(i));
    if (x[i] <= t * (1 + hair)) x[i] = t * (1 + 2 * hair);
    if (!(x[i] > 0)) x.segment<3>(i) = 0.01 * fallback.segment<3>(i);
  }
}

}  // namespace

InteriorPoint::InteriorPoint(const MassScaled& problem)
    : problem_(problem),
      slope_(slopes(problem)),
      cap_(caps(problem, slope_)),
      a_(slope_.asDiagonal() * problem.symmetric * slope_.asDiagonal()),
      factor_(a_) {}

bool InteriorPoint::has_cap(int a) const { return std::isfinite(cap_[a]); }

InteriorIterate InteriorPoint::cold_start(const VecX& b) const {
  const int nc = problem_.num_contacts();
  const double size = std::max(b.cwiseAbs().maxCoeff(), std::numeric_limits<double>::min());
  InteriorIterate start{VecX::Zero(3 * nc), VecX::Zero(3 * nc), VecX::Ones(nc), VecX::Zero(nc)};
  for (int a = 0; a < nc; ++a) {
    start.x[contact::row_of(a)] = start.z[contact::row_of(a)] = size;
    if (!has_cap(a)) continue;
    start.x[contact::row_of(a)] = std::min(size, 0.5 * cap_[a]);
    start.slack[a] = cap_[a] - start.x[contact::row_of(a)];
    start.multiplier[a] = size;
  }
  return start;
}

InteriorIterate InteriorPoint::shifted(const InteriorIterate& iterate, double distance) const {
  InteriorIterate inside = iterate;
  for (int a = 0; a < problem_.num_contacts(); ++a) {
    inside.x[contact::row_of(a)] += distance;
    inside.z[contact::row_of(a)] += distance;
    if (!has_cap(a)) continue;
    inside.slack[a] += distance;
    inside.multiplier[a] += distance;
  }
  return inside;
}

VecX InteriorPoint::impulses(const InteriorIterate& iterate) const { return slope_.cwiseProduct(iterate.x); }

NesterovTodd InteriorPoint::scaling_at(const InteriorIterate& at, int a) const {
  const Vec3 x = at.x.segment<3>(contact::row_of(a)), z = at.z.segment<3>(contact::row_of(a));
  if (has_tangent(a)) return nesterov_todd(x, z);
  // tangents of a half line get the unit matrix: their rows of A and of every right side are zero
  const double p = std::sqrt(z[0] / x[0]);
  return {Vec3(p, 1, 1).asDiagonal(), Vec3(1 / p, 1, 1).asDiagonal(), Vec3(p * x[0], 0, 0)};
}

bool InteriorPoint::factor(const InteriorIterate& at) {
  const int nc = problem_.num_contacts();
  nt_.clear();
  std::vector<Mat3> inverse, added;
  for (int a = 0; a < nc; ++a) {
    nt_.push_back(scaling_at(at, a));
    inverse.push_back(nt_.back().inverse);
    added.push_back(Mat3::Identity());
    const Vec3 normal = inverse.back().col(0);
    if (has_cap(a)) added.back() += at.multiplier[a] / at.slack[a] * normal * normal.transpose();
  }
  return factor_.factor(inverse, added);
}

double InteriorPoint::gap(const InteriorIterate& at) const {
  int pairs = problem_.num_contacts();
  for (int a = 0; a < problem_.num_contacts(); ++a) pairs += has_cap(a) ? 1 : 0;
  return (at.x.dot(at.z) + at.slack.dot(at.multiplier)) / pairs;
}

double InteriorPoint::gap_after(const InteriorIterate& at, const Direction& d, double step) const {
  return gap(moved(at, d, step));
}

InteriorPoint::Right InteriorPoint::predictor(const InteriorIterate& at) const {
  Right right{VecX(at.x.size()), -at.slack.cwiseProduct(at.multiplier)};
  for (int a = 0; a < problem_.num_contacts(); ++a) right.g.segment<3>(contact::row_of(a)) = -nt_[a].scaled;
  return right;
}

InteriorPoint::Right InteriorPoint::corrector(const InteriorIterate& at, const Direction& affine, double target) const {
  Right right = predictor(at);
  for (int a = 0; a < problem_.num_contacts(); ++a) {
    const Vec3& scaled = nt_[a].scaled;
    const Vec3 change = target * Vec3::UnitX() - jordan_product(affine.x.segment<3>(contact::row_of(a)),
                                                                affine.z.segment<3>(contact::row_of(a)));
    right.g.segment<3>(contact::row_of(a)) +=
        has_tangent(a) ? jordan_quotient(change, scaled) : Vec3(change[0] / scaled[0], 0, 0);
    if (has_cap(a)) right.line[a] += target - affine.slack[a] * affine.multiplier[a];
  }
  return right;
}

InteriorPoint::Direction InteriorPoint::direction(const InteriorIterate& at, const VecX& scaled_b,
                                                  const Right& right) const {
  const int nc = problem_.num_contacts();
  const VecX residual = a_ * at.x + scaled_b - at.z;  // of z = A x + S b + m n, but for m n
  VecX rhs(at.x.size()), excess = VecX::Zero(nc);
  for (int a = 0; a < nc; ++a) {
    Vec3 other = residual.segment<3>(contact::row_of(a));
    if (has_cap(a)) {
      excess[a] = at.x[contact::row_of(a)] + at.slack[a] - cap_[a];
      other[0] += at.multiplier[a] + (right.line[a] + at.multiplier[a] * excess[a]) / at.slack[a];
    }
    rhs.segment<3>(contact::row_of(a)) = right.g.segment<3>(contact::row_of(a)) - nt_[a].inverse * other;
  }
  Direction d;
  d.x = factor_.solve(rhs);
  d.z = right.g - d.x;
  d.slack = d.multiplier = VecX::Zero(nc);
  for (int a = 0; a < nc; ++a) {
    if (!has_cap(a)) continue;
    d.slack[a] = -excess[a] - nt_[a].inverse.row(0).dot(d.x.segment<3>(contact::row_of(a)));
    d.multiplier[a] = (right.line[a] - at.multiplier[a] * d.slack[a]) / at.slack[a];
  }
  return d;
}

double InteriorPoint::longest_step(const InteriorIterate& at, const Direction& d) const {
  double step = std::numeric_limits<double>::infinity();
  const auto on_line = [&](double s, double ds) {
    if (ds < 0) step = std::min(step, -s / ds);
  };
  for (int a = 0; a < problem_.num_contacts(); ++a) {
    const Vec3& scaled = nt_[a].scaled;
    for (const VecX* const part : {&d.x, &d.z}) {
      if (has_tangent(a))
        step = std::min(step, step_to_boundary(scaled, part->segment<3>(contact::row_of(a))));
      else
        on_line(scaled[0], (*part)[contact::row_of(a)]);
    }
    on_line(at.slack[a], d.slack[a]);
    on_line(at.multiplier[a], d.multiplier[a]);
  }
  return step;
}

InteriorIterate InteriorPoint::moved(const InteriorIterate& at, const Direction& d, double step) const {
  InteriorIterate next{at.x, at.z, at.slack + step * d.slack, at.multiplier + step * d.multiplier};
  for (int a = 0; a < problem_.num_contacts(); ++a) {
    const NesterovTodd& nt = nt_[a];
    next.x.segment<3>(contact::row_of(a)) += step * (nt.inverse * d.x.segment<3>(contact::row_of(a)));
    next.z.segment<3>(contact::row_of(a)) += step * (nt.scaling * d.z.segment<3>(contact::row_of(a)));
  }
  return next;
}

InteriorPoint::Outcome InteriorPoint::minimise(const VecX& b, double tolerance, const Budget& budget,
                                               InteriorIterate& iterate) {
  const VecX scaled_b = slope_.cwiseProduct(b);
  const auto map_of = [&](const InteriorIterate& point) {
    const VecX r = impulses(point);
    return convex_map(problem_, r, problem_.symmetric * r + b);
  };
  InteriorIterate now = iterate;
  Outcome out;
  out.map_m_s = std::numeric_limits<double>::infinity();
  double least_gap = gap(now);
  int since_fall = 0;
  while (out.map_m_s > tolerance && since_fall < k_patience && budget.allows(out.iterations)) {
    if (!factor(now)) break;
    const Direction affine = direction(now, scaled_b, predictor(now));
    const double before = gap(now);
    const double reach = std::min(1.0, longest_step(now, affine));
    const double centring = std::pow(std::clamp(gap_after(now, affine, reach) / before, 0.0, 1.0), 3);
    const Direction full = direction(now, scaled_b, corrector(now, affine, centring * before));
    const double step = std::min(1.0, k_step_share * longest_step(now, full));
    ++out.iterations;
    if (!full.x.allFinite() || !full.z.allFinite()) break;
    now = moved(now, full, step);
    keep_inside(now.x, iterate.x);
    keep_inside(now.z, iterate.z);
    const double map = map_of(now);
    since_fall = gap(now) < k_gap_fall * least_gap ? 0 : since_fall + (step < k_shortest_step ? k_patience : 1);
    least_gap = std::min(least_gap, gap(now));
    if (map <= out.map_m_s) {
      out.map_m_s = map;
      iterate = now;
    }
  }
  out.finite = std::isfinite(out.map_m_s);
  return out;
}

}  // namespace nilas::solvers
