#include "contact/assemble.h"

#include <gtest/gtest.h>

#include "contact/law/contact_frame.h"
#include "contact/measure/measure.h"
#include "contact/solvers/pgs.h"
#include "core/base/error.h"
#include "core/base/random.h"
#include "tests/support/random_vectors.h"

namespace nilas::contact {
namespace assemble_test {

int add_floe(bodies::Bodies& bodies, const Vec3& p, const Vec3& v, const Vec3& w,
             bodies::Motion motion = bodies::Motion::free, const Quat& q = Quat::Identity(),
             const std::string& material = "ice") {
  bodies::BodySpec spec;
  spec.shape = std::make_shared<geometry::Shape>();
  spec.material = material;
  spec.motion = motion;
  spec.mass = 100 + 10 * bodies.size();
  spec.inertia_B = Vec3(20, 30, 45).asDiagonal();
  spec.pose = {q, p};
  spec.v = v;
  spec.w = w;
  return bodies.add(spec);
}

detect::ContactPoint point(int a, int b, const Vec3& p, const Vec3& n, double gap, std::uint64_t key = 1) {
  detect::ContactPoint c;
  c.a = a;
  c.b = b;
  c.p = p;
  c.n = n;
  c.gap = gap;
  c.key = key;
  return c;
}

FrictionTable ice_friction(double restitution = 0) {
  FrictionTable table;
  table.add("ice", "ice", {0.35, 0.30, restitution});
  return table;
}

/// Four floes in a row, with loads. The middle two touch at (1, 0.2, 0.1).
struct TwoFloes {
  bodies::Bodies bodies;
  bodies::Wrenches free = bodies::Wrenches(4);
  FrictionTable friction = ice_friction();
  AssemblySettings settings{.h = 0.01};

  explicit TwoFloes(const std::string& material_of_second = "ice") {
    add_floe(bodies, Vec3(-9, 0, 0), Vec3(1, 1, 1), Vec3(1, 1, 1));
    add_floe(bodies, Vec3(0, 0, 0), Vec3(1, 2, 3), Vec3(0.1, 0.2, 0.3));
    add_floe(bodies, Vec3(2, 0, 0), Vec3(-1, 0, 0), Vec3(0, 0, -0.5), bodies::Motion::free, Quat::Identity(),
             material_of_second);
    add_floe(bodies, Vec3(9, 0, 0), Vec3(1, 1, 1), Vec3(1, 1, 1));
    free[1] = {Vec3(10, 20, 30), Vec3(1, 2, 3)};
  }

  AssembledContacts assemble(double gap, const std::vector<ArticulatedBlock>& articulated = {}) {
    return nilas::contact::assemble(bodies, free, {point(1, 2, Vec3(1, 0.2, 0.1), Vec3::UnitX(), gap, 77)},
                                    friction.resolve(bodies.materials), settings, articulated);
  }
};

TEST(Assemble, TwoFloesByHand) {
  TwoFloes scene;
  const AssembledContacts out = scene.assemble(0.004);
  const ContactProblem& problem = out.problem;
  validate(problem);
  EXPECT_EQ(out.block_of_body, (std::vector<int>{-1, 0, 1, -1}));
  EXPECT_EQ(out.first_articulated_block, 2);
  EXPECT_EQ(problem.num_blocks(), 2);
  EXPECT_EQ(problem.pairs[0].a, 0);
  EXPECT_EQ(problem.pairs[0].b, 1);
  EXPECT_EQ(problem.key[0], 77u);
  EXPECT_EQ(problem.mu[0], 0.30);
  EXPECT_EQ(problem.mu_static[0], 0.35);
  EXPECT_TRUE(std::isinf(problem.force_limit[0]));

  // n = x, t1 = z, t2 = n x t1 = -y
  Mat3 frame;
  frame << 1, 0, 0, 0, 0, -1, 0, 1, 0;
  EXPECT_EQ(out.C[0], frame);

  // arm of the point: A (1, 0.2, 0.1), B (-1, 0.2, 0.1); rows c_i and r x c_i
  MatX rows_a(3, 6), rows_b(3, 6);
  rows_a << -1, 0, 0, 0, -0.1, 0.2, 0, 0, -1, -0.2, 1, 0, 0, 1, 0, -0.1, 0, 1;
  rows_b << 1, 0, 0, 0, 0.1, -0.2, 0, 0, 1, 0.2, 1, 0, 0, -1, 0, 0.1, 0, 1;
  EXPECT_LT((problem.jacobian_a(0) - rows_a).norm(), 1e-15);
  EXPECT_LT((problem.jacobian_b(0) - rows_b).norm(), 1e-15);

  Mat6 mass = Mat6::Zero();
  mass.diagonal() << 110, 110, 110, 20, 30, 45;
  EXPECT_EQ(problem.mass(0), MatX(mass));
  Vec6 momentum;
  momentum << 110 + 0.1, 220 + 0.2, 330 + 0.3, 2 + 0.01, 6 + 0.02, 13.5 + 0.03;
  EXPECT_LT((problem.f.head<6>() - momentum).norm(), 1e-13);
  EXPECT_LT((problem.w - Vec3(0.4, 0, 0)).norm(), 1e-15);

  // u is C^T times the relative velocity of the material points
  const Vec3 v_a = scene.bodies.velocity_at(1, Vec3(1, 0.2, 0.1)), v_b = scene.bodies.velocity_at(2, Vec3(1, 0.2, 0.1));
  VecX v(12);
  v << scene.bodies.v_GB[1], scene.bodies.w_GB[1], scene.bodies.v_GB[2], scene.bodies.w_GB[2];
  EXPECT_LT((contact_velocities(problem, v) - problem.w - frame.transpose() * (v_b - v_a)).norm(), 1e-14);
}

TEST(Assemble, APointThatCrushesHasItsLimitAndDoesNotBounce) {
  TwoFloes scene;
  scene.friction = ice_friction(0.5);
  scene.settings.stabilisation = {.erp = 0.2};
  detect::ContactPoint crush = point(1, 2, Vec3(1, 0.2, 0.1), Vec3::UnitX(), 0, 77);
  crush.force_limit = 300;
  crush.compliance = 0.002;
  detect::ContactPoint rigid = crush;
  rigid.key = 78;
  rigid.force_limit = std::numeric_limits<double>::infinity();
  const ContactProblem problem =
      nilas::contact::assemble(scene.bodies, scene.free, {crush, rigid}, scene.friction.resolve(scene.bodies.materials),
                               scene.settings, {})
          .problem;
  validate(problem);
  EXPECT_EQ(problem.force_limit[0], 300 * 0.01);
  EXPECT_EQ(problem.compliance[0], 0.002);
  EXPECT_EQ(problem.w[0], 0) << "no restitution";
  EXPECT_LT(problem.w[3], -0.1) << "the rigid point beside it bounces";
}

TEST(Assemble, PenetrationHasNoBias) {
  TwoFloes scene;
  EXPECT_EQ(scene.assemble(-0.01).problem.w, VecX::Zero(3));
  EXPECT_EQ(scene.assemble(0).problem.w, VecX::Zero(3));
}

TEST(Assemble, RotatedBodyHasItsInertiaInG) {
  TwoFloes scene;
  scene.bodies.set_pose(1, Vec3::Zero(), Quat(0.5, 0.1, -0.7, 0.3));
  const ContactProblem problem = scene.assemble(0).problem;
  validate(problem);
  const Mat3 inertia = scene.bodies.inertia_G(1);
  EXPECT_LT((problem.mass(0).bottomRightCorner<3, 3>() - inertia).norm(), 1e-14);
  EXPECT_LT((problem.f.segment<3>(3) - inertia * Vec3(0.1, 0.2, 0.3) - 0.01 * Vec3(1, 2, 3)).norm(), 1e-14);
}

TEST(Assemble, RestitutionReplacesTheGapWhereItWouldClose) {
  TwoFloes scene;
  scene.friction = ice_friction(0.5);
  const double before =
      scene.bodies.velocity_at(2, Vec3(1, 0.2, 0.1)).x() - scene.bodies.velocity_at(1, Vec3(1, 0.2, 0.1)).x();
  ASSERT_LT(before, -1.5);
  EXPECT_NEAR(scene.assemble(-0.001).problem.w[0], 0.5 * before, 1e-15);
  EXPECT_NEAR(scene.assemble(0.001).problem.w[0], 0.5 * before, 1e-15);  // The gap closes within the step.
  EXPECT_NEAR(scene.assemble(0.1).problem.w[0], 10, 1e-13);              // The gap does not close within the step.
  scene.settings.restitution_threshold = 3;
  EXPECT_EQ(scene.assemble(-0.001).problem.w[0], 0);
  EXPECT_NEAR(scene.assemble(0.001).problem.w[0], 0.1, 1e-15);
}

TEST(Assemble, FixedSideHasNoBlockAndNoVelocity) {
  TwoFloes scene;
  scene.bodies.motion[1] = bodies::Motion::fixed;
  const AssembledContacts out = scene.assemble(0);
  EXPECT_EQ(out.problem.num_blocks(), 1);
  EXPECT_EQ(out.problem.pairs[0].a, -1);
  EXPECT_EQ(out.problem.pairs[0].b, 0);
  EXPECT_EQ(out.block_of_body, (std::vector<int>{-1, -1, 0, -1}));
  EXPECT_EQ(out.problem.w, VecX::Zero(3));
  validate(out.problem);
}

TEST(Assemble, ArticulatedSideIsReducedAndItsPrescribedMotionGoesToW) {
  for (const int body : {1, 2}) {
    TwoFloes scene;
    scene.bodies.motion[body] = bodies::Motion::articulated;
    ArticulatedBlock block;
    ArticulatedBody& moved = block.bodies.emplace_back();
    moved.body = body;
    block.mass = Eigen::Vector2d(50, 60).asDiagonal();
    block.f = Eigen::Vector2d(5, 6);
    RandomStream random(1, "tree");
    moved.jacobian = MatX::NullaryExpr(6, 2, [&](Eigen::Index, Eigen::Index) { return random.normal(); });
    moved.prescribed << 0.3, -0.2, 0.1, 0.5, 0.6, -0.7;
    const AssembledContacts out = scene.assemble(0.002, {block});
    validate(out.problem);
    // The articulated block comes after the free body's, whatever the order of the bodies.
    EXPECT_EQ(out.first_articulated_block, 1);
    EXPECT_EQ(out.block_of_body[body], 1);
    EXPECT_EQ(out.problem.f.tail<2>(), block.f);

    // u for these speeds must equal u for the twist that they produce.
    const Vec2 speeds(0.8, -0.4);
    const Vec6 twist = moved.jacobian * speeds + moved.prescribed;
    const Vec3 p(1, 0.2, 0.1);
    const auto other = static_cast<std::size_t>(3 - body);
    const Vec3 v_moved = twist.head<3>() + twist.tail<3>().cross(p - scene.bodies.p_GB[body]);
    const Vec3 v_other = scene.bodies.velocity_at(3 - body, p);
    VecX v(8);
    v << scene.bodies.v_GB[other], scene.bodies.w_GB[other], speeds;
    const double sign = body == 2 ? 1 : -1;
    const Vec3 expected = sign * out.C[0].transpose() * (v_moved - v_other) + Vec3(0.2, 0, 0);
    EXPECT_LT((contact_velocities(out.problem, v) - expected).norm(), 1e-14);
  }
}

TEST(Assemble, ABodyWithoutCoordinatesIsPrescribed) {
  TwoFloes scene;
  scene.bodies.motion[2] = bodies::Motion::articulated;
  ArticulatedBlock carried;
  carried.bodies.resize(1);
  carried.bodies[0].body = 2;
  carried.bodies[0].jacobian = MatX(6, 0);
  carried.bodies[0].prescribed << -2, 0, 0, 0, 0, 0.5;
  const AssembledContacts out = scene.assemble(0, {carried});
  EXPECT_EQ(out.problem.num_blocks(), 1);
  EXPECT_EQ(out.problem.pairs[0].b, -1);
  // The velocity of the point (-1, 0.2, 0.1) off the centre is (-2, 0, 0) + (0, 0, 0.5) x r = (-2.1, -0.5, 0).
  EXPECT_LT((out.problem.w - Vec3(-2.1, 0, 0.5)).norm(), 1e-15);
  EXPECT_THROW(scene.assemble(0), ContractError);
}

TEST(Assemble, BodiesOfOneSystemShareABlock) {
  // Both floes belong to one system: their contact and its moments see the difference of their twists.
  TwoFloes scene;
  FrictionPair rolling{0.5, 0.4, 0};
  rolling.rolling = 0.01;
  rolling.spinning = 0.02;
  scene.friction = FrictionTable();
  scene.friction.add("ice", "ice", rolling);
  ArticulatedBlock block;
  RandomStream random(2, "tree");
  const auto draw = [&](Eigen::Index, Eigen::Index) { return random.normal(); };
  for (const int body : {1, 2}) {
    scene.bodies.motion[body] = bodies::Motion::articulated;
    block.bodies.push_back({body, MatX::NullaryExpr(6, 3, draw), MatX::NullaryExpr(6, 1, draw)});
  }
  block.mass = Vec3(50, 60, 70).asDiagonal();
  block.f = Vec3(5, 6, 7);
  const AssembledContacts out = scene.assemble(0.002, {block});
  validate(out.problem);
  ASSERT_EQ(out.problem.num_blocks(), 1);
  EXPECT_EQ(out.block_of_body[1], 0);
  EXPECT_EQ(out.block_of_body[2], 0);
  EXPECT_EQ(out.problem.pairs[0].a, -1);
  EXPECT_EQ(out.problem.pairs[0].b, 0);
  const Vec3 speeds(0.8, -0.4, 0.3), p(1, 0.2, 0.1);
  Vec3 apart = Vec3::Zero(), turning = Vec3::Zero();
  for (const auto& [body, sign] : {std::pair(0, -1.0), std::pair(1, 1.0)}) {
    const ArticulatedBody& one = block.bodies[body];
    const Vec6 twist = one.jacobian * speeds + one.prescribed;
    const Vec3 arm = p - scene.bodies.p_GB[one.body];
    apart += sign * (twist.head<3>() + twist.tail<3>().cross(arm));
    turning += sign * twist.tail<3>();
  }
  VecX expected(6);
  expected << out.C[0].transpose() * apart + Vec3(0.2, 0, 0), out.C[1].transpose() * turning;
  EXPECT_LT((contact_velocities(out.problem, speeds) - expected).norm(), 1e-13);
}

TEST(Assemble, EachPairHasItsOwnFriction) {
  bodies::Bodies bodies;
  for (int k = 0; k < 3; ++k)
    add_floe(bodies, Vec3(k, 0, 0), Vec3::Zero(), Vec3::Zero(), bodies::Motion::free, Quat::Identity(),
             k < 2 ? "ice" : "steel");
  FrictionTable friction = ice_friction();
  FrictionPair rolling{0.5, 0.4, 0};
  rolling.rolling = 0.01;
  friction.add("ice", "steel", rolling);
  const bodies::Wrenches free(3);
  std::vector<detect::ContactPoint> points;
  for (const auto& [a, b] : {std::pair{0, 1}, {0, 2}, {0, 2}, {1, 2}, {0, 1}})
    points.push_back(point(a, b, Vec3(0.5, 0, 0), Vec3::UnitX(), 0, points.size()));
  const ContactProblem problem =
      assemble(bodies, free, points, friction.resolve(bodies.materials), {.h = 0.01}, {}).problem;
  const std::vector<double> kinetic{0.3, 0.4, 0.4, 0.4, 0.3};
  ASSERT_EQ(problem.num_points(), 5);
  for (std::size_t c = 0; c < 5; ++c) {
    EXPECT_EQ(problem.mu[c], kinetic[c]) << c;
    EXPECT_EQ(problem.moment_of(static_cast<int>(c)) >= 0, kinetic[c] == 0.4) << c;
  }
}

TEST(Assemble, UnnamedMaterialsAreFrictionless) {
  TwoFloes scene("rubber");
  EXPECT_EQ(scene.assemble(0).problem.mu[0], 0);
}

TEST(Assemble, ImpulsesBalanceInLinearAndAngularMomentum) {
  RandomStream random(2, "balance");
  const auto vector = [&] {
    const double x = random.normal(), y = random.normal(), z = random.normal();
    return Vec3(x, y, z);
  };
  bodies::Bodies bodies;
  add_floe(bodies, vector(), vector(), vector(), bodies::Motion::free, Quat(0.3, 0.4, 0.5, 0.6));
  add_floe(bodies, vector(), vector(), vector());
  std::vector<detect::ContactPoint> points;
  for (std::uint64_t k = 0; k < 6; ++k) points.push_back(point(0, 1, vector(), vector().normalized(), 0, k));
  FrictionTable friction = ice_friction();
  const AssembledContacts out =
      assemble(bodies, bodies::Wrenches(2), points, friction.resolve(bodies.materials), {.h = 0.01}, {});
  for (int c = 0; c < 6; ++c) {
    const Vec3 r = vector();
    const Vec6 on_a = out.problem.jacobian_a(c).transpose() * r, on_b = out.problem.jacobian_b(c).transpose() * r;
    EXPECT_LT((on_b.head<3>() - out.C[c] * r).norm(), 1e-14);
    EXPECT_LT((on_a.head<3>() + on_b.head<3>()).norm(), 1e-14);
    const Vec3 angular =
        on_a.tail<3>() + bodies.p_GB[0].cross(on_a.head<3>()) + on_b.tail<3>() + bodies.p_GB[1].cross(on_b.head<3>());
    EXPECT_LT(angular.norm(), 1e-14);
  }
}

TEST(Assemble, ABallBouncesToItsHeight) {
  bodies::Bodies bodies;
  const int ground = add_floe(bodies, Vec3(0, 0, -1), Vec3::Zero(), Vec3::Zero(), bodies::Motion::fixed);
  const int ball = add_floe(bodies, Vec3(0, 0, 0.5), Vec3(0, 0, -2), Vec3::Zero());
  FrictionTable friction = ice_friction(0.8);
  const std::vector<detect::ContactPoint> points{point(ground, ball, Vec3::Zero(), Vec3::UnitZ(), 0.001)};
  const AssembledContacts out =
      assemble(bodies, bodies::Wrenches(2), points, friction.resolve(bodies.materials), {.h = 0.01}, {});
  const ContactSolution s = solvers::PgsSolver({}).solve(out.problem, {});
  EXPECT_NEAR(s.v[2], 1.6, 1e-14);
}

// --- contact frames

TEST(ContactFrame, IsOrthonormalAndRightHanded) {
  RandomStream random(3, "frames");
  for (int k = 0; k < 500; ++k) {
    const Vec3 n = Vec3(random.normal(), random.normal(), random.normal()).normalized();
    const Quat q(random.normal(), random.normal(), random.normal(), random.normal());
    const Mat3 C = contact_frame(n, q.normalized().matrix(), k % 2 == 0 ? 0 : random.uniform(-3, 3));
    EXPECT_EQ(C.col(0), n);
    EXPECT_LT((C.transpose() * C - Mat3::Identity()).norm(), 1e-14);
    EXPECT_NEAR(C.determinant(), 1, 1e-14);
  }
}

TEST(ContactFrame, SideContactsOfPlatesHaveTheirFirstTangentUp) {
  for (int k = 0; k < 360; ++k) {
    const Vec3 n(std::cos(k * k_deg), std::sin(k * k_deg), 0.05 * std::sin(7.0 * k));
    const Mat3 C = contact_frame(n.normalized(), Mat3::Identity(), 0);
    EXPECT_GT(C(2, 1), 0.99) << k;
  }
}

TEST(ContactFrame, TurnsWithTheBodyAndWithTheAxes) {
  const Vec3 n = Vec3(0.3, -0.9, 0.2).normalized();
  const Mat3 R = Quat(0.2, 0.7, -0.1, 0.4).normalized().matrix();
  const Mat3 body = Quat(0.9, 0.1, 0.2, -0.3).normalized().matrix();
  EXPECT_LT((contact_frame(R * n, R * body, 0.4) - R * contact_frame(n, body, 0.4)).norm(), 1e-14);
  const Mat3 plain = contact_frame(n, body, 0), turned = contact_frame(n, body, k_pi / 2);
  EXPECT_LT((turned.col(1) - plain.col(2)).norm(), 1e-15);
  EXPECT_LT((turned.col(2) + plain.col(1)).norm(), 1e-15);
}

TEST(ContactFrame, MirroredScenesHaveMirroredTangentsToTheBit) {
  RandomStream random(4, "mirror");
  const Mat3 S = Vec3(1, -1, 1).asDiagonal();
  for (int k = 0; k < 500; ++k) {
    const bool level = k % 2 == 0;  // Level plates have exact ties.
    const double angle = random.uniform(0, 2 * k_pi);
    const Vec3 n = Vec3(std::cos(angle), std::sin(angle), level ? 0 : random.normal()).normalized();
    const Mat3 R = level ? Mat3(Mat3::Identity()) : test::random_attitude(random).matrix();
    const Mat3 C = contact_frame(n, R, 0), mirrored = contact_frame(S * n, S * R * S, 0);
    for (int axis = 1; axis < 3; ++axis) {
      const Vec3 image = S * C.col(axis);
      EXPECT_TRUE(mirrored.col(axis) == image || mirrored.col(axis) == -image) << k;
    }
  }
}

}  // namespace assemble_test
}  // namespace nilas::contact
