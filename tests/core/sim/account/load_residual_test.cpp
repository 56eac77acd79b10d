#include "core/sim/account/load_residual.h"

#include <gtest/gtest.h>

#include <tuple>

#include "contact/measure/measure.h"

namespace nilas::sim {
namespace load_residual_test {

constexpr double k_mass = 2;

/// One floe (body 0) pressed against a vessel (body 1) that does not yield, at arm (0, 1, 0) from its centre.
contact::SolvedProblem pressed(double off, Law law, contact::StepMotion& motion) {
  contact::SolvedProblem solved;
  contact::ContactProblem& problem = solved.problem;
  problem.h = motion.h = 0.01;
  problem.law = law;
  problem.add_block(k_mass * Mat3::Identity());
  problem.add_contact(0, -Mat3::Identity(), -1, MatX(3, 0), 1);  // the normal points at the vessel: B
  problem.f << 0.5, 0, 0;
  solved.solution.r = Vec3(0.5 + off, 0, 0);
  solved.solution.v = contact::velocities(problem, solved.solution.r);
  contact::measure(contact::PreparedProblem(problem), solved.solution.r, solved.solution.v, solved.d);
  motion.p = {Vec3(-1, 1, 0), Vec3::Zero()};
  detect::ContactPoint c;
  c.a = 0;
  c.b = 1;
  c.p = Vec3(0, 1, 0);
  motion.points = {c};
  return solved;
}

TEST(LoadResidual, AWrongImpulseIsTheLoadThatIsOff) {
  contact::StepMotion motion;
  for (const double off : {0.125, -0.25}) {
    const contact::SolvedProblem solved = pressed(off, Law::coulomb, motion);
    const LoadResidual e = load_residual(solved, {Mat3::Identity()}, motion, 1);
    EXPECT_NEAR(e.solver.force.x(), std::abs(off), 1e-15);
    EXPECT_NEAR(e.solver.torque.z(), std::abs(off), 1e-15);
    EXPECT_EQ(e.solver.force.y(), 0);
    EXPECT_EQ(e.law.force.norm(), 0);
  }
  // a floe that touches no vessel is none of its load
  const contact::SolvedProblem solved = pressed(0.125, Law::coulomb, motion);
  motion.p.push_back(Vec3::Zero());
  EXPECT_EQ(load_residual(solved, {Mat3::Identity()}, motion, 2).solver.force.norm(), 0);
}

/// The vessel (body 2) pushes a floe that pushes another: what is off between the floes may reach the vessel, but a
/// solver that met its tolerance is taken by its word. A third floe (body 3) rests against the second's neighbour only.
TEST(LoadResidual, OfFloesBehindCountsWhereTheSolverStoppedShort) {
  contact::StepMotion motion;
  contact::SolvedProblem solved;
  contact::ContactProblem& problem = solved.problem;
  problem.h = motion.h = 0.01;
  problem.law = Law::coulomb;
  for (int k = 0; k < 4; ++k) problem.add_block(k_mass * Mat3::Identity());
  const MatX none(3, 0);
  problem.add_contact(0, -Mat3::Identity(), 1, Mat3::Identity(), 1);  // floe on floe
  problem.add_contact(1, -Mat3::Identity(), -1, none, 2);             // floe on vessel
  problem.add_contact(2, -Mat3::Identity(), 3, Mat3::Identity(), 3);  // floes elsewhere
  problem.f.setZero();
  const double between = 0.25, elsewhere = 4;
  solved.solution.r = VecX::Zero(9);
  solved.solution.r[0] = between;
  solved.solution.r[6] = elsewhere;
  solved.solution.v = contact::velocities(problem, solved.solution.r);
  contact::measure(contact::PreparedProblem(problem), solved.solution.r, solved.solution.v, solved.d);
  motion.p.assign(5, Vec3::Zero());
  motion.points.resize(3);
  constexpr int k_vessel = 4;
  for (const auto& [c, a, b] : {std::tuple(0, 0, 1), std::tuple(1, 1, k_vessel), std::tuple(2, 2, 3)}) {
    motion.points[c].a = a;
    motion.points[c].b = b;
    motion.points[c].p = Vec3(0, 2, 0);
  }
  const std::vector<Mat3> C(3, Mat3::Identity());
  solved.solution.status = contact::SolveStatus::converged;
  const double at_hull = load_residual(solved, C, motion, k_vessel).solver.force.x();
  solved.solution.status = contact::SolveStatus::iteration_limit;
  const LoadResidual e = load_residual(solved, C, motion, k_vessel);
  const double behind = e.solver.force.x() - at_hull;
  EXPECT_GT(behind, 0.5 * between);
  EXPECT_LT(behind, 2 * between) << "that of floes elsewhere is far larger and none of the vessel's";
  EXPECT_NEAR(e.solver.force.y(), behind, 1e-12) << "along any axis";
  EXPECT_GE(e.solver.torque.x(), 2 * behind - 1e-12) << "at its arm";
  EXPECT_EQ(e.law.force.norm(), 0);
}

TEST(LoadResidual, OfTheLawIsSigned) {
  contact::StepMotion motion;
  contact::SolvedProblem solved = pressed(0, Law::pyramid, motion);
  solved.problem.mu[0] = 0.5;
  solved.problem.f << 0.5, 3, 3;
  const double bound = 0.25;
  solved.solution.r = Vec3(0.5, bound, bound);
  solved.solution.v = contact::velocities(solved.problem, solved.solution.r);
  const LoadResidual e = load_residual(solved, {Mat3::Identity()}, motion, 1);
  EXPECT_LT(e.solver.force.norm(), 1e-15);
  EXPECT_GT(e.law.force.y(), 0.05) << "the vessel is dragged along too much";
  EXPECT_NEAR(e.law.force.y(), e.law.force.z(), 1e-15);
}

}  // namespace load_residual_test
}  // namespace nilas::sim
