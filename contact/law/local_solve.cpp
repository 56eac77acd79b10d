#include "contact/law/local_solve.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "contact/law/cone.h"

namespace nilas::contact {

namespace {

/// Share of the trace that stands for the motion of what cannot move; a few roundings, so that S + x I stays positive.
constexpr double k_least_motion = 1e-15;
/// A normal held by less than this share of the trace does not yield at all; rounding alone gives the square of 1e-16.
constexpr double k_immovable_share = 1e-20;
/// Bisections of a bracket of doubles that still change it.
constexpr int k_most_steps = 200;

/// Friction as a function of x: (S + x I) t = -s, n = n0 - g.t, with the friction bound mu n.
struct SlipLine {
  const double* matrix;  ///< S
  double s1, s2;
  double n0, g1, g2;
  double mu, x_min;
};

struct Slip {
  double n = 0, t1 = 0, t2 = 0;
  double x = 0;
  double excess = 0;      ///< mu n / |t| - 1
  double slope = 0;       ///< its derivative by x
  double e1 = 0, e2 = 0;  ///< -t'
};

Slip slip_at(const SlipLine& line, double x) {
  const double pivot = 1 / (line.matrix[0] + x);
  const double below = line.matrix[2] * pivot;
  const double last = 1 / (line.matrix[3] + x - below * line.matrix[1]);
  Slip slip;
  slip.x = x;
  slip.t2 = -(line.s2 - below * line.s1) * last;
  slip.t1 = -(line.s1 + line.matrix[1] * slip.t2) * pivot;
  slip.n = line.n0 - (line.g1 * slip.t1 + line.g2 * slip.t2);
  // t' = -(S + x I)^-1 t = -e
  const double e2 = slip.e2 = (slip.t2 - below * slip.t1) * last;
  const double e1 = slip.e1 = (slip.t1 - line.matrix[1] * e2) * pivot;
  const double inverse_square = 1 / (slip.t1 * slip.t1 + slip.t2 * slip.t2);
  const double share = line.mu * std::sqrt(inverse_square);
  slip.excess = share * slip.n - 1;
  slip.slope = share * (line.g1 * e1 + line.g2 * e2 + slip.n * (slip.t1 * e1 + slip.t2 * e2) * inverse_square);
  return slip;
}

/// The next x between the bracket's ends: Newton's, or one that halves the bracket, or one beyond while it is open.
double next_slip(const Slip& slip, double lo, double hi, double x_min, bool stick_tried) {
  const double newton = slip.x - slip.excess / slip.slope;
  if (newton > lo && newton < hi) return newton;
  if (newton <= x_min && !stick_tried) return x_min;
  if (std::isinf(hi)) return 4 * slip.x;
  return lo > 0 && hi > 4 * lo ? std::sqrt(lo) * std::sqrt(hi) : 0.5 * (lo + hi);
}

/// Newton's last step along the tangent.
void finish(const SlipLine& line, Slip& slip) {
  const double step = -slip.excess / slip.slope;
  slip.x += step;
  slip.t1 -= step * slip.e1;
  slip.t2 -= step * slip.e2;
  slip.n += step * (line.g1 * slip.e1 + line.g2 * slip.e2);
}

/// Sticking (x = x_min) if that is admissible, else the x > x_min with |t| = mu n.
Slip solve_slip(const SlipLine& line, double start, double nearly_root) {
  double lo = line.x_min, hi = std::numeric_limits<double>::infinity();
  bool stick_tried = false;
  Slip slip;
  if (line.s1 == 0 && line.s2 == 0) {
    slip.n = line.n0;
    return slip;
  }
  double x = std::max(start, line.x_min);
  for (int k = 0; k < k_most_steps; ++k) {
    slip = slip_at(line, x);
    if (x <= line.x_min) {
      stick_tried = true;
      if (slip.excess >= 0) return slip;
    }
    if (std::abs(slip.excess) <= nearly_root && slip.slope * slip.x > std::abs(slip.excess)) {
      finish(line, slip);
      return slip;
    }
    (slip.excess < 0 ? lo : hi) = x;
    const double next = next_slip(slip, lo, hi, line.x_min, stick_tried);
    if (std::abs(next - x) <= k_root_accuracy * x || !(next < std::numeric_limits<double>::max())) break;
    x = next;
  }
  // the bracket is as small as it can be: on the cone at least
  slip.n = std::sqrt(slip.t1 * slip.t1 + slip.t2 * slip.t2) / line.mu;
  return slip;
}

/// The impulse that sticks.
Vec3 stick(const ContactBlock& block, const SlipLine& line) {
  const double t2 = -(line.s2 - block.stick[1] * line.s1) * block.stick[2];
  const double t1 = -(line.s1 + block.schur[1] * t2) * block.stick[0];
  return {line.n0 - (line.g1 * t1 + line.g2 * t2), t1, t2};
}

bool sticks(const Vec3& r, double mu) { return r[0] >= 0 && r[1] * r[1] + r[2] * r[2] <= mu * mu * r[0] * r[0]; }

double normal_velocity(const ContactBlock& block, const Vec3& b, const Vec3& r) {
  return b[0] + block.nn * r[0] + block.nt[0] * r[1] + block.nt[1] * r[2];
}

Vec2 tangential_velocity(const ContactBlock& block, const Vec3& b, const Vec3& r) {
  return {b[1] + block.tn[0] * r[0] + block.tt[0] * r[1] + block.tt[1] * r[2],
          b[2] + block.tn[1] * r[0] + block.tt[2] * r[1] + block.tt[3] * r[2]};
}

/// r_T of the disc |r_T| <= mu r_N for a given r_N.
Vec3 disc_answer(const ContactBlock& block, const Vec3& b, double normal, ContactStart& start) {
  if (block.mu * normal <= 0) return {normal, 0, 0};
  const SlipLine line{block.tt,   b[1] + block.tn[0] * normal, b[2] + block.tn[1] * normal, normal, 0, 0, block.mu,
                      block.x_min};
  const Slip slip = solve_slip(line, start.slip, k_nearly_root);
  start.slip = slip.x;
  return {normal, slip.t1, slip.t2};
}

/// Both rows clamped to +-bound: every state of (below, between, above) is tried.
Vec3 square_answer(const ContactBlock& block, const Vec3& b, double normal) {
  const double bound = block.mu * normal;
  const double s1 = b[1] + block.tn[0] * normal, s2 = b[2] + block.tn[1] * normal;
  const double p = block.tt[0] + block.x_min, q = block.tt[3] + block.x_min;
  const double det = p * q - block.tt[1] * block.tt[2];
  Vec3 best(normal, 0, 0);
  double least = std::numeric_limits<double>::infinity();
  const auto consider = [&](double t1, double t2) {
    t1 = std::clamp(t1, -bound, bound);
    t2 = std::clamp(t2, -bound, bound);
    const double u1 = s1 + p * t1 + block.tt[1] * t2, u2 = s2 + block.tt[2] * t1 + q * t2;
    const double e1 = t1 - std::clamp(t1 - u1 / p, -bound, bound), e2 = t2 - std::clamp(t2 - u2 / q, -bound, bound);
    const double miss = e1 * e1 * p + e2 * e2 * q;
    if (miss >= least) return;
    least = miss;
    best = {normal, t1, t2};
  };
  consider((-s1 * q + s2 * block.tt[1]) / det, (-s2 * p + s1 * block.tt[2]) / det);
  for (const double side : {-bound, bound}) {
    consider(side, -(s2 + block.tt[2] * side) / q);
    consider(-(s1 + block.tt[1] * side) / p, side);
  }
  return best;
}

/// Polygon of `facets` corners: the facets are tried outwards from the one that the disc's answer points at.
class PolygonAnswer {
 public:
  PolygonAnswer(const ContactBlock& block, const Vec3& b, double normal, int facets)
      : normal_(normal), facets_(facets), radius_(block.mu * normal) {
    s_ = {b[1] + block.tn[0] * normal, b[2] + block.tn[1] * normal};
    matrix_ << block.tt[0] + block.x_min, block.tt[1], block.tt[2], block.tt[3] + block.x_min;
  }

  Vec3 find(const Vec3& disc) {
    if (radius_ <= 0) return {normal_, 0, 0};
    const double width = 2 * k_pi / facets_;
    const Vec2 free = -matrix_.inverse() * s_;
    if (pyramid_width(free) <= radius_ * std::cos(0.5 * width)) return {normal_, free[0], free[1]};
    const int first = static_cast<int>(std::floor(std::atan2(disc[2], disc[1]) / width));
    for (int step = 0; step <= facets_ / 2 && least_ > 0; ++step) {
      try_facet((first + step) * width, width);
      if (step > 0) try_facet((first - step) * width, width);
    }
    return {normal_, best_[0], best_[1]};
  }

 private:
  /// Largest outward distance along any facet's normal.
  double pyramid_width(const Vec2& t) const {
    const double width = 2 * k_pi / facets_;
    const double angle = (std::floor(std::atan2(t[1], t[0]) / width) + 0.5) * width;
    return std::cos(angle) * t[0] + std::sin(angle) * t[1];
  }

  /// The facet between the corners at `angle` and `angle + width`: rest along it, or the corner it pushes to.
  void try_facet(double angle, double width) {
    const Vec2 from(radius_ * std::cos(angle), radius_ * std::sin(angle));
    const Vec2 to(radius_ * std::cos(angle + width), radius_ * std::sin(angle + width));
    const Vec2 along = to - from;
    const double where = std::clamp(-along.dot(matrix_ * from + s_) / along.dot(matrix_ * along), 0.0, 1.0);
    const Vec2 t = where == 1 ? to : Vec2(from + where * along);
    const Vec2 push = -(matrix_ * t + s_);
    // t answers the polygon when no corner lies farther along the push
    const double miss = radius_ * pyramid_support(push, facets_) - push.dot(t);
    const double rounding =
        8 * std::numeric_limits<double>::epsilon() * radius_ * (s_.norm() + matrix_.norm() * radius_);
    const double counted = miss <= rounding ? 0 : miss;
    if (counted >= least_) return;
    least_ = counted;
    best_ = t;
  }

  double normal_;
  int facets_;
  double radius_;
  Vec2 s_;
  Eigen::Matrix2d matrix_;
  Vec2 best_ = Vec2::Zero();
  double least_ = std::numeric_limits<double>::infinity();
};

/// Root of f, which is negative at 0 and rises: secants between the ends of a bracket, each end's weight halved when it
/// stays (Illinois), bisection when that is slow. Ends at `limit` when f is negative up to there; 0 when no root is
/// found.
template <class Function>
double rising_root(const Function& f, double f_zero, double guess, double limit, double rounding) {
  double lo = 0, f_lo = f_zero, hi = std::min(guess, limit), f_hi = f(hi);
  for (int k = 0; f_hi < 0; ++k) {
    if (hi >= limit) return limit;
    if (k == k_most_steps) return 0;
    lo = hi;
    f_lo = f_hi;
    hi = std::min(2 * hi, limit);
    f_hi = f(hi);
  }
  for (int k = 0; k < k_most_steps && f_hi > rounding; ++k) {
    const bool bisect = k % 8 == 7;
    double x = bisect ? 0.5 * (lo + hi) : lo - f_lo * (hi - lo) / (f_hi - f_lo);
    if (!(x > lo && x < hi)) x = 0.5 * (lo + hi);
    if (!(x > lo && x < hi)) break;
    const double y = f(x);
    if (std::abs(y) <= rounding) return x;
    if (y < 0) {
      lo = x;
      f_lo = y;
      if (k % 2 == 1) f_hi *= 0.5;
    } else {
      hi = x;
      f_hi = y;
      f_lo *= 0.5;
    }
  }
  return hi;
}

/// r_T for given r_N, then the r_N whose `velocity` is zero.
template <class Section, class Velocity>
Vec3 solve_by_normal(const ContactBlock& block, const Vec3& b, double guess, const Section& section,
                     const Velocity& velocity) {
  const auto f = [&](double normal) { return velocity(section(normal)); };
  const double yielding = std::max(block.nn, block.x_min / k_least_motion);
  const double first = guess > 0 ? guess : std::max(std::abs(b[0]), block.mu * b.tail<2>().norm()) / yielding;
  const double rounding = k_root_accuracy * b.norm();
  return section(rising_root(f, velocity(Vec3(Vec3::Zero())), first, block.force_limit, rounding));
}

Vec3 solve_ccp(const ContactBlock& block, const Vec3& b, ContactStart& start) {
  if (b[0] >= block.mu * std::hypot(b[1], b[2])) return Vec3::Zero();
  return solve_by_normal(
      block, b, start.normal, [&](double normal) { return disc_answer(block, b, normal, start); },
      [&](const Vec3& r) { return normal_velocity(block, b, r) - block.mu * tangential_velocity(block, b, r).norm(); });
}

Vec3 solve_frictionless(const ContactBlock& block, double b_n) {
  return {std::min(-b_n * block.inverse_nn, block.force_limit), 0, 0};
}

/// Coulomb where the free answer is beyond the limit.
Vec3 solve_at_limit(const ContactBlock& block, const Vec3& b, ContactStart& start) {
  const auto section = [&](double normal) { return disc_answer(block, b, normal, start); };
  return solve_by_normal(block, b, block.force_limit, section,
                         [&](const Vec3& r) { return normal_velocity(block, b, r); });
}

Vec3 solve_pyramid(Law law, int facets, const ContactBlock& block, const Vec3& b, ContactStart& start) {
  const auto section = [&](double normal) -> Vec3 {
    if (law == Law::pyramid) return square_answer(block, b, normal);
    const Vec3 disc = disc_answer(block, b, normal, start);
    return PolygonAnswer(block, b, normal, facets).find(disc);
  };
  return solve_by_normal(block, b, start.normal, section, [&](const Vec3& r) { return normal_velocity(block, b, r); });
}

}  // namespace

ContactBlock::ContactBlock(const Mat3& w, double friction, double limit, double compliance,
                           double tangential_compliance)
    : nn(w(0, 0) + compliance), mu(friction), force_limit(limit) {
  const double trace = w.trace();
  x_min = k_least_motion * (trace > 0 ? trace : compliance);
  if (nn > k_immovable_share * trace) inverse_nn = 1 / nn;
  for (int i = 0; i < 2; ++i) {
    nt[i] = w(0, i + 1);
    tn[i] = w(i + 1, 0);
  }
  for (int i = 0; i < 2; ++i)
    for (int j = 0; j < 2; ++j) {
      tt[2 * i + j] = w(i + 1, j + 1) + (i == j ? tangential_compliance : 0);
      schur[2 * i + j] = tt[2 * i + j] - tn[i] * nt[j] * inverse_nn;
    }
  stick[0] = 1 / (schur[0] + x_min);
  stick[1] = schur[2] * stick[0];
  stick[2] = 1 / (schur[3] + x_min - stick[1] * schur[1]);
}

Vec3 solve_coulomb(const ContactBlock& block, const Vec3& b, ContactStart& start, double nearly_root) {
  if (!(b[0] < 0)) return Vec3::Zero();
  if (block.mu == 0) return solve_frictionless(block, b[0]);
  const double lift = -b[0] * block.inverse_nn;
  const SlipLine line{block.schur,
                      b[1] + block.tn[0] * lift,
                      b[2] + block.tn[1] * lift,
                      lift,
                      block.nt[0] * block.inverse_nn,
                      block.nt[1] * block.inverse_nn,
                      block.mu,
                      block.x_min};
  if (start.slip <= block.x_min) {
    const Vec3 r = stick(block, line);
    if (r[0] <= block.force_limit && sticks(r, block.mu)) return r;
  }
  const Slip slip = solve_slip(line, start.slip, nearly_root);
  if (slip.n > block.force_limit) return solve_at_limit(block, b, start);
  start.slip = slip.x;
  return {slip.n, slip.t1, slip.t2};
}

Vec3 solve_contact(Law law, int facets, const ContactBlock& block, const Vec3& b, ContactStart& start) {
  if (law != Law::ccp && !(b[0] < 0)) return Vec3::Zero();
  if (block.inverse_nn == 0) {
    if (!(b[0] < 0) || std::isinf(block.force_limit)) return Vec3::Zero();
    if (block.x_min == 0) return {block.force_limit, 0, 0};
  }
  Vec3 r = Vec3::Zero();
  if (law == Law::coulomb)
    r = block.inverse_nn == 0 ? disc_answer(block, b, block.force_limit, start) : solve_coulomb(block, b, start);
  else if (law == Law::frictionless || block.mu == 0)
    r = block.inverse_nn == 0 ? Vec3(block.force_limit, 0, 0)
                              : Vec3(std::max(solve_frictionless(block, b[0])[0], 0.0), 0, 0);
  else if (law == Law::ccp)
    r = solve_ccp(block, b, start);
  else
    r = solve_pyramid(law, facets, block, b, start);
  start.normal = r[0];
  return r;
}

Vec2 solve_disc(const ContactBlock& block, const Vec2& free, double radius, ContactStart& start) {
  if (radius <= 0) return Vec2::Zero();
  const SlipLine line{block.tt, free[0], free[1], radius, 0, 0, 1, block.x_min};
  const Slip slip = solve_slip(line, start.slip, k_nearly_root);
  start.slip = slip.x;
  return {slip.t1, slip.t2};
}

Vec3 solve_moment(const ContactBlock& block, const Vec3& b, double normal, const Vec3& old, bool boxes,
                  ContactStart& start) {
  const double n = std::max(normal, 0.0);
  const double spin = std::clamp(-(b[0] + block.nt[0] * old[1] + block.nt[1] * old[2]) * block.inverse_nn, -n, n);
  const Vec2 free(b[1] + block.tn[0] * spin, b[2] + block.tn[1] * spin);
  if (!boxes) {
    const Vec2 roll = solve_disc(block, free, n, start);
    return {spin, roll[0], roll[1]};
  }
  const double first = std::clamp(-(free[0] + block.tt[1] * old[2]) / (block.tt[0] + block.x_min), -n, n);
  const double second = std::clamp(-(free[1] + block.tt[2] * first) / (block.tt[3] + block.x_min), -n, n);
  return {spin, first, second};
}

}  // namespace nilas::contact
