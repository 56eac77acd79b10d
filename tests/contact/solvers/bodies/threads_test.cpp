#include <gtest/gtest.h>

#include <algorithm>
#include <atomic>
#include <cstring>
#include <stdexcept>

#include "contact/challenge/challenge_problems.h"
#include "contact/solvers/bodies/body_system.h"
#include "contact/solvers/bodies/node_cholesky.h"
#include "contact/solvers/bodies/node_tasks.h"
#include "contact/solvers/body_ladder.h"
#include "tests/contact/solvers/bodies/island_with_vessel.h"

namespace nilas::solvers {
namespace threads_test {

constexpr int k_most_threads = 3;

/// 1520 contacts: a large island.
contact::ContactProblem raft() { return test::largest_island(challenge::raft(20, 0.3, 1, 1)); }
/// A vessel of two nodes that touches every second body.
contact::ContactProblem heap() { return test::largest_island(test::heap_with_vessel(3, 120, 300, 0.3)); }

bool same_bits(const NodeVector& a, const NodeVector& b) {
  return a.size() == b.size() && std::memcmp(a.data(), b.data(), a.size() * sizeof(NodeNumbers)) == 0;
}
bool same_bits(const VecX& a, const VecX& b) {
  return a.size() == b.size() &&
         std::memcmp(a.data(), b.data(), static_cast<std::size_t>(a.size()) * sizeof(double)) == 0;
}

/// The vectors that products, factors and a step give with some number of threads.
struct Results {
  NodeVector nodes, symmetric, full;
  VecX velocities, step;
  double map_size = 0;

  Results(const contact::PreparedProblem& prepared, int threads) {
    const BodyIsland bodies(prepared, threads);
    const NodePlan plan = plan_nodes(bodies).value();
    const auto count = static_cast<std::size_t>(bodies.num_contacts());
    RandomStream random(11, "numbers");
    ContactVectors r(count), u(count);
    ContactMatrices g(count);
    std::vector<Mat3> slipping;
    for (std::size_t c = 0; c < count; ++c) {
      Mat3 root;
      for (int k = 0; k < 9; ++k) root.data()[k] = random.normal();
      const Mat3 m = root * root.transpose();
      const double entries[] = {m(0, 0), m(1, 0), m(2, 0), m(1, 1), m(2, 1), m(2, 2)};
      for (std::size_t i = 0; i < 6; ++i) g.entry[i][c] = entries[i];
      slipping.push_back(c % 5 == 0 ? Mat3(Mat3::Zero()) : Mat3(m));
      slipping.back()(0, 1) *= 1.5;
      r.set(c, root.col(0));
    }
    nodes = symmetric = full = bodies.free_motion();
    bodies.add_impulses(r, nodes);
    bodies.relative_velocities(nodes, u);
    velocities = by_contact(u);
    NodeCholesky cholesky(bodies, plan);
    NodeLu lu(bodies, plan);
    EXPECT_TRUE(cholesky.factor(g));
    EXPECT_TRUE(lu.factor(slipping));
    cholesky.solve(symmetric);
    lu.solve(full);
    BodySystem system(prepared, bodies, plan);
    const VecX scaled = system.scaled(by_contact(r));
    map_size = system.linearise(scaled, system.velocities(scaled));
    EXPECT_TRUE(system.step(1e-2, scaled, step));
  }
};

TEST(ThreadsOnBodies, ProductsAndFactorsKeepTheirBits) {
  for (const auto& problem : {raft(), heap()}) {
    const contact::PreparedProblem prepared(problem);
    const Results one(prepared, 1);
    for (int threads = 2; threads <= k_most_threads; ++threads)
      for (int again = 0; again < 3; ++again) {
        const Results many(prepared, threads);
        EXPECT_TRUE(same_bits(many.nodes, one.nodes)) << threads;
        EXPECT_TRUE(same_bits(many.velocities, one.velocities)) << threads;
        EXPECT_TRUE(same_bits(many.symmetric, one.symmetric)) << threads;
        EXPECT_TRUE(same_bits(many.full, one.full)) << threads;
        EXPECT_TRUE(same_bits(many.step, one.step)) << threads;
        EXPECT_EQ(many.map_size, one.map_size) << threads;
      }
  }
}

TEST(ThreadsOnBodies, AWholeSolveKeepsItsBits) {
  contact::ContactProblem slippery = raft(), yielding = raft();
  std::fill(slippery.mu.begin(), slippery.mu.end(), 0.1);
  for (std::size_t c = 0; c < yielding.pairs.size(); ++c) {
    if (c % 3 == 0) yielding.force_limit[c] = 0.1;
    if (c % 4 == 1) yielding.compliance[c] = 1e-4;
  }
  for (const auto& problem : {raft(), slippery, yielding}) {
    ASSERT_GE(problem.num_contacts(), k_large_on_bodies);
    const contact::PreparedProblem prepared(problem);
    contact::SolverSettings settings{.tolerance = 1e-6, .max_iterations = 30};
    const auto solve = [&](int threads) {
      settings.threads = threads;
      return solve_on_bodies(prepared, {}, settings, Budget(settings)).value();
    };
    const BodyOutcome one = solve(1);
    EXPECT_GT(one.interior, 5);
    for (int threads = 2; threads <= k_most_threads; ++threads) {
      const BodyOutcome many = solve(threads);
      EXPECT_TRUE(same_bits(many.r, one.r)) << threads;
      EXPECT_EQ(many.interior, one.interior) << threads;
      EXPECT_EQ(many.newton, one.newton) << threads;
    }
  }
}

/// Threads that take the tasks in their order can then never wait for each other.
TEST(ThreadsOnBodies, TasksNeedOnlyThoseBeforeThem) {
  for (const auto& problem : {raft(), heap()}) {
    const contact::PreparedProblem prepared(problem);
    const NodePlan plan = plan_nodes(BodyIsland(prepared)).value();
    std::vector<int> order = plan.task_columns;
    for (int k = 0; k < plan.num_tasks(); ++k)
      for (int i = plan.task_start[k]; i < plan.task_start[k + 1]; ++i) {
        EXPECT_EQ(plan.task_of[order[i]], k);
        EXPECT_TRUE(i == plan.task_start[k] || order[i - 1] < order[i]);
      }
    std::sort(order.begin(), order.end());
    for (int j = 0; j < plan.size(); ++j) {
      EXPECT_EQ(order[j], j);
      for (std::size_t e = plan.earlier_start[j]; e < plan.earlier_start[j + 1]; ++e) {
        const int needed = plan.task_of[plan.earlier[e].column];
        EXPECT_TRUE(needed == plan.task_of[j] || (needed < plan.task_of[j] && plan.task_of[j] >= plan.num_pieces));
      }
    }
    EXPECT_GT(plan.num_pieces, 4);
  }
}

/// A task that ends with an exception, as where memory runs out, must not leave those that wait for it waiting.
TEST(ThreadsOnBodies, WhatATaskThrowsReachesTheCaller) {
  const contact::ContactProblem problem = raft();
  const contact::PreparedProblem prepared(problem);
  const NodePlan plan = plan_nodes(BodyIsland(prepared)).value();
  TaskProgress progress(plan.num_tasks());
  for (int threads = 1; threads <= k_most_threads; ++threads) {
    std::atomic<int> columns = 0;
    const auto run = [&](const TaskRun& task) {
      for (const int j : task.columns)
        for (std::size_t e = plan.earlier_start[j]; e < plan.earlier_start[j + 1]; ++e)
          task.wait_for(plan.earlier[e].column);
      columns += static_cast<int>(task.columns.size());
      if (task.own == 0) throw std::runtime_error("the first task");
    };
    EXPECT_THROW(run_tasks(plan, progress, threads, run), std::runtime_error);
    EXPECT_EQ(columns, plan.size()) << "the others run all the same";
  }
}

}  // namespace threads_test
}  // namespace nilas::solvers
