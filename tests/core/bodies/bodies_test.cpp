#include "core/bodies/bodies.h"

#include <gtest/gtest.h>

#include "core/base/error.h"
#include "tests/core/bodies/solids.h"
#include "tests/support/random_vectors.h"

namespace nilas::bodies {
namespace bodies_test {

BodySpec floe(const std::string& name) {
  BodySpec spec;
  spec.name = name;
  spec.kind = BodyKind::floe;
  spec.shape = std::make_shared<const geometry::Shape>(geometry::box_shape({2, 1, 0.5}));
  const geometry::MassProperties p = geometry::box_properties({2, 1, 0.5}, 900);
  spec.mass = p.mass;
  spec.inertia_B = p.inertia;
  return spec;
}

TEST(Bodies, IdsGrowFromOneWithTheIndex) {
  Bodies bodies;
  EXPECT_EQ(bodies.size(), 0);
  for (int i = 0; i < 5; ++i) EXPECT_EQ(bodies.add(floe("floe " + std::to_string(i))), i);
  EXPECT_EQ(bodies.size(), 5);
  EXPECT_EQ(bodies.id, (std::vector<std::int64_t>{1, 2, 3, 4, 5}));
  EXPECT_EQ(bodies.name[3], "floe 3");
  EXPECT_TRUE(bodies.is_free(4));
}

TEST(Bodies, ThoseThatStayKeepTheirOrderAndIdsAreNotUsedAgain) {
  Bodies bodies;
  for (int k = 0; k < 4; ++k) {
    BodySpec spec = floe(std::to_string(k));
    spec.pose.p.x() = k;
    bodies.add(spec);
  }
  bodies.remove({0, 1, 0, 1});
  EXPECT_EQ(bodies.id, (std::vector<std::int64_t>{1, 3}));
  EXPECT_EQ(bodies.name, (std::vector<std::string>{"0", "2"}));
  EXPECT_EQ(bodies.p_GB[1].x(), 2);
  EXPECT_EQ(bodies.inertia_inverse_B.size(), 2u);
  EXPECT_EQ(bodies.add(floe("new")), 2);
  EXPECT_EQ(bodies.id.back(), 5);
  EXPECT_EQ(bodies.index_of(5), 2u);
  EXPECT_THROW(bodies.index_of(4), ContractError);
  EXPECT_THROW(bodies.remove({1}), ContractError);
}

TEST(Bodies, PoseIsNormalisedAndTheMatrixFollows) {
  Bodies bodies;
  BodySpec spec = floe("turned");
  spec.pose.q = Quat(2, 0, 0, 2);  // a quarter turn about z, not unit
  spec.pose.p = {1, 2, 3};
  bodies.add(spec);
  EXPECT_NEAR(bodies.q_GB[0].norm(), 1, 1e-15);
  EXPECT_NEAR((bodies.R_GB[0] * Vec3(1, 0, 0) - Vec3(0, 1, 0)).norm(), 0, 1e-15);
  bodies.set_pose(0, {4, 5, 6}, Quat(0, 3, 0, 0));
  EXPECT_EQ(bodies.p_GB[0], Vec3(4, 5, 6));
  EXPECT_NEAR((bodies.R_GB[0] * Vec3(0, 1, 0) - Vec3(0, -1, 0)).norm(), 0, 1e-15);
}

/// Invariants of a turned tensor, its inverse, and rotational energy seen in both frames.
TEST(Bodies, InertiaTurnsWithTheBody) {
  RandomStream random(21, "attitudes");
  Bodies bodies;
  bodies.add(floe("floe"));
  for (int i = 0; i < 50; ++i) {
    const Quat q = test::random_attitude(random);
    bodies.set_pose(0, Vec3::Zero(), q);
    const Mat3 inertia = bodies.inertia_G(0), &own = bodies.inertia_B[0];
    EXPECT_NEAR(inertia.trace(), own.trace(), 1e-12 * own.trace());
    EXPECT_NEAR(inertia.determinant(), own.determinant(), 1e-12 * own.determinant());
    EXPECT_LE((inertia * bodies.inertia_inverse_G(0) - Mat3::Identity()).norm(), 1e-13);
    const Vec3 w(random.normal(), random.normal(), random.normal()), w_B = q.conjugate() * w;
    EXPECT_NEAR(w.dot(inertia * w), w_B.dot(own * w_B), 1e-12 * own.trace() * w.squaredNorm());
  }
}

TEST(Bodies, VelocityOfABodyPoint) {
  Bodies bodies;
  BodySpec spec = floe("spinning");
  spec.pose.p = {10, 0, 0};
  spec.v = {1, 0, 0.5};
  spec.w = {0, 0, 2};
  bodies.add(spec);
  EXPECT_EQ(bodies.velocity_at(0, {10, 0, 0}), Vec3(1, 0, 0.5));
  EXPECT_EQ(bodies.velocity_at(0, {11, 0, 0}), Vec3(1, 2, 0.5));
  EXPECT_EQ(bodies.velocity_at(0, {10, 1, 7}), Vec3(-1, 0, 0.5));
}

TEST(Bodies, FixedBodiesNeedNoMassAndDoNotTurn) {
  Bodies bodies;
  BodySpec wall = floe("wall");
  wall.motion = Motion::fixed;
  wall.mass = 0;
  wall.inertia_B.setZero();
  bodies.add(wall);
  EXPECT_FALSE(bodies.is_free(0));
  EXPECT_EQ(bodies.inertia_inverse_G(0), Mat3::Zero());
}

TEST(Bodies, WrongSpecsBreakTheContractAndLeaveNothing) {
  const double nan = std::nan("");
  std::vector<BodySpec> wrong(9, floe("wrong"));
  wrong[0].shape = nullptr;
  wrong[1].mass = 0;
  wrong[2].mass = nan;
  wrong[3].inertia_B = Vec3(1, 1, 3).asDiagonal();
  wrong[4].inertia_B(0, 0) = nan;
  wrong[5].pose.p.x() = nan;
  wrong[6].pose.q = Quat(0, 0, 0, 0);
  wrong[7].v.y() = INFINITY;
  wrong[8].w.z() = nan;
  Bodies bodies;
  for (const auto& spec : wrong) EXPECT_THROW(bodies.add(spec), ContractError);
  EXPECT_EQ(bodies.size(), 0);
  EXPECT_TRUE(bodies.mass.empty());
}

}  // namespace bodies_test
}  // namespace nilas::bodies
