#include "contact/challenge/challenge_problems.h"

#include <cmath>

namespace nilas::challenge {

contact::ContactProblem random_heap(std::uint64_t seed, int body_count, int contact_count, double mu) {
  RandomStream random(seed, "heap");
  contact::ContactProblem problem;
  problem.h = 0.01;
  std::vector<RigidBody> bodies;
  for (int k = 0; k < body_count; ++k) {
    RigidBody body;
    body.mass = std::exp(random.normal());
    const Vec3 moments(random.uniform(0.5, 1.5), random.uniform(0.5, 1.5), random.uniform(0.5, 1.5));
    const Mat3 axes = Quat(random.normal(), random.normal(), random.normal(), random.normal()).normalized().matrix();
    body.inertia = body.mass * axes * moments.asDiagonal() * axes.transpose();
    body.inertia = 0.5 * (body.inertia + body.inertia.transpose().eval());
    body.p = 2 * random_vector(random);
    body.v = random_vector(random);
    body.w = random_vector(random);
    bodies.push_back(body);
    add_body(problem, body);
  }
  for (int c = 0; c < contact_count; ++c) {
    const int a = static_cast<int>(random.bits() % static_cast<std::uint64_t>(body_count + 1)) - 1;
    int b = static_cast<int>(random.bits() % static_cast<std::uint64_t>(body_count));
    if (b == a) b = (b + 1) % body_count;
    const Vec3 middle = bodies[b].p + 0.7 * random_vector(random);
    add_contact(problem, bodies, a, b, middle, frame_of(random_vector(random).normalized(), random.uniform(0, k_pi)),
                mu);
  }
  return problem;
}

contact::ContactProblem column(const std::vector<double>& masses, double h, double g) {
  contact::ContactProblem problem;
  problem.h = h;
  problem.law = Law::frictionless;
  std::vector<RigidBody> bodies;
  for (std::size_t k = 0; k < masses.size(); ++k) {
    RigidBody body{masses[k], masses[k] * Mat3::Identity(), Vec3(0, 0, static_cast<double>(k) + 0.5)};
    body.v.z() = -h * g;
    bodies.push_back(body);
    add_body(problem, body);
  }
  for (std::size_t k = 0; k < masses.size(); ++k)
    add_contact(problem, bodies, static_cast<int>(k) - 1, static_cast<int>(k), Vec3(0, 0, static_cast<double>(k)),
                frame_of(Vec3::UnitZ()), 0);
  return problem;
}

contact::ContactProblem raft(int side, double mu, double closed, std::uint64_t seed) {
  constexpr double thickness = 0.1, density = 900, reach = 0.35;
  RandomStream random(seed, "raft");
  contact::ContactProblem problem;
  problem.h = 0.01;
  std::vector<RigidBody> bodies;
  for (int k = 0; k < side * side; ++k) {
    RigidBody body;
    body.mass = density * thickness;
    body.inertia = Vec3(body.mass / 12, body.mass / 12, body.mass / 6).asDiagonal();
    body.p = Vec3(k % side, k / side, 0);
    body.v = 0.3 * random_vector(random);
    body.w = 0.1 * random_vector(random);
    bodies.push_back(body);
    add_body(problem, body);
  }
  const auto touch = [&](int a, int b, const Vec3& middle, const Vec3& n) {
    const double gap_speed = random.uniform() < closed ? 0 : 100;
    const Vec3 along = reach * Vec3(-n.y(), n.x(), 0);
    for (const double s : {-1.0, 1.0}) {
      const int c = add_contact(problem, bodies, a, b, middle + s * along, frame_of(n), mu);
      problem.w[3 * c] = gap_speed;
    }
  };
  for (int j = 0; j < side; ++j)
    for (int i = 0; i < side; ++i) {
      const int k = j * side + i;
      const Vec3 p = bodies[k].p;
      touch(i == 0 ? -1 : k - 1, k, p - Vec3(0.5, 0, 0), Vec3::UnitX());
      if (j > 0) touch(k - side, k, p - Vec3(0, 0.5, 0), Vec3::UnitY());
    }
  return problem;
}

contact::ContactProblem box_stack(const std::vector<double>& masses, double mu, double h, double g) {
  contact::ContactProblem problem;
  problem.h = h;
  std::vector<RigidBody> bodies;
  for (std::size_t k = 0; k < masses.size(); ++k) {
    RigidBody body{masses[k], masses[k] / 6 * Mat3::Identity(), Vec3(0, 0, static_cast<double>(k) + 0.5)};
    body.v.z() = -h * g;
    bodies.push_back(body);
    add_body(problem, body);
  }
  for (std::size_t k = 0; k < masses.size(); ++k)
    for (const double x : {-0.5, 0.5})
      for (const double y : {-0.5, 0.5})
        add_contact(problem, bodies, static_cast<int>(k) - 1, static_cast<int>(k), Vec3(x, y, static_cast<double>(k)),
                    frame_of(Vec3::UnitZ()), mu);
  return problem;
}

std::vector<double> growing_masses(int count, double ratio) {
  std::vector<double> masses;
  for (int k = 0; k < count; ++k) masses.push_back(std::pow(ratio, static_cast<double>(k) / (count - 1)));
  return masses;
}

}  // namespace nilas::challenge
