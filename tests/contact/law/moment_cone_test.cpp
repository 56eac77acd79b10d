/// Tests of rolling and spinning friction: the cone, the residual, the solvers and FCLIB's rolling form.
#include "contact/law/moment_cone.h"

#include <gtest/gtest.h>

#include <cmath>

#include "contact/fclib/fclib_io.h"
#include "contact/registry.h"
#include "core/base/error.h"
#include "tests/support/problems/problem_factory.h"
#include "tests/support/scratch_folder.h"

namespace nilas::contact {
namespace moment_cone_test {

using Vec6d = Eigen::Matrix<double, 6, 1>;

Vec6d stacked(const ForceAndMoment& x) {
  Vec6d all;
  all << x.force, x.moment;
  return all;
}

double slack(const ForceAndMoment& x, double mu) {
  return std::min({mu * x.force[0] - std::hypot(x.force[1], x.force[2]), x.force[0] - std::abs(x.moment[0]),
                   x.force[0] - std::hypot(x.moment[1], x.moment[2])});
}

ForceAndMoment random_member(RandomStream& random, double mu) {
  const double n = random.uniform(0, 3), t = mu * n * random.uniform(), a = random.uniform(0, 2 * k_pi);
  const double m = n * random.uniform(), b = random.uniform(0, 2 * k_pi);
  return {{n, t * std::cos(a), t * std::sin(a)}, {n * random.uniform(-1, 1), m * std::cos(b), m * std::sin(b)}};
}

TEST(MomentCone, ProjectionIsTheNearestPoint) {
  RandomStream random(4, "cone");
  for (int k = 0; k < 2000; ++k) {
    const double mu = k % 5 == 0 ? 0 : std::exp(random.normal());
    const ForceAndMoment x{2 * test::random_vector(random), 2 * test::random_vector(random)};
    const ForceAndMoment y = project_moment_cone(x, mu, std::numeric_limits<double>::infinity());
    EXPECT_GE(slack(y, mu), -1e-14);
    const Vec6d rest = stacked(x) - stacked(y);
    EXPECT_NEAR(rest.dot(stacked(y)), 0, 1e-13);
    for (int i = 0; i < 20; ++i) EXPECT_LE(rest.dot(stacked(random_member(random, mu))), 1e-13);
  }
}

TEST(MomentCone, ProjectionRespectsTheCap) {
  RandomStream random(5, "cone");
  for (int k = 0; k < 500; ++k) {
    const ForceAndMoment x{Vec3(3, 0, 0) + test::random_vector(random), 2 * test::random_vector(random)};
    const ForceAndMoment y = project_moment_cone(x, 0.4, 1);
    EXPECT_LE(y.force[0], 1);
    for (int i = 0; i < 20; ++i) {
      ForceAndMoment z = random_member(random, 0.4);
      if (z.force[0] > 1) continue;
      EXPECT_LE((stacked(x) - stacked(y)).dot(stacked(z) - stacked(y)), 1e-13);
    }
  }
}

/// A sphere on the ground that turns so that it rolls along x. Gravity is in its momentum; rows are in z, x, y.
struct Sphere {
  static constexpr double k_mass = 3, k_radius = 0.4, k_step = 0.01, k_gravity = 9.81;
  static constexpr double k_inertia = 0.4 * k_mass * k_radius * k_radius;
  double rolling = 0, spinning = 0, mu = 0.5;
  double slope = 0;  ///< Tangent of the slope of the ground along x.
  Vec3 v = Vec3::Zero(), w = Vec3::Zero();

  ContactProblem problem(Law law = Law::coulomb) const {
    ContactProblem out;
    out.law = law;
    out.h = k_step;
    test::TestBody body;
    body.mass = k_mass;
    body.inertia = k_inertia * Mat3::Identity();
    const double angle = std::atan(slope);
    body.v = v + k_step * k_gravity * Vec3(std::sin(angle), 0, -std::cos(angle));
    body.w = w;
    test::add_body(out, body);
    Mat3 frame;
    frame << Vec3::UnitZ(), Vec3::UnitX(), Vec3::UnitY();
    test::add_contact(out, {body}, -1, 0, Vec3(0, 0, -k_radius), frame, mu);
    if (rolling == 0 && spinning == 0) return out;
    MatX rows = MatX::Zero(3, 6);
    rows.rightCols<3>() = Vec3(spinning, rolling, rolling).asDiagonal() * frame.transpose();
    out.add_moment(0, MatX(3, 0), rows, rolling, 99);
    return out;
  }
};

ContactSolution solve(const ContactProblem& problem, const std::string& solver = "nsgs") {
  ContactSolution solution =
      find_solver(solver).make({.tolerance = 1e-13, .max_iterations = 10000})->solve(problem, {});
  EXPECT_EQ(solution.status, SolveStatus::converged) << solution.message;
  EXPECT_LE(measure(problem, solution.r).natural_map_m_s, problem.law == Law::coulomb ? 1e-13 : 1);
  return solution;
}

TEST(RollingFriction, SlowsASphereByItsLength) {
  for (const Law law : {Law::coulomb, Law::pyramid})
    for (const char* solver : {"nsgs", "auto"}) {
      const Sphere sphere{.rolling = 0.01, .v = Vec3(1, 0, 0), .w = Vec3(0, 1 / Sphere::k_radius, 0)};
      const ContactSolution solution = solve(sphere.problem(law), solver);
      const double slower = 5.0 / 7 * 0.01 / Sphere::k_radius * Sphere::k_gravity * Sphere::k_step;
      EXPECT_NEAR(solution.v[0], 1 - slower, 1e-12) << solver;
      EXPECT_NEAR(solution.v[4] * Sphere::k_radius, solution.v[0], 1e-12) << "it does not slip";
    }
}

TEST(RollingFriction, HoldsOnASlopeUpToItsLengthOverTheRadius) {
  const double steepest = 0.01 / Sphere::k_radius;
  EXPECT_LT(solve(Sphere{.rolling = 0.01, .slope = steepest * (1 - 1e-6)}.problem()).v.norm(), 1e-12);
  const double angle = std::atan(2 * steepest);
  const Vec2 g(Sphere::k_gravity * std::sin(angle), Sphere::k_gravity * std::cos(angle));
  const double speed = 5.0 / 7 * Sphere::k_step * (g[0] - steepest * g[1]);
  EXPECT_NEAR(solve(Sphere{.rolling = 0.01, .slope = 2 * steepest}.problem()).v[0], speed, 1e-12);
}

TEST(SpinningFriction, SlowsASpinAboutTheNormal) {
  const double slower = 0.02 * Sphere::k_mass * Sphere::k_gravity * Sphere::k_step / Sphere::k_inertia;
  const Sphere fast{.spinning = 0.02, .w = Vec3(0, 0, 5)}, slow{.spinning = 0.02, .w = Vec3(0, 0, 0.9 * slower)};
  EXPECT_NEAR(solve(fast.problem()).v[5], 5 - slower, 1e-12);
  EXPECT_NEAR(solve(slow.problem()).v[5], 0, 1e-12);
}

TEST(RollingFriction, MeasureByHand) {
  // There are no impulses, and the only motion is rolling at 1 rad/s. Without gravity, u_hat_N = delta |w_R|.
  ContactProblem problem = Sphere{.rolling = 0.05, .w = Vec3(0, 1, 0)}.problem();
  problem.f[2] = 0;
  const double d = delassus_diagonal(problem)[0].trace() / 3;
  VecX v = VecX::Zero(6);
  v[4] = 1;
  // u_T = -radius along x, mu |u_T| = 0.2, moment row 0.05; r = (1, 0, 0), (0, 0, 0)
  VecX r = VecX::Zero(6);
  r[0] = 1;
  const ForceAndMoment u{{0.5 * 0.4 + 0.05, -0.4, 0}, {0, 0, 0.05}};
  const ForceAndMoment nearest =
      project_moment_cone({Vec3(1, 0, 0) - u.force / d, -u.moment / d}, 0.5, std::numeric_limits<double>::infinity());
  EXPECT_NEAR(measure(problem, r, v).natural_map_m_s,
              d * std::hypot((Vec3(1, 0, 0) - nearest.force).norm(), nearest.moment.norm()), 1e-15);
  EXPECT_NEAR(measure(problem, r, v).bipotential_J, 0.5 * 0.4 + 0.05, 1e-15);
}

/// Spheres side by side and on each other, all rolling.
ContactProblem heap_with_moments() {
  ContactProblem problem = test::random_heap(3, 12, 24, 0.4);
  const int count = problem.num_contacts();
  for (int c = 0; c < count; c += 2) {
    const auto rows = [&](const ContactProblem::ConstJacobian& jacobian) -> MatX {
      MatX moment = MatX::Zero(3, jacobian.cols());
      // The linear columns of a row hold its direction, up to the sign of the side.
      if (jacobian.cols() == 6) moment.rightCols<3>() = 0.1 * jacobian.leftCols<3>();
      moment.row(0).setZero();
      return moment;
    };
    problem.add_moment(c, rows(problem.jacobian_a(c)), rows(problem.jacobian_b(c)), 0.1,
                       1000 + static_cast<std::uint64_t>(c));
  }
  return problem;
}

TEST(RollingFriction, AHeapIsSolvedToTheYardstick) {
  const ContactProblem problem = heap_with_moments();
  validate(problem);
  EXPECT_EQ(problem.num_points(), 24);
  const auto solution = find_solver("auto").make({.tolerance = 1e-10, .max_iterations = 100000})->solve(problem, {});
  EXPECT_EQ(solution.status, SolveStatus::converged) << solution.message;
  EXPECT_LE(measure(problem, solution.r).natural_map_m_s, 1e-10);
  for (int c = 0; c < 24; c += 2) {
    ASSERT_GE(problem.moment_of(c), 24);
    EXPECT_GE(slack({solution.r.segment<3>(3 * c), solution.r.segment<3>(3 * problem.moment_of(c))}, 0.4), -1e-9);
  }
}

/// A guess holds the impulses of moments behind those of the points. Its own solution is done at once, that of a
/// problem nearby saves sweeps, and a guess whose moments are wrong costs sweeps but leads to the same motion.
TEST(RollingFriction, AHeapIsSolvedFromGuesses) {
  const ContactProblem problem = heap_with_moments();
  const auto solver = find_solver("auto").make({.tolerance = 1e-10, .max_iterations = 100000});
  const ContactSolution cold = solver->solve(problem, {});
  ASSERT_EQ(cold.status, SolveStatus::converged);
  const VecX moments = cold.r.tail(cold.r.size() - 3 * 24);
  ASSERT_GT(moments.norm(), 0);
  const ContactSolution again = solver->solve(problem, cold.r);
  EXPECT_EQ(again.status, SolveStatus::converged);
  EXPECT_EQ(again.iterations, 0);
  EXPECT_EQ(again.r, cold.r);
  for (const double factor : {0.0, -1.0, 1e6}) {
    VecX guess = cold.r;
    guess.tail(moments.size()) *= factor;
    const ContactSolution found = solver->solve(problem, guess);
    EXPECT_EQ(found.status, SolveStatus::converged) << factor << ": " << found.message;
    EXPECT_GT(found.iterations, 0) << factor;
    EXPECT_LT((found.v - cold.v).cwiseAbs().maxCoeff(), 1e-8) << factor;
  }
  ContactProblem near = problem;
  near.f *= 1.001;
  const ContactSolution warm = solver->solve(near, cold.r);
  EXPECT_EQ(warm.status, SolveStatus::converged);
  EXPECT_LT(warm.iterations, solver->solve(near, {}).iterations);
  EXPECT_THROW(solver->solve(problem, VecX(cold.r.head(3 * 24))), ContractError);
}

TEST(RollingFriction, GoesThroughAFileAndBack) {
  const test::ScratchFolder folder;
  const ContactProblem problem = heap_with_moments();
  const ContactSolution solution =
      find_solver("nsgs").make({.tolerance = 1e-10, .max_iterations = 100000})->solve(problem, {});
  const auto path = folder.path() / "rolling.hdf5";
  write_fclib(path, problem, &solution);
  const FclibProblem read = read_fclib(path);
  ASSERT_TRUE(std::holds_alternative<ContactProblem>(read.problem));
  const auto& again = std::get<ContactProblem>(read.problem);
  EXPECT_EQ(read.num_contacts(), 24);
  ASSERT_TRUE(read.solution.has_value());
  const Residuals before = measure(problem, solution.r), after = measure(again, *read.solution);
  EXPECT_NEAR(after.natural_map_m_s, before.natural_map_m_s, 1e-14);
  // Both solutions lie near the same exact one.
  const ContactSolution two =
      find_solver("nsgs").make({.tolerance = 1e-10, .max_iterations = 100000})->solve(again, {});
  EXPECT_LE(measure(again, two.r).natural_map_m_s, 1e-10);
}

TEST(RollingFriction, SpinningHasNoPlaceInAFile) {
  const test::ScratchFolder folder;
  EXPECT_THROW(write_fclib(folder.path() / "spin.hdf5", Sphere{.spinning = 0.1}.problem(), nullptr), InputError);
}

TEST(RollingFriction, SolversWithoutItSaySo) {
  const ContactProblem problem = Sphere{.rolling = 0.1}.problem();
  for (const auto& entry : solver_registry()) {
    if (entry.moments) continue;
    ContactProblem asked = problem;
    asked.law = entry.laws.front();
    EXPECT_THROW(entry.make({})->solve(asked, {}), InputError) << entry.name;
  }
  EXPECT_THROW(demand_moments(find_solver("newton"), Law::coulomb), InputError);
  EXPECT_THROW(demand_moments(find_solver("nsgs"), Law::ccp), InputError);
}

}  // namespace moment_cone_test
}  // namespace nilas::contact
