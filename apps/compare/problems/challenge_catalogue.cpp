#include "apps/compare/problems/challenge_catalogue.h"

#include <cmath>

#include "contact/challenge/challenge_problems.h"

namespace nilas::compare {

namespace {

using namespace challenge;

constexpr double k_step = 0.01, k_gravity = 9.81;  // [s] [m/s^2]

/// Multiplies a body's mass and inertia; its free velocity stays.
void make_heavier(contact::ContactProblem& problem, int block, double factor) {
  const auto begin = static_cast<std::ptrdiff_t>(problem.mass_offset[block]),
             end = static_cast<std::ptrdiff_t>(problem.mass_offset[static_cast<std::size_t>(block) + 1]);
  for (auto k = begin; k < end; ++k) problem.mass_data[k] *= factor;
  problem.f.segment(problem.block_offset[block], problem.block_size(block)) *= factor;
}

/// A wedge pressed between two walls that lean outwards by 10 degrees: friction alone could hold any squeeze.
contact::ContactProblem jammed_wedge() {
  contact::ContactProblem problem;
  problem.h = k_step;
  RigidBody wedge{100, 10 * Mat3::Identity()};
  wedge.v = Vec3(0, 0, -1);
  add_body(problem, wedge);
  const double lean = 10 * k_deg;
  for (const double side : {-1.0, 1.0})
    for (const double y : {-0.5, 0.5}) {
      const Vec3 normal(-side * std::cos(lean), 0, std::sin(lean));
      add_contact(problem, {wedge}, -1, 0, Vec3(0.5 * side, y, 0), frame_of(normal), 0.7);
    }
  return problem;
}

/// A box on `side` x `side` feet, kicked sideways less than friction holds.
contact::ContactProblem table(int side) {
  contact::ContactProblem problem;
  problem.h = k_step;
  RigidBody box{10, 10.0 / 6 * Mat3::Identity(), Vec3(0, 0, 0.5)};
  box.v = Vec3(0.2 * k_step * k_gravity, 0, -k_step * k_gravity);
  add_body(problem, box);
  for (int i = 0; i < side; ++i)
    for (int j = 0; j < side; ++j)
      add_contact(problem, {box}, -1, 0, Vec3(i / (side - 1.0) - 0.5, j / (side - 1.0) - 0.5, 0),
                  frame_of(Vec3::UnitZ()), 0.5);
  return problem;
}

/// A stack of boxes that all slide, each at a speed and in a direction of its own.
contact::ContactProblem sliding_stack(int count) {
  contact::ContactProblem problem = box_stack(std::vector<double>(static_cast<std::size_t>(count), 1.0), 0.2);
  for (int k = 0; k < count; ++k) {
    const double speed = 0.5 * (k + 1);
    problem.f[6 * k] += speed * std::cos(1.0 * k);
    problem.f[6 * k + 1] += speed * std::sin(1.0 * k);
  }
  return problem;
}

/// Floes between walls, all driven towards the middle of the field.
contact::ContactProblem jammed_raft(int side) {
  contact::ContactProblem problem = raft(side, 0.6, 1, 7);
  const double middle = 0.5 * (side - 1), mass = 90;
  for (int k = 0; k < side * side; ++k) {
    problem.f[6 * k] += 0.5 * mass * (middle - k % side);
    problem.f[6 * k + 1] += 0.5 * mass * (middle - k / side);
  }
  return problem;
}

/// A body of `ratio` times a floe's mass pushes through them.
contact::ContactProblem vessel_in_floes(int side, double ratio) {
  contact::ContactProblem problem = raft(side, 0.3, 0.8, 11);
  const int vessel = side * side / 2;
  problem.f.segment<6>(6 * vessel) << 2 * 90, 0, 0, 0, 0, 0;
  make_heavier(problem, vessel, ratio);
  return problem;
}

/// Balls in a row on the ground, each against the next, with friction against rolling.
contact::ContactProblem rolling_balls(int count) {
  constexpr double radius = 0.5, mass = 2, length = 0.01;
  contact::ContactProblem problem;
  problem.h = k_step;
  std::vector<RigidBody> balls;
  for (int k = 0; k < count; ++k) {
    RigidBody ball{mass, 0.4 * mass * radius * radius * Mat3::Identity(), Vec3(k, 0, radius)};
    ball.v = Vec3(1 - 0.1 * k, 0.05 * k, -k_step * k_gravity);
    ball.w = Vec3(0, ball.v.x() / radius, 0);
    balls.push_back(ball);
    add_body(problem, ball);
  }
  for (int k = 0; k < count; ++k) add_contact(problem, balls, -1, k, Vec3(k, 0, 0), frame_of(Vec3::UnitZ()), 0.4);
  for (int k = 1; k < count; ++k)
    add_contact(problem, balls, k - 1, k, Vec3(k - 0.5, 0, radius), frame_of(Vec3::UnitX()), 0.4);
  for (int k = 0; k < count; ++k) {
    MatX rows = MatX::Zero(3, 6);
    rows.bottomRightCorner<2, 3>() = length * frame_of(Vec3::UnitZ()).transpose().bottomRows<2>();
    problem.add_moment(k, MatX(3, 0), rows, length, 1000 + static_cast<std::uint64_t>(k));
  }
  return problem;
}

}  // namespace

std::vector<Challenge> challenges() {
  const std::vector<double> alike(10, 1.0);
  return {{"wedge", "a wedge jammed by friction; 4 redundant contacts", jammed_wedge()},
          {"two-boxes-1e6", "a box on one of a millionth of its mass", box_stack({1, 1e6}, 0.5)},
          {"table-7x7", "a hyperstatic box on 49 feet; all sticking", table(7)},
          {"rolling-balls", "8 balls in a row with rolling friction", rolling_balls(8)},
          {"stack-10", "10 boxes of the same mass; all sticking", box_stack(alike, 0.5)},
          {"stack-10-1e6", "10 boxes; masses growing to a million times the lowest",
           box_stack(growing_masses(10, 1e6), 0.5)},
          {"stack-40", "40 boxes of the same mass; each impulse acts on all of them",
           box_stack(std::vector<double>(40, 1.0), 0.5)},
          {"sliding-stack", "20 boxes on each other; each sliding in a direction of its own", sliding_stack(20)},
          {"heap", "60 bodies of different masses thrown together", random_heap(5, 60, 150, 0.5)},
          {"heap-high-friction", "40 such bodies; friction 2", random_heap(6, 40, 120, 2)},
          {"jammed-raft", "100 floes between walls; driven together", jammed_raft(10)},
          {"loose-raft", "225 floes; a third of them touching", raft(15, 0.3, 0.35, 3)},
          {"vessel-1e3", "a vessel of 1000 times a floe's mass among 196", vessel_in_floes(14, 1e3)},
          {"vessel-1e6", "a vessel of a million times a floe's mass among 196", vessel_in_floes(14, 1e6)}};
}

}  // namespace nilas::compare
