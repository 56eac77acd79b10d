#include "contact/challenge/challenge_bodies.h"

#include <cmath>
#include <cstdint>

namespace nilas::challenge {

Mat6 mass_matrix(const RigidBody& body) {
  Mat6 m = Mat6::Zero();
  m.diagonal().head<3>().setConstant(body.mass);
  m.bottomRightCorner<3, 3>() = body.inertia;
  return m;
}

int add_body(contact::ContactProblem& problem, const RigidBody& body) {
  const int block = problem.add_block(mass_matrix(body));
  Vec6 twist;
  twist << body.v, body.w;
  problem.f.tail<6>() = mass_matrix(body) * twist;
  return block;
}

Mat3 frame_of(const Vec3& n, double turn) {
  const Vec3 axis = std::abs(n.z()) < 0.9 ? Vec3::UnitZ() : Vec3::UnitX();
  const Vec3 t1 = (axis - axis.dot(n) * n).normalized();
  const Vec3 t2 = n.cross(t1);
  Mat3 frame;
  frame << n, std::cos(turn) * t1 + std::sin(turn) * t2, std::cos(turn) * t2 - std::sin(turn) * t1;
  return frame;
}

MatX body_rows(const Mat3& frame, const Vec3& point, const Vec3& p, double sign) {
  MatX rows(3, 6);
  rows << sign * frame.transpose(), -sign * frame.transpose() * skew(point - p);
  return rows;
}

int add_contact(contact::ContactProblem& problem, const std::vector<RigidBody>& bodies, int a, int b, const Vec3& point,
                const Mat3& frame, double mu) {
  const auto rows = [&](int body, double sign) -> MatX {
    if (body < 0) return MatX(3, 0);
    return body_rows(frame, point, bodies[body].p, sign);
  };
  const int c =
      problem.add_contact(a, rows(a, -1), b, rows(b, 1), static_cast<std::uint64_t>(problem.pairs.size()) + 1);
  problem.mu.back() = mu;
  problem.mu_static.back() = mu;
  return c;
}

Vec3 random_vector(RandomStream& random) {
  const double x = random.normal(), y = random.normal(), z = random.normal();
  return {x, y, z};
}

}  // namespace nilas::challenge
