/// Closed forms of small scenes that show the law, for every solver that takes it: the path of a sliding particle, a
/// rope around a drum, piles of round bodies at their critical friction, copies of a contact.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include "contact/registry.h"
#include "tests/support/problems/cone_problems.h"
#include "tests/support/problems/problem_changes.h"
#include "tests/support/test_name.h"

namespace nilas::solvers {
namespace artefacts_test {

constexpr double k_gravity = 9.81;
constexpr double k_step = 0.01;
constexpr double k_tolerance = 1e-12;
/// The tolerance times the condition of these problems [m/s]. Motion that must be distinguished from rest is 1e4 times
/// faster.
constexpr double k_same = 1e-10;

class Artefacts : public testing::TestWithParam<std::string> {
 protected:
  contact::ContactSolution solve(const contact::ContactProblem& problem) const {
    const auto solver = contact::find_solver(GetParam()).make({.tolerance = k_tolerance, .max_iterations = 1000000});
    contact::ContactSolution solution = solver->solve(problem, {});
    EXPECT_EQ(solution.status, contact::SolveStatus::converged) << solution.message;
    return solution;
  }

  /// Brute force takes only problems of few contacts.
  bool takes(const contact::ContactProblem& problem) const {
    return GetParam() != "enumerate" || problem.num_contacts() <= 8;
  }

  /// A particle slides on a level floor until it rests, with semi-implicit Euler. Returns its final position.
  Vec2 slide_to_rest(Law law, int facets, const Vec2& start, double mu) const {
    Vec3 v(0, start.x(), start.y());
    Vec2 x = Vec2::Zero();
    while (v.norm() > k_same) {
      contact::ContactProblem problem = test::particle(law, 7, mu, v - Vec3(k_step * k_gravity, 0, 0));
      problem.facets = facets;
      const Vec3 next = solve(problem).v;
      if (next.norm() >= v.norm()) {
        ADD_FAILURE() << "friction does not brake " << v.transpose();
        break;
      }
      v = next;
      x += k_step * v.tail<2>();
    }
    return x;
  }
};
class CoulombArtefacts : public Artefacts {};
class BoxArtefacts : public Artefacts {};
class PolygonArtefacts : public Artefacts {};

std::vector<std::string> solvers_of(Law law) {
  std::vector<std::string> names;
  for (const auto& entry : contact::solver_registry())
    if (std::find(entry.laws.begin(), entry.laws.end(), law) != entry.laws.end()) names.push_back(entry.name);
  return names;
}

constexpr double k_start = 5, k_sliding = 0.2;
/// Tolerance of a distance: 1e-12 m/s more in each of 250 steps of 0.01 s is 3e-10 m.
constexpr double k_same_way = 1e-9;

/// Braking distance of one row under its own friction: sum of h (v0 - k mu g h)+, which tends to v0^2 / (2 mu g).
double braking_way(double v0, double mu, double h = k_step) {
  double sum = 0;
  for (int k = 1; v0 - k * mu * k_gravity * h > 0; ++k) sum += h * (v0 - k * mu * k_gravity * h);
  return sum;
}

TEST(BrakingWay, TendsToTheTextbooks) {
  EXPECT_NEAR(braking_way(5, 0.2, 1e-4), 6.37080, 5e-6);
  EXPECT_NEAR(braking_way(5, 0.2, 1e-6), 25 / (2 * 0.2 * k_gravity), 5e-6);
  EXPECT_NEAR(braking_way(5 * std::cos(30 * k_deg), 0.2, 1e-5), 4.778, 5e-4);
  EXPECT_NEAR(braking_way(5 * std::sin(30 * k_deg), 0.2, 1e-5), 1.593, 5e-4);
}

TEST_P(CoulombArtefacts, DiscStopsStraightAheadInEveryDirection) {
  for (int azimuth = 0; azimuth < 360; azimuth += 75) {
    const Vec2 along(std::cos(azimuth * k_deg), std::sin(azimuth * k_deg));
    const Vec2 stop = slide_to_rest(Law::coulomb, 0, k_start * along, k_sliding);
    EXPECT_LT((stop - braking_way(k_start, k_sliding) * along).norm(), k_same_way) << azimuth;
  }
}

TEST_P(BoxArtefacts, EachRowOfTheBoxPyramidStopsForItself) {
  const Vec2 v0(k_start * std::cos(30 * k_deg), k_start * std::sin(30 * k_deg));
  const Vec2 stop = slide_to_rest(Law::pyramid, 0, v0, k_sliding);
  EXPECT_NEAR(stop.x(), braking_way(v0.x(), k_sliding), k_same_way);
  EXPECT_NEAR(stop.y(), braking_way(v0.y(), k_sliding), k_same_way);
}

TEST_P(PolygonArtefacts, DiamondStopsOnItsDiagonal) {
  // corners on the axes: v_x + v_y and v_x - v_y lose mu g h in each step, each until it is zero
  const Vec2 v0(k_start * std::cos(30 * k_deg), k_start * std::sin(30 * k_deg));
  const Vec2 stop = slide_to_rest(Law::pyramid_k, 4, v0, k_sliding);
  const double sum = braking_way(v0.x() + v0.y(), k_sliding), difference = braking_way(v0.x() - v0.y(), k_sliding);
  EXPECT_NEAR(stop.x(), (sum + difference) / 2, k_same_way);
  EXPECT_NEAR(stop.y(), (sum - difference) / 2, k_same_way);
}

TEST_P(PolygonArtefacts, FrictionReachesBothBoundsOfThePolygon) {
  // mu towards a corner; towards the middle of a side only mu cos(pi/k), and no corner that would turn the slip
  const double mu = 0.4, down = 1, speed = 5;
  for (const int k : {4, 8, 16})
    for (int half = 0; half < 2 * k; ++half) {
      const double phi = k_pi * half / k, friction = half % 2 == 0 ? mu : mu * std::cos(k_pi / k);
      const Vec3 along(0, std::cos(phi), std::sin(phi));
      contact::ContactProblem problem = test::particle(Law::pyramid_k, 1, mu, speed * along - Vec3(down, 0, 0));
      problem.facets = k;
      EXPECT_LT((solve(problem).v - (speed - friction * down) * along).norm(), k_same) << k << " " << phi;
    }
}

/// How a rope bends at one node on the drum.
struct Bend {
  double angle;
  double mu;

  /// Tension behind over tension before while it slides: (T2 - T1) cos(angle/2) = mu (T1 + T2) sin(angle/2).
  double ratio() const { return (1 + mu * std::tan(angle / 2)) / (1 - mu * std::tan(angle / 2)); }
};

std::vector<Bend> equal_bends(int count, double angle, double mu) {
  return std::vector<Bend>(static_cast<std::size_t>(count), Bend{angle / count, mu});
}

double product_of_ratios(const std::vector<Bend>& bends) {
  double product = 1;
  for (const Bend& bend : bends) product *= bend.ratio();
  return product;
}

/// A rope of point masses around a fixed drum. Contacts: each node with the drum; then each link between two nodes. A
/// link is frictionless and reversed: its gap is the length minus the distance of its nodes, r_N = h times its tension.
class Rope {
 public:
  static constexpr double k_mass = 0.1;    ///< Mass of a node [kg].
  static constexpr double k_tension = 10;  ///< Tension at the slack end [N].

  /// `speed`: speed of the links along themselves before the step [m/s].
  Rope(const std::vector<Bend>& bends, double speed) : bends_(bends) {
    double link = 0;
    for (int k = 0; k < num_nodes(); ++k) {
      const Bend& bend = bends[k];
      const double node = link + bend.angle / 2;
      problem_.add_block(k_mass * Mat3::Identity());
      problem_.f.tail<3>() = k_mass * node_speed(bend, speed) * along(node);
      touch(-1, k, Vec3(std::cos(node), std::sin(node), 0), bend.mu);
      link += bend.angle;
    }
    problem_.f.head<3>() -= k_step * k_tension * along(0);
    link = 0;
    for (int k = 0; k + 1 < num_nodes(); ++k) {
      link += bends[k].angle;
      touch(k, k + 1, -along(link), 0);
    }
    end_ = along(link + bends.back().angle);
  }

  /// Adds the pull at the tight end [N].
  void pull(double tension) { problem_.f.tail<3>() += k_step * tension * end_; }

  /// Adds a link by which a winch hauls in the tight end at this speed.
  void haul(double speed) {
    touch(num_nodes() - 1, -1, -end_, 0);
    problem_.w[3 * (problem_.num_contacts() - 1)] = -speed;
  }

  const contact::ContactProblem& problem() const { return problem_; }
  int num_nodes() const { return static_cast<int>(bends_.size()); }

  /// Speed of the links after a step from rest under this pull, when all nodes slip. At each, with s its speed, m s / h
  /// = (T2 - T1) cos(angle/2) - mu (T1 + T2) sin(angle/2).
  double slip_speed(double tension) const {
    double share_of_pull = 1, share_of_speed = 0;  // T = share_of_pull k_tension + share_of_speed speed
    for (const Bend& bend : bends_) {
      share_of_pull *= bend.ratio();
      share_of_speed =
          bend.ratio() * share_of_speed +
          k_mass * node_speed(bend, 1) / k_step / (std::cos(bend.angle / 2) - bend.mu * std::sin(bend.angle / 2));
    }
    return (tension - share_of_pull * k_tension) / share_of_speed;
  }

  /// Speed of a node along the drum, when its links move along themselves.
  static double node_speed(const Bend& bend, double speed) { return speed / std::cos(bend.angle / 2); }

 private:
  static Vec3 along(double angle) { return {-std::sin(angle), std::cos(angle), 0}; }

  void touch(int a, int b, const Vec3& n, double mu) {
    const MatX fixed(3, 0), rows = test::frame_of(n, 0.3).transpose();  // slip lies along neither tangent
    problem_.add_contact(a, a < 0 ? fixed : MatX(-rows), b, b < 0 ? fixed : rows, problem_.pairs.size() + 1);
    problem_.mu.back() = problem_.mu_static.back() = mu;
  }

  std::vector<Bend> bends_;
  contact::ContactProblem problem_;
  Vec3 end_;
};

const std::vector<std::vector<Bend>> k_ropes{
    equal_bends(1, 1.0, 0.3),
    equal_bends(4, k_pi, 0.3),
    {{0.3, 0.5}, {1.1, 0.1}, {0.7, 0}, {0.9, 0.8}},
    equal_bends(16, k_pi, 0.3),
};

TEST(Capstan, RatiosTendToTheExponential) {
  EXPECT_NEAR(product_of_ratios(equal_bends(4, k_pi, 0.3)), 2.71632, 5e-6);
  EXPECT_NEAR(product_of_ratios(equal_bends(16, k_pi, 0.3)), 2.57485, 5e-6);
  EXPECT_NEAR(product_of_ratios(equal_bends(100000, k_pi, 0.3)), std::exp(0.3 * k_pi), 1e-9);
}

TEST_P(CoulombArtefacts, RopeHauledAroundADrumGainsTheCapstansTension) {
  const double speed = 0.7;
  for (const auto& bends : k_ropes) {
    Rope rope(bends, speed);
    rope.haul(speed);
    if (!takes(rope.problem())) continue;
    const contact::ContactSolution s = solve(rope.problem());
    double tension = Rope::k_tension;
    for (int k = 0; k < rope.num_nodes(); ++k) {
      tension *= bends[k].ratio();
      EXPECT_NEAR(s.r[3 * (rope.num_nodes() + k)] / (k_step * tension), 1, 1e-9) << k << " of " << rope.num_nodes();
    }
    const double gained = s.r[s.r.size() - 3] / (k_step * Rope::k_tension);
    EXPECT_NEAR(gained / product_of_ratios(bends), 1, 1e-9);
  }
}

TEST_P(CoulombArtefacts, RopeHoldsBelowTheCapstansTensionAndSlipsAbove) {
  constexpr double k_margin = 1e-4;
  for (const auto& bends : k_ropes)
    for (const double margin : {-k_margin, k_margin}) {
      Rope rope(bends, 0);
      const double tension = (1 + margin) * product_of_ratios(bends) * Rope::k_tension;
      rope.pull(tension);
      // Many impulses hold a rope. Brute force tries only the least, which may leave the cone.
      if (!takes(rope.problem()) || (margin < 0 && GetParam() == "enumerate")) continue;
      const contact::ContactSolution s = solve(rope.problem());
      const double speed = margin < 0 ? 0 : rope.slip_speed(tension);
      ASSERT_TRUE(margin < 0 || speed > 1e4 * k_same);
      for (int k = 0; k < rope.num_nodes(); ++k)
        EXPECT_NEAR(s.v.segment<3>(3 * k).norm(), Rope::node_speed(bends[k], speed), k_same)
            << k << " of " << rope.num_nodes() << ", margin " << margin;
    }
}

/// Equal round bodies: some on the floor that touch each other, and one that lies on them. Each contact between a
/// support and the top bears N = 1/n of a weight, and needs friction N tan(lean/2) there and on the floor.
struct Pile {
  int supports;
  double lean;      ///< Angle of the lines of centres from the vertical.
  double gyration;  ///< moment of inertia over m R^2

  double critical_between() const { return std::tan(lean / 2); }
  double critical_on_floor() const { return std::tan(lean / 2) / (supports + 1); }
  Vec3 outward(int k) const {
    const double azimuth = 0.4 + 2 * k_pi * k / supports;
    return {std::cos(azimuth), std::sin(azimuth), 0};
  }
};
const Pile k_spheres{3, std::asin(1 / std::sqrt(3)), 0.4};
const Pile k_logs{2, 30 * k_deg, 0.5};
const Pile k_piles[] = {k_spheres, k_logs};

constexpr double k_mass = 2, k_radius = 0.5;
constexpr double k_weight = k_mass * k_gravity * k_step;  ///< Weight of one body times h.
constexpr double k_ample = 0.6;                           ///< Friction that holds the pile.
constexpr double k_share = 1e-4;  ///< Relative distance from the critical friction, on either side of it.

/// One step from rest. Contacts: supports with the floor, with the top, with each other.
contact::ContactProblem build(const Pile& pile, double mu_between, double mu_on_floor) {
  contact::ContactProblem problem;
  problem.h = k_step;
  std::vector<test::TestBody> bodies;
  const auto add = [&](const Vec3& p) {
    bodies.push_back({k_mass, k_mass * k_radius * k_radius * pile.gyration * Mat3::Identity(), p,
                      Vec3(0, 0, -k_gravity * k_step), Vec3::Zero()});
    test::add_body(problem, bodies.back());
  };
  const auto touch = [&](int a, int b, const Vec3& n, double mu) {
    const Vec3 point = bodies[b].p - k_radius * n;
    test::add_contact(problem, bodies, a, b, point, test::frame_of(n, 0.3), mu);  // slip lies along neither tangent
  };
  const auto direction = [&](int a, int b) -> Vec3 { return (bodies[b].p - bodies[a].p).normalized(); };
  const int top = pile.supports;
  for (int k = 0; k < top; ++k) add(2 * k_radius * std::sin(pile.lean) * pile.outward(k) + k_radius * Vec3::UnitZ());
  add((k_radius + 2 * k_radius * std::cos(pile.lean)) * Vec3::UnitZ());
  for (int k = 0; k < top; ++k) touch(-1, k, Vec3::UnitZ(), mu_on_floor);
  for (int k = 0; k < top; ++k) touch(k, top, direction(k, top), mu_between);
  for (int b = 0; b < top; ++b)
    for (int a = 0; a < b; ++a) touch(a, b, direction(a, b), mu_between);
  return problem;
}

/// Speed of the supports after the step, outward: they roll on the floor and slip under the top, which comes down
/// tan(lean) times as fast.
double rolling_out(const Pile& pile, double mu_between) {
  const double c = std::cos(pile.lean), s = std::sin(pile.lean), inertia = (1 + pile.gyration) * k_mass;
  const double push = s - mu_between * (1 + c);  // Push on a support's motion per unit of N.
  return k_weight / (k_mass * s / c + pile.supports * (c + mu_between * s) * inertia / push);
}

/// The same speed when they skid on the floor and roll under the top.
double skidding_out(const Pile& pile, double mu_on_floor) {
  const double c = std::cos(pile.lean), t = std::tan(pile.lean), n = pile.supports;
  // Drag of the floor, with that of the spin that it forces on the support.
  const double drag = mu_on_floor * (1 + 1 / c);
  // each support bears P = (k_weight - m speed t) / n of the top: (m + J / c^2) speed = P t - drag (k_weight + P)
  return (k_weight * (t - drag) / n - drag * k_weight) /
         (k_mass * (1 + pile.gyration / (c * c)) + k_mass * t * (t - drag) / n);
}

void expect_collapse(const Pile& pile, const VecX& v, double speed) {
  ASSERT_GT(speed, 1e4 * k_same);
  for (int k = 0; k < pile.supports; ++k)
    EXPECT_LT((v.segment<3>(6 * k) - speed * pile.outward(k)).norm(), k_same) << pile.supports << " supports";
  const Vec3 down(0, 0, -speed * std::tan(pile.lean));
  EXPECT_LT((v.segment<3>(6 * pile.supports) - down).norm(), k_same) << pile.supports << " supports";
}

TEST(PileOfRoundBodies, CriticalFriction) {
  EXPECT_NEAR(k_spheres.critical_between(), 0.317837, 5e-7);
  EXPECT_NEAR(k_spheres.critical_on_floor(), 0.079459, 5e-7);
  EXPECT_NEAR(k_logs.critical_between(), 0.267949, 5e-7);
  EXPECT_NEAR(k_logs.critical_on_floor(), 0.089316, 5e-7);
  for (const Pile& pile : k_piles) {
    EXPECT_NEAR(rolling_out(pile, pile.critical_between()), 0, 1e-15);
    EXPECT_NEAR(skidding_out(pile, pile.critical_on_floor()), 0, 1e-15);
  }
}

TEST_P(CoulombArtefacts, PileStandsJustAboveItsCriticalFriction) {
  for (const Pile& pile : k_piles) {
    const double between = (1 + k_share) * pile.critical_between(), floor = (1 + k_share) * pile.critical_on_floor();
    for (const auto& [mu_between, mu_on_floor] :
         {std::pair(between, k_ample), std::pair(k_ample, floor), std::pair(between, floor)}) {
      const contact::ContactProblem problem = build(pile, mu_between, mu_on_floor);
      if (!takes(problem)) continue;
      const contact::ContactSolution s = solve(problem);
      EXPECT_LT(s.v.cwiseAbs().maxCoeff(), k_same) << mu_between << " " << mu_on_floor;
      // The balance of moments determines the friction on the floor. The supports may press on each other with the
      // friction that is left.
      double on_top = 0;
      for (int k = 0; k < pile.supports; ++k) {
        EXPECT_NEAR(s.r[3 * k] / k_weight, 1 + 1.0 / pile.supports, 1e-9) << mu_between << " " << mu_on_floor;
        on_top += s.r[3 * (pile.supports + k)];
      }
      EXPECT_NEAR(on_top / k_weight, 1, k_share) << mu_between << " " << mu_on_floor;
    }
  }
}

TEST_P(CoulombArtefacts, PileRollsApartJustBelowItsCriticalFriction) {
  for (const Pile& pile : k_piles) {
    const double mu = (1 - k_share) * pile.critical_between();
    const contact::ContactProblem problem = build(pile, mu, k_ample);
    if (takes(problem)) expect_collapse(pile, solve(problem).v, rolling_out(pile, mu));
  }
}

TEST_P(CoulombArtefacts, PileSkidsApartJustBelowTheFloorsCriticalFriction) {
  for (const Pile& pile : k_piles) {
    const double mu = (1 - k_share) * pile.critical_on_floor();
    const contact::ContactProblem problem = build(pile, k_ample, mu);
    if (takes(problem)) expect_collapse(pile, solve(problem).v, skidding_out(pile, mu));
  }
}

TEST_P(CoulombArtefacts, CopiesOfAContactShareItsImpulse) {
  // a particle lands on another and slides over it; friction on the floor holds the lower one
  const double lower = 3, upper = 2, mu = 0.4, fall = 1;
  const Vec3 slip = 5 * Vec3(0, std::cos(0.7), std::sin(0.7));
  contact::ContactProblem once = test::particle(Law::coulomb, lower, mu, Vec3(-fall, 0, 0));
  once.add_block(upper * Mat3::Identity());
  once.f.tail<3>() = upper * (slip - Vec3(fall, 0, 0));
  once.add_contact(0, -Mat3::Identity(), 1, Mat3::Identity(), 2);
  once.mu.back() = once.mu_static.back() = mu;

  const Vec3 friction = -mu * upper * fall * slip.normalized();
  VecX r(6), v(6);
  r << (lower + upper) * Vec3(fall, 0, 0) + friction, upper * Vec3(fall, 0, 0) + friction;
  v << Vec3::Zero(), slip + friction / upper;
  for (const int copies : {1, 2, 4}) {
    contact::ContactProblem problem = once;
    for (int k = 1; k < copies; ++k)
      for (int c = 0; c < 2; ++c) test::copy_contact(once, c, problem.pairs.size() + 1, false, problem);
    const contact::ContactSolution s = solve(problem);
    VecX sum = VecX::Zero(6);
    for (int k = 0; k < copies; ++k) sum += s.r.segment<6>(6 * k);
    EXPECT_LT((s.v - v).norm(), k_same) << copies;
    EXPECT_LT((sum - r).norm(), (lower + upper) * k_same) << copies;
  }
}

std::string name_of(const testing::TestParamInfo<std::string>& info) { return test::test_name(info.param); }
INSTANTIATE_TEST_SUITE_P(All, CoulombArtefacts, testing::ValuesIn(solvers_of(Law::coulomb)), name_of);
INSTANTIATE_TEST_SUITE_P(All, BoxArtefacts, testing::ValuesIn(solvers_of(Law::pyramid)), name_of);
INSTANTIATE_TEST_SUITE_P(All, PolygonArtefacts, testing::ValuesIn(solvers_of(Law::pyramid_k)), name_of);

}  // namespace artefacts_test
}  // namespace nilas::solvers
