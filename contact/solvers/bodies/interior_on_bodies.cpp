#include "contact/solvers/bodies/interior_on_bodies.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "contact/law/cone.h"
#include "contact/law/law_map.h"
#include "contact/problem/row_of.h"
#include "core/base/error.h"

namespace nilas::solvers {

namespace {

/// Share of the distance to the boundary that a step takes.
constexpr double k_share_to_boundary = 0.99;
constexpr int k_most_interior = 100;
constexpr double k_least_centring = 1e-3;
/// A cone cut at its apex has no inside: limits count as at least this share of the largest impulse to stop a contact.
constexpr double k_least_limit = 1e-10;

/// An impulse above its limit begins at this share of the limit: most that are above it stay near it.
constexpr double k_share_of_limit = 0.9;

/// So many steps in a row that are shorter than this tell that a run is stuck: longer ones hardly ever follow.
constexpr int k_stuck_steps = 4;
constexpr double k_stuck = 0.05;

std::vector<double> friction_of(const contact::ContactProblem& problem) {
  if (problem.law == Law::frictionless) return std::vector<double>(problem.mu.size(), 0.0);
  return problem.mu;
}

/// (Q^-1 + k n n^T)^-1 for Q = T^2, T^2 = square (2 w w^T - J) with the first column `first`. Each entry is a sum of
/// terms of one sign: Q itself less what k takes from it would lose all digits where k is large.
Mat3 stiffened(double square, const Vec3& first, double k) {
  const double yield = 1 / (1 + k * first[0]), t = contact::tangential_norm(first);
  const Vec2 e = t > 0 ? Vec2(first.tail<2>() / t) : Vec2(1, 0);
  Mat3 out;
  out.col(0) = yield * first;
  out.row(0) = out.col(0).transpose();
  const double along = square / first[0] * square;
  out.bottomRightCorner<2, 2>() = square * Vec2(-e[1], e[0]) * Vec2(-e[1], e[0]).transpose() +
                                  (along + t * t / first[0] * yield) * e * e.transpose();
  return out;
}

}  // namespace

InteriorOnBodies::InteriorOnBodies(const contact::PreparedProblem& island, const BodyIsland& bodies,
                                   const NodePlan& plan)
    : island_(island),
      problem_(island.problem()),
      bodies_(bodies),
      plan_(plan),
      cholesky_(bodies, plan),
      along_1_(bodies.num_contacts()),
      along_2_(bodies.num_contacts()),
      count_(static_cast<std::size_t>(bodies.num_contacts())),
      friction_(friction_of(island.problem())),
      limit_of_(count_, -1),
      x_(count_),
      y_(count_),
      u_(count_),
      r_y_(count_),
      g_(count_),
      work_(count_),
      other_(count_),
      scaling_(count_),
      g_matrix_(count_),
      z_(bodies.free_motion()),
      r_z_(z_.size()) {
  double fastest = 0;
  bodies_.relative_velocities(bodies_.free_motion(), u_);
  for (std::size_t c = 0; c < count_; ++c) fastest = std::max(fastest, (u_.at(c) + bodies_.prescribed().at(c)).norm());
  for (std::size_t c = 0; c < count_; ++c) {
    const double mu = friction_[c];
    slope_n_.push_back(mu > 1 ? 1 / mu : 1);
    slope_t_.push_back(std::min(mu, 1.0));
    const bool capped = std::isfinite(problem_.force_limit[c]);
    if (capped || problem_.compliance[c] > 0) soft_.push_back(static_cast<int>(c));
    if (!capped) continue;
    limit_of_[c] = static_cast<int>(capped_.size());
    capped_.push_back(static_cast<int>(c));
    const double least = k_least_limit * fastest / island_.inverse_mass_scales()[c];
    cap_.push_back(std::max(problem_.force_limit[c], least) / slope_n_[c]);
  }
  slack_.resize(capped_.size());
  multiplier_.resize(capped_.size());
  line_.resize(capped_.size());
}

VecX InteriorOnBodies::impulses() const {
  VecX r(contact::row_of(static_cast<Eigen::Index>(count_)));
  for_contacts([&](ContactRange range) {
    for (std::size_t c = range.first; c < range.last; ++c) {
      const Vec3 x = x_.at(c);
      r.segment<3>(contact::row_of(c)) = Vec3(slope_n_[c] * x[0], slope_t_[c] * x[1], slope_t_[c] * x[2]);
    }
  });
  return r;
}

/// The contacts of a range with a limit or compliance.
std::span<const int> InteriorOnBodies::soft_in(ContactRange range) const {
  const auto first = std::lower_bound(soft_.begin(), soft_.end(), static_cast<int>(range.first));
  return {first, std::lower_bound(first, soft_.end(), static_cast<int>(range.last))};
}

/// z of the impulses of x, and its compliant velocities.
void InteriorOnBodies::find_motion(NodeVector& z, ContactVectors& u) {
  for_contacts([&](ContactRange range) {
    for (std::size_t c = range.first; c < range.last; ++c) {
      work_.row[0][c] = slope_n_[c] * x_.row[0][c];
      work_.row[1][c] = slope_t_[c] * x_.row[1][c];
      work_.row[2][c] = slope_t_[c] * x_.row[2][c];
    }
  });
  z = bodies_.free_motion();
  bodies_.add_impulses(work_, z);
  for_contacts([&](ContactRange range) {
    bodies_.relative_velocities(z, u, range.first, range.last);
    for (std::size_t c = range.first; c < range.last; ++c) {
      u.row[0][c] += bodies_.prescribed().row[0][c] + problem_.compliance[c] * work_.row[0][c];
      u.row[1][c] += bodies_.prescribed().row[1][c];
      u.row[2][c] += bodies_.prescribed().row[2][c];
    }
  });
}

/// The largest residual of the law, with a held shift of its convex law, for the velocities that the impulses of x
/// give, and r_z.
double InteriorOnBodies::find_map() {
  find_motion(r_z_, other_);
  for (std::size_t k = 0; k < z_.size(); ++k)
    for (int i = 0; i < k_node_width; ++i) r_z_[k].value[i] = z_[k].value[i] - r_z_[k].value[i];
  const auto graver = [](double worst, double map) { return !(map <= worst) && !std::isnan(worst) ? map : worst; };
  const auto worst_of = [&](ContactRange range) {
    double worst = 0;
    for (std::size_t c = range.first; c < range.last; ++c) {
      const Vec3 x = x_.at(c), r(slope_n_[c] * x[0], slope_t_[c] * x[1], slope_t_[c] * x[2]);
      const contact::ContactScale scale{friction_[c], problem_.force_limit[c], island_.inverse_mass_scales()[c]};
      Vec3 u = other_.at(c);
      if (!held_.empty()) u[0] += held_[c];
      worst = graver(worst, contact::law_map(held_.empty() ? problem_.law : Law::ccp, problem_.facets, scale, r, u));
    }
    return worst;
  };
  return reduce_contacts(0.0, worst_of, graver);
}

/// r_y and the slope of the shift.
void InteriorOnBodies::find_off() {
  const bool shifts = problem_.law == Law::coulomb;
  for_contacts([&](ContactRange range) {
    for (std::size_t c = range.first; c < range.last; ++c) {
      const double mu = friction_[c], sn = slope_n_[c], st = slope_t_[c];
      const Vec3 u = u_.at(c);
      const double t = contact::tangential_norm(u), shift = !held_.empty() ? held_[c] : shifts ? mu * t : 0;
      const double slope = shifts && t > 0 ? settings_.slope_share * sn * mu / t : 0;
      along_1_[c] = slope * u[1];
      along_2_[c] = slope * u[2];
      r_y_.row[0][c] = y_.row[0][c] - sn * (u[0] + shift);
      r_y_.row[1][c] = y_.row[1][c] - st * u[1];
      r_y_.row[2][c] = y_.row[2][c] - st * u[2];
    }
  });
  for (std::size_t i = 0; i < capped_.size(); ++i) r_y_.row[0][capped_[i]] -= multiplier_[i];
}

/// Sets x to impulses, moved into the cones.
void InteriorOnBodies::place(const VecX& r) {
  for (std::size_t c = 0; c < count_; ++c) {
    const Vec3 in = contact::project_cone(r.segment<3>(contact::row_of(c)), friction_[c], problem_.force_limit[c]);
    const bool has_friction = friction_[c] > 0;
    x_.set(c, {in[0] / slope_n_[c], has_friction ? in[1] / slope_t_[c] : 0, has_friction ? in[2] / slope_t_[c] : 0});
  }
}

/// Sets the first iterate. Returns the residual of the start.
double InteriorOnBodies::begin(const VecX& start) {
  place(start);
  find_motion(z_, u_);
  const double map = find_map(), inside = settings_.inside * map;
  for (std::size_t c = 0; c < count_; ++c) {
    const double sn = slope_n_[c], st = slope_t_[c];
    const Vec3 u = u_.at(c);
    x_.row[0][c] += inside / island_.inverse_mass_scales()[c] / sn;
    y_.set(c, {sn * (friction_[c] * contact::tangential_norm(u) + std::max(u[0], 0.0) + inside), st * u[1], st * u[2]});
  }
  // the products of the limits begin where those of the cones are in the mean, so that neither cuts the first steps
  // short
  double mean = 0;
  for (std::size_t c = 0; c < count_; ++c) mean += x_.row[0][c] * y_.row[0][c] / static_cast<double>(count_);
  for (std::size_t i = 0; i < capped_.size(); ++i) {
    const std::size_t c = capped_[i];
    if (const double share = k_share_of_limit * cap_[i] / x_.row[0][c]; share < 1) x_.set(c, share * x_.at(c));
    slack_[i] = cap_[i] - x_.row[0][c];
    multiplier_[i] = mean / slack_[i];
    y_.row[0][c] += multiplier_[i];
  }
  find_motion(z_, u_);
  return map;
}

/// C of a contact.
double InteriorOnBodies::stiffness(std::size_t c) const {
  const double compliant = slope_n_[c] * slope_n_[c] * problem_.compliance[c];
  const int i = limit_of_[c];
  return i < 0 ? compliant : compliant + multiplier_[i] / slack_[i];
}

bool InteriorOnBodies::factor() {
  const bool is_full = settings_.shift == Shift::differentiated;
  const auto fill = [&](ContactRange range) {
    if (!scale(x_, y_, scaling_, range)) return false;
    fill_symmetric(range);
    if (is_full) fill_full(range);
    return true;
  };
  if (!reduce_contacts(char{1}, fill, [](char a, char b) { return static_cast<char>(a && b); })) return false;
  return is_full ? lu_->factor(g_full_) : cholesky_.factor(g_matrix_);
}

/// S Q' S
void InteriorOnBodies::fill_symmetric(ContactRange range) {
  auto& q = scaling_.squared.entry;
  for (const int c : soft_in(range)) {
    const Vec3 first(q[0][c], q[1][c], q[2][c]);
    const Mat3 soft = stiffened(scaling_.b[c] * scaling_.b[c], first, stiffness(c));
    const int place[6][2] = {{0, 0}, {1, 0}, {2, 0}, {1, 1}, {2, 1}, {2, 2}};
    for (std::size_t i = 0; i < 6; ++i) q[i][c] = soft(place[i][0], place[i][1]);
  }
  for (std::size_t c = range.first; c < range.last; ++c) {
    const double nn = slope_n_[c] * slope_n_[c], nt = slope_n_[c] * slope_t_[c], tt = slope_t_[c] * slope_t_[c];
    g_matrix_.entry[0][c] = nn * q[0][c];
    g_matrix_.entry[1][c] = nt * q[1][c];
    g_matrix_.entry[2][c] = nt * q[2][c];
    g_matrix_.entry[3][c] = tt * q[3][c];
    g_matrix_.entry[4][c] = tt * q[4][c];
    g_matrix_.entry[5][c] = tt * q[5][c];
  }
}

/// S Q' S' with the slope of the shift in the first row of S'
void InteriorOnBodies::fill_full(ContactRange range) {
  const auto& e = g_matrix_.entry;
  for (std::size_t c = range.first; c < range.last; ++c) {
    Mat3& g = g_full_[c];
    g << e[0][c], e[1][c], e[2][c], e[1][c], e[3][c], e[4][c], e[2][c], e[4][c], e[5][c];
    const Vec3 first = g.col(0) / slope_n_[c];
    g.col(1) += along_1_[c] * first;
    g.col(2) += along_2_[c] * first;
  }
}

/// The step for the right sides g and line.
void InteriorOnBodies::find_direction(Direction& d) {
  for_contacts([&](ContactRange range) {
    from_dual(scaling_, g_, r_y_, work_, range);
    for (const int c : soft_in(range)) work_.set(c, yielding(c, r_y_.at(c), 1).dx);
    for (std::size_t c = range.first; c < range.last; ++c) {
      work_.row[0][c] *= slope_n_[c];
      work_.row[1][c] *= slope_t_[c];
      work_.row[2][c] *= slope_t_[c];
    }
  });
  for (std::size_t k = 0; k < z_.size(); ++k)
    for (int i = 0; i < k_node_width; ++i) d.z[k].value[i] = -r_z_[k].value[i];
  bodies_.add_impulses(work_, d.z);
  if (settings_.shift == Shift::differentiated)
    lu_->solve(d.z);
  else
    cholesky_.solve(d.z);
  for_contacts([&](ContactRange range) { follow_motion(range, d); });
}

/// Sets the direction of a range of contacts from that of the nodes.
void InteriorOnBodies::follow_motion(ContactRange range, Direction& d) const {
  bodies_.relative_velocities(d.z, d.u, range.first, range.last);
  for (std::size_t c = range.first; c < range.last; ++c) {
    double dy_n = slope_n_[c] * d.u.row[0][c];
    if (settings_.shift == Shift::differentiated) dy_n += along_1_[c] * d.u.row[1][c] + along_2_[c] * d.u.row[2][c];
    d.y.row[0][c] = dy_n - r_y_.row[0][c];
    d.y.row[1][c] = slope_t_[c] * d.u.row[1][c] - r_y_.row[1][c];
    d.y.row[2][c] = slope_t_[c] * d.u.row[2][c] - r_y_.row[2][c];
  }
  to_primal(scaling_, g_, d.y, d.x, range);
  for (const int c : soft_in(range)) {
    const Yield yield = yielding(c, d.y.at(c), -1);
    d.x.set(c, yield.dx);
    d.y.row[0][c] += yield.dy_n;
    if (const int i = limit_of_[c]; i >= 0) {
      d.slack[i] = -yield.dx[0];
      d.multiplier[i] = (line_[i] - multiplier_[i] * d.slack[i]) / slack_[i];
    }
  }
}

/// Returns Q' (T^-1 g + sign a - l n) of a soft contact, l = line/s, and what its stiffness k and l add to dy_N. It is
/// T P (g + sign T a) - l P' v with v = T n, P = 1 - k v v^T/(1 + k v^T v) and P' = 1/(1 + k v^T v), where k and l may
/// be large and what is left of them small: no number appears that is larger than the result.
InteriorOnBodies::Yield InteriorOnBodies::yielding(std::size_t c, const Vec3& a, double sign) const {
  const double b = scaling_.b[c], k = stiffness(c);
  const Vec3 p = scaling_.p.at(c);
  const auto times = [&](const Vec3& x) -> Vec3 { return b * (2 * p.dot(x) * p - Vec3(x[0], -x[1], -x[2])); };
  const int i = limit_of_[c];
  const double l = i < 0 ? 0 : line_[i] / slack_[i];
  const Vec3 h = g_.at(c) + sign * times(a), v = times(Vec3::UnitX());
  const double square = v.squaredNorm(), share = 1 / (1 + k * square), along = v.dot(h) / square;
  const Vec3 rest = h - along * v;
  Vec3 dx = times(rest + share * (along - l) * v);
  dx[0] = share * (along - l) * square;
  return {dx, share * (k * square * along + l)};
}

double InteriorOnBodies::longest(const Direction& d) const {
  const auto least = [](double a, double b) { return std::min(a, b); };
  const auto of_range = [&](ContactRange range) {
    return std::min(longest_step(x_, d.x, range), longest_step(y_, d.y, range));
  };
  double t = reduce_contacts(1.0, of_range, least);
  for (std::size_t i = 0; i < capped_.size(); ++i) {
    if (d.slack[i] < 0) t = std::min(t, -slack_[i] / d.slack[i]);
    if (d.multiplier[i] < 0) t = std::min(t, -multiplier_[i] / d.multiplier[i]);
  }
  return t;
}

double InteriorOnBodies::gap(const Direction& d, double t) const {
  double sum = gap_after(x_, y_, d.x, d.y, t);
  for (std::size_t i = 0; i < capped_.size(); ++i)
    sum += (slack_[i] + t * d.slack[i]) * (multiplier_[i] + t * d.multiplier[i]);
  return sum;
}

/// Sets the right sides of the corrector.
void InteriorOnBodies::aim(const Direction& predictor, double target) {
  for_contacts([&](ContactRange range) { corrected(scaling_, predictor.x, predictor.y, target, g_, range); });
  for (std::size_t i = 0; i < capped_.size(); ++i)
    line_[i] = target - slack_[i] * multiplier_[i] - predictor.slack[i] * predictor.multiplier[i];
}

void InteriorOnBodies::move_by(const Direction& d, double t) {
  for_contacts([&](ContactRange range) {
    move(d.x, t, x_, range);
    move(d.y, t, y_, range);
    move(d.u, t, u_, range);
    for (const int c : soft_in(range)) u_.row[0][c] += t * problem_.compliance[c] * slope_n_[c] * d.x.row[0][c];
  });
  for (std::size_t k = 0; k < z_.size(); ++k)
    for (int i = 0; i < k_node_width; ++i) z_[k].value[i] += t * d.z[k].value[i];
  for (std::size_t i = 0; i < capped_.size(); ++i) {
    slack_[i] += t * d.slack[i];
    double& x = x_.row[0][capped_[i]];  // of two numbers with a given sum the smaller one has the digits
    if (slack_[i] < x)
      x = cap_[i] - slack_[i];
    else
      slack_[i] = cap_[i] - x;
    multiplier_[i] += t * d.multiplier[i];
  }
}

/// From now on steps take the share of the slope of the shift.
void InteriorOnBodies::take_slope() {
  settings_.shift = Shift::differentiated;
  if (lu_) return;
  lu_.emplace(bodies_, plan_);
  g_full_.resize(count_);
}

InteriorOnBodies::Outcome InteriorOnBodies::run(const VecX& start, double tolerance, const Budget& budget,
                                                const InteriorSettings& settings) {
  settings_ = settings;
  if (settings.shift == Shift::differentiated) take_slope();
  held_.clear();
  if (settings.shift == Shift::held) {
    NILAS_DEMAND(problem_.law == Law::coulomb);
    held_.assign(count_, 0.0);
    change_.assign(count_, 0.0);
    last_ = start;
  } else {
    begin(start);
  }
  return go_on(tolerance, budget);
}

InteriorOnBodies::Outcome InteriorOnBodies::go_on(double tolerance, const Budget& budget) {
  return held_.empty() ? iterate(tolerance, budget) : go_round(tolerance, budget);
}

/// Iterations from the present iterate.
InteriorOnBodies::Outcome InteriorOnBodies::iterate(double tolerance, const Budget& budget) {
  constexpr double infinity = std::numeric_limits<double>::infinity();
  Outcome best{impulses(), infinity, 0, {}};
  Direction d(count_, capped_.size(), z_.size());
  const auto pairs = static_cast<double>(count_ + capped_.size());
  double marked = infinity;
  int marked_at = 0, short_steps = 0;
  while (true) {
    const double map = find_map();
    if (best.iterations > 0) best.history.push_back(map);
    if (map < best.law_map_m_s) {
      best.law_map_m_s = map;
      best.r = impulses();
    }
    if (best.law_map_m_s < 0.5 * marked) {
      marked = best.law_map_m_s;
      marked_at = best.iterations;
    }
    if (settings_.shift == Shift::lagged && settings_.lagged_patience > 0 &&
        best.iterations - marked_at >= settings_.lagged_patience) {
      take_slope();
      marked = best.law_map_m_s;
      marked_at = best.iterations;
    }
    const bool waits = best.iterations - marked_at >= settings_.patience || best.iterations >= k_most_interior;
    if (!(map > tolerance) || waits || !budget.allows(best.iterations)) break;
    find_off();
    ++best.iterations;
    if (!factor()) break;
    const double before = gap(d, 0);
    for_contacts([&](ContactRange range) {
      for (std::size_t i = 0; i < 3; ++i)
        for (std::size_t c = range.first; c < range.last; ++c) g_.row[i][c] = -scaling_.scaled.row[i][c];
    });
    for (std::size_t i = 0; i < capped_.size(); ++i) line_[i] = -slack_[i] * multiplier_[i];
    find_direction(d);
    const double share = gap(d, longest(d)) / before;
    const double target = std::clamp(share * share * share, k_least_centring, 1.0) * before / pairs;
    aim(d, target);
    find_direction(d);
    const double step = longest(d);
    move_by(d, k_share_to_boundary * step);
    short_steps = step < k_stuck ? short_steps + 1 : 0;
    if (settings_.ends_when_stuck && short_steps == k_stuck_steps) break;
  }
  return best;
}

}  // namespace nilas::solvers
