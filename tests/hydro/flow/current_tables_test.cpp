#include "hydro/flow/current_tables.h"

#include <gtest/gtest.h>

#include <memory>

#include "core/bodies/bodies.h"
#include "core/geometry/mass_properties.h"
#include "hydro/modules.h"
#include "tests/support/refusal.h"
#include "tests/support/scratch_folder.h"

namespace nilas::hydro {

namespace current_tables_test {

constexpr const char* k_profile = "z_m,u_m_s,v_m_s\n0,0.5,0\n-1,0.3,0.1\n-3,0.1,0.1\n";

TEST(CurrentTables, ProfileIsLinearBetweenAndConstantBeyond) {
  const test::ScratchFolder folder;
  const std::string falling = folder.write("falling.csv", k_profile).string();
  const std::string growing =
      folder.write("growing.csv", "v_m_s,z_m,u_m_s\n0.1,-3,0.1\n0.1,-1,0.3\n0,0,0.5\n").string();
  const double level = 0.2;
  for (const std::string& file : {falling, growing}) {
    const CurrentProfile profile(read_current_profile(file), level);
    const auto at = [&](double z) { return profile.velocity({7, -3, z + level}, 11); };
    EXPECT_LT((at(1) - Vec3(0.5, 0, 0)).norm(), 1e-15);
    EXPECT_LT((at(0) - Vec3(0.5, 0, 0)).norm(), 1e-15);
    EXPECT_LT((at(-0.25) - Vec3(0.45, 0.025, 0)).norm(), 1e-15);
    EXPECT_LT((at(-1) - Vec3(0.3, 0.1, 0)).norm(), 1e-15);
    EXPECT_LT((at(-2.5) - Vec3(0.15, 0.1, 0)).norm(), 1e-15);
    EXPECT_LT((at(-9) - Vec3(0.1, 0.1, 0)).norm(), 1e-15);
  }
}

TEST(CurrentTables, SeriesIsHeldBeyondItsEnds) {
  const test::ScratchFolder folder;
  const CurrentSeries series(
      read_current_series(folder.write("tide.csv", "t_s,u_m_s,v_m_s\n10,0,0\n20,0.4,-0.2\n40,-0.4,0\n").string()));
  const auto at = [&](double t) { return series.velocity({1, 2, 3}, t); };
  EXPECT_EQ(at(-5), Vec3::Zero());
  EXPECT_LT((at(15) - Vec3(0.2, -0.1, 0)).norm(), 1e-15);
  EXPECT_LT((at(30) - Vec3(0, -0.1, 0)).norm(), 1e-15);
  EXPECT_LT((at(99) - Vec3(-0.4, 0, 0)).norm(), 1e-15);
}

/// Froude's law: lengths by 16, times and velocities by 4. These are powers of two, so the bits are the same.
TEST(CurrentTables, ScaleByFroude) {
  const test::ScratchFolder folder;
  const std::string profile = folder.write("p.csv", k_profile).string();
  const std::string series = folder.write("s.csv", "t_s,u_m_s,v_m_s\n0,0.1,0\n7,0.3,-0.2\n").string();
  for (const double x : {-2.2, -0.3, 0.7, 3.1, 6.0}) {
    EXPECT_EQ(read_current_profile(profile, 16).at(16 * x), Vec2(4 * read_current_profile(profile).at(x)));
    EXPECT_EQ(read_current_series(series, 16).at(4 * x), Vec2(4 * read_current_series(series).at(x)));
  }
}

TEST(CurrentTables, GreatestIsTheFirstOfTheLargest) {
  const VelocityTable table({0, 1, 2}, {{0.1, 0}, {0, -0.5}, {0.5, 0}});
  EXPECT_EQ(table.greatest(), Vec2(0, -0.5));
}

TEST(CurrentTables, WrongTablesAreRefusedWithTheirPlace) {
  const test::ScratchFolder folder;
  const auto profile = [&](const std::string& text) {
    return [file = folder.write("p.csv", text).string()] { read_current_profile(file); };
  };
  test::expect_refusal(profile("z_m,u,v\n0,1,0\n"), {"p.csv:1:5", "unknown column 'u'", "z_m,u_m_s,v_m_s"});
  test::expect_refusal(profile("z_m,u_m_s,v_m_s\n0,1,0\n-1,fast,0\n"), {"p.csv:3:4", "'fast'"});
  test::expect_refusal(profile("z_m,u_m_s,v_m_s\n0,1\n"), {"p.csv:2:3", "found 2 fields"});
  test::expect_refusal(profile("z_m,u_m_s,v_m_s\n0,1,0\n-1,1,0\n-1,2,0\n"), {"p.csv:4", "z_m must fall"});
  test::expect_refusal(profile("z_m,u_m_s,v_m_s\n-2,1,0\n-1,1,0\n-3,2,0\n"), {"p.csv:4", "z_m must grow"});
  test::expect_refusal(profile("z_m,u_m_s,v_m_s\n"), {"no rows"});
  const auto series = [&](const std::string& text) {
    return [file = folder.write("s.csv", text).string()] { read_current_series(file); };
  };
  test::expect_refusal(series("t_s,u_m_s,v_m_s\n5,1,0\n4,1,0\n"), {"s.csv:3", "t_s must grow from row to row"});
  test::expect_refusal<FileError>([] { read_current_series("/nowhere/tide.csv"); }, {"/nowhere/tide.csv"});
}

/// A cube of side s afloat with its whole depth in u = u0 (1 + z / H) has the force at rest that follows from the
/// centroids of its faces: form 0.5 rho C_f s^2 u(-s/2)^2, and skin on the sides and the bottom.
TEST(CurrentTables, FloeSeesTheProfileOverItsDepth) {
  const test::ScratchFolder folder;
  const double s = 2, u0 = 0.8, H = 10;
  Water water;
  water.flows.push_back(std::make_shared<CurrentProfile>(
      read_current_profile(folder.write("p.csv", "z_m,u_m_s,v_m_s\n0,0.8,0\n-10,0,0\n").string()), 0.0));
  bodies::BodySpec spec;
  spec.kind = bodies::BodyKind::floe;
  spec.shape = std::make_shared<const geometry::Shape>(
      geometry::prism_shape({{-s / 2, -s / 2}, {s / 2, -s / 2}, {s / 2, s / 2}, {-s / 2, s / 2}}, s));
  spec.mass = 900 * s * s * s;
  spec.pose = {Quat::Identity(), {0, 0, -s / 2}};
  bodies::Bodies bodies;
  bodies.add(spec);
  const DragCoefficients c{1.1, 0.01};
  bodies::Wrenches out(1);
  make_drag(water, c, 1)->add_forces(bodies, 0, out);
  const auto u = [&](double z) { return u0 * (1 + z / H); };
  const double q = 0.5 * water.density * s * s;
  const double form = q * c.form * u(-s / 2) * u(-s / 2);
  const double sides = 2 * q * c.skin * u(-s / 2) * u(-s / 2), bottom = q * c.skin * u(-s) * u(-s);
  // The deck lies in the surface and counts as wet or dry by rounding.
  const double deck = q * c.skin * u0 * u0;
  EXPECT_GT(out[0].force.x(), form + sides + bottom - 1e-9);
  EXPECT_LT(out[0].force.x(), form + sides + bottom + deck + 1e-9);
}

/// A floe that drifts freely takes the speed of the water, as in a uniform current: m v' = k (U - v)^2, so the lag
/// U - v = U / (1 + k U t / m). A thin plate on edge, with form drag only, in a series that is constant.
TEST(CurrentTables, FloeTakesTheSpeedOfTheWater) {
  const double U = 0.5, form = 1.2;
  Water water;
  water.flows.push_back(std::make_shared<CurrentSeries>(VelocityTable({0, 1000}, {{U, 0}, {U, 0}})));
  bodies::BodySpec spec;
  spec.kind = bodies::BodyKind::floe;
  spec.shape = std::make_shared<const geometry::Shape>(
      geometry::prism_shape({{-1.5, -1}, {1.5, -1}, {1.5, 1}, {-1.5, 1}}, 0.05));
  spec.mass = 900 * 6 * 0.05;
  spec.pose = {Quat(Eigen::AngleAxisd(k_pi / 2, Vec3::UnitY())), {0, 0, -50}};
  bodies::Bodies bodies;
  bodies.add(spec);
  const auto drag = make_drag(water, {form, 0}, 1);
  const double k = 0.5 * water.density * form * 6, h = 1e-3;
  const auto force = [&](double v, double t) {
    bodies.v_GB[0] = {v, 0, 0};
    bodies::Wrenches out(1);
    drag->add_forces(bodies, t, out);
    return out[0].force.x() / spec.mass;
  };
  double v = 0;
  for (int step = 0; step < 2000; ++step) {
    const double t = step * h;
    v += h * force(v + 0.5 * h * force(v, t), t + 0.5 * h);
  }
  EXPECT_NEAR(U - v, U / (1 + k * U * 2 / spec.mass), 1e-5 * U);
}

}  // namespace current_tables_test

}  // namespace nilas::hydro
