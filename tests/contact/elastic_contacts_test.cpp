#include "contact/elastic_contacts.h"

#include <gtest/gtest.h>

#include "core/base/error.h"
#include "core/geometry/shape.h"

namespace nilas::contact {
namespace elastic_contacts_test {

constexpr double k_step = 0.01, k_stiffness = 4e4;

bodies::BodySpec box(const std::string& name, const Vec3& p, bool fixed) {
  bodies::BodySpec spec;
  spec.name = name;
  spec.motion = fixed ? bodies::Motion::fixed : bodies::Motion::free;
  spec.material = "steel";
  spec.shape = std::make_shared<const geometry::Shape>(geometry::box_shape(Vec3(1, 1, 1)));
  spec.mass = 2;
  spec.inertia_B = 0.3 * Mat3::Identity();
  spec.pose.p = p;
  return spec;
}

struct Two {
  bodies::Bodies bodies;
  FrictionPairs friction;
  ElasticContacts contacts;

  explicit Two(double damping_ratio = 0) {
    bodies.add(box("below", Vec3::Zero(), true));
    bodies.add(box("above", Vec3(0, 0, 1), false));
    FrictionTable table;
    FrictionPair pair{0.5, 0.5};
    pair.elastic = Elasticity{k_stiffness, 0.5, 0.8, damping_ratio};
    table.add("steel", "steel", pair);
    friction = table.resolve(bodies.materials);
  }
  detect::ContactPoint point(std::uint64_t key, double gap, int part = 0) const {
    detect::ContactPoint c;
    c.a = 0;
    c.b = 1;
    c.part_b = part;
    c.n = Vec3::UnitZ();
    c.p = Vec3(0, 0, 0.5);
    c.gap = gap;
    c.key = key;
    return c;
  }
  std::vector<Spring> springs(const std::vector<detect::ContactPoint>& points) const {
    return contacts.springs(bodies, points, friction, std::vector<double>(2, 0.0));
  }
  /// Keeps these points with this stretch.
  void keep(const std::vector<detect::ContactPoint>& points, const Vec3& stretch) {
    contacts.keep(bodies, points, springs(points), std::vector<SpringStep>(points.size(), {true, stretch}));
  }
};

TEST(ElasticContacts, PointsOfAPatchShareItsStiffness) {
  const Two two;
  const auto springs = two.springs({two.point(1, -0.1), two.point(2, 0), two.point(3, 0, 1)});
  EXPECT_EQ(springs[0].normal, k_stiffness / 2);
  EXPECT_EQ(springs[1].normal, k_stiffness / 2);
  EXPECT_EQ(springs[2].normal, k_stiffness);
  EXPECT_EQ(springs[2].tangential, 0.8 * k_stiffness);
}

TEST(ElasticContacts, PointsThatCrushAndPairsOfRigidBodiesHaveNone) {
  Two two;
  detect::ContactPoint crush = two.point(1, 0);
  crush.force_limit = 7;
  const auto springs = two.springs({crush, two.point(2, 0)});
  EXPECT_FALSE(springs[0].exists());
  EXPECT_EQ(springs[1].normal, k_stiffness);
  FrictionTable table;
  FrictionPair pair;
  pair.elastic = Elasticity{0, 0.5, 0.8, 0};
  table.add("*", "*", pair);
  two.friction = table.resolve(two.bodies.materials);
  EXPECT_FALSE(two.springs({two.point(1, 0)})[0].exists());
  const auto of_ice = two.contacts.springs(two.bodies, {two.point(1, 0)}, two.friction, {0, 3e6});
  EXPECT_EQ(of_ice[0].normal, 0.5 * 3e6);
  const auto of_two = two.contacts.springs(two.bodies, {two.point(1, 0)}, two.friction, {6e6, 3e6});
  EXPECT_NEAR(of_two[0].normal, 0.5 * 2e6, 1e-9);
}

TEST(ElasticContacts, AnOverlapOfANewPatchIsAtRestAndDoesNotComeBack) {
  Two two;
  const auto at = [&](double gap) {
    const auto points = std::vector{two.point(1, gap)};
    const Spring spring = two.springs(points)[0];
    two.contacts.keep(two.bodies, points, {spring}, {{true}});
    return spring.compression(gap);
  };
  EXPECT_EQ(at(-0.03), 0);
  EXPECT_NEAR(at(-0.04), 0.01, 1e-17);
  EXPECT_NEAR(at(-0.02), 0, 1e-17) << "less overlap: the rest follows";
  EXPECT_NEAR(at(-0.04), 0.02, 1e-17);
  EXPECT_NEAR(at(0.01), -0.01, 1e-17);
  EXPECT_NEAR(at(-0.04), 0.04, 1e-17);
}

TEST(ElasticContacts, NewPointsOfAKnownPatchTakeOverRestAndStretch) {
  Two two;
  two.keep({two.point(1, -0.01), two.point(2, -0.02)}, Vec3(0.003, 0, 0));
  const auto springs = two.springs({two.point(3, -0.05)});
  EXPECT_EQ(springs[0].rest, 0.01);
  EXPECT_NEAR((springs[0].stretch - Vec3(0.003, 0, 0)).norm(), 0, 1e-17);
  EXPECT_EQ(two.springs({two.point(3, -0.05, 1)})[0].rest, 0.05) << "another patch";
}

TEST(ElasticContacts, TheStretchTurnsWithTheBodies) {
  Two two;
  two.keep({two.point(1, 0)}, Vec3(0.003, 0, 0));
  for (int b = 0; b < 2; ++b) two.bodies.set_pose(b, two.bodies.p_GB[b], Quat(Eigen::AngleAxisd(0.3, Vec3::UnitZ())));
  const Vec3 both = two.springs({two.point(1, 0)})[0].stretch;
  EXPECT_NEAR((both - 0.003 * Vec3(std::cos(0.3), std::sin(0.3), 0)).norm(), 0, 1e-17);
  two.bodies.set_pose(0, two.bodies.p_GB[0], Quat::Identity());
  const Vec3 mean = two.springs({two.point(1, 0)})[0].stretch;
  EXPECT_NEAR((mean - 0.003 * Vec3(std::cos(0.15), std::sin(0.15), 0)).norm(), 0, 1e-17);
}

TEST(ElasticContacts, RowsAreAnImplicitStepOfSpringAndDashpot) {
  const Spring spring{4e4, 3e4, 0.02, 0.001, Vec3(0.002, 0.001, 0)};
  Mat3 C;
  C.col(0) = Vec3::UnitZ();
  C.col(1) = Vec3::UnitX();
  C.col(2) = Vec3::UnitY();
  const double gap = -0.005;
  const SpringRow row = spring_row(spring, gap, C, k_step);
  const Vec3 u(-0.1, 0.03, -0.02);
  // where the law's velocities are zero, spring and dashpot give the force at the step's end
  const double r_n = -(u[0] + row.bias[0]) / row.compliance;
  EXPECT_NEAR(r_n / k_step, 4e4 * (0.004 + k_step * 0.1 + 0.02 * 0.1), 1e-9);
  for (int i = 1; i < 3; ++i) {
    const double r_t = -(u[i] + row.bias[i]) / row.tangential_compliance;
    EXPECT_NEAR(r_t / k_step, -3e4 * (spring.stretch[i - 1] + k_step * u[i] + 0.02 * u[i]), 1e-9);
  }
  EXPECT_EQ(spring_row(spring, 0.004, C, k_step).bias[0], 0.005 / k_step) << "a gap closes first";
}

TEST(ElasticContacts, WorkOfAStepIsStoredOrLost) {
  const Spring spring{4e4, 3e4, 0.02, 0, Vec3(0.002, 0, 0)};
  Mat3 C;
  C.col(0) = Vec3::UnitZ();
  C.col(1) = Vec3::UnitX();
  C.col(2) = Vec3::UnitY();
  const double gap = -0.005, before = 0.5 * (4e4 * 0.005 * 0.005 + 3e4 * 0.002 * 0.002);
  const SpringRow row = spring_row(spring, gap, C, k_step);
  const Vec3 u(-0.1, 0.03, 0);
  const double r_n = -(u[0] + row.bias[0]) / row.compliance, r_t = -(u[1] + row.bias[1]) / row.tangential_compliance;
  const SpringStep stick = spring_step(spring, gap, C, k_step, {r_n, r_t, 0}, u, 1e9, 1);
  EXPECT_NEAR((stick.stretch - Vec3(0.0023, 0, 0)).norm(), 0, 1e-17);
  EXPECT_NEAR(stick.stored, 0.5 * (4e4 * 0.006 * 0.006 + 3e4 * 0.0023 * 0.0023), 1e-12);
  EXPECT_EQ(stick.friction, 0);
  // -r.u = change + dashpots + k x^2/2, which is the implicit step's
  const double implicit = 0.5 * (4e4 * 0.001 * 0.001 + 3e4 * 0.0003 * 0.0003);
  EXPECT_NEAR(-(r_n * u[0] + r_t * u[1]), stick.stored - before + stick.damping + implicit, 1e-12);
  // at the friction bound: the stretch that bears it, and slip for the rest of the motion
  const double bound = 0.4;
  const SpringStep slip = spring_step(spring, gap, C, k_step, {r_n, -bound, 0}, u, bound, 1);
  const double rate = (bound / k_step / 3e4 - 0.002) / (k_step + 0.02);
  EXPECT_NEAR(slip.stretch[0], 0.002 + k_step * rate, 1e-15);
  EXPECT_NEAR(slip.friction, bound * (0.03 - rate), 1e-15);
  // an impulse that the solver's tolerance leaves at an open contact does not stretch it
  const SpringStep loose = spring_step({4e4, 3e4}, 0, C, k_step, {1e-9, 1e-10, 0}, {0, 0.5, 0}, 1e-9, 1);
  EXPECT_LT(loose.stretch.norm(), 1e-11);
  // nor does it let a contact creep that sticks: the stretch follows the motion
  const SpringStep nearly = spring_step(spring, gap, C, k_step, {r_n, r_t + 1e-6, 0}, u, 1e9, 1);
  EXPECT_EQ(nearly.stretch, stick.stretch);
  const SpringStep open = spring_step(spring, gap, C, k_step, Vec3::Zero(), {0.6, 0, 0}, 0, 1);
  EXPECT_EQ(open.stored, 0);
  EXPECT_NEAR(open.damping, before, 1e-12) << "what it still held is lost";
}

TEST(ElasticContacts, StateGoesOnFromACheckpoint) {
  Two two;
  two.keep({two.point(1, -0.01), two.point(2, -0.02), two.point(5, 0, 1)}, Vec3(0.003, 1e-4, 0));
  State state;
  two.contacts.save(StateWriter(state, "elastic/"));
  Two other;
  other.contacts.restore(StateReader(state, "elastic/"));
  for (const auto& point : {two.point(1, -0.03), two.point(9, -0.03), two.point(9, -0.03, 1)}) {
    const Spring one = two.springs({point})[0], same = other.springs({point})[0];
    EXPECT_EQ(one.rest, same.rest);
    EXPECT_EQ(one.stretch, same.stretch);
  }
}

}  // namespace elastic_contacts_test
}  // namespace nilas::contact
