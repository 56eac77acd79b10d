#include "core/output/tables/contact_rows.h"

#include <gtest/gtest.h>

#include "core/output/tables/contacts_h5.h"
#include "tests/core/output/sample_run.h"

namespace nilas::output {
namespace contact_rows_test {

/// Bodies of sample_bodies(): 0 a free floe of 10 kg, 1 a fixed floe, 2 the vessel of 1500 kg, 3 a wall.
contact::SolvedProblem touching(const std::vector<std::pair<int, int>>& pairs) {
  const bodies::Bodies bodies = test::sample_bodies();
  const auto body = [&](int b) -> contact::TouchingBody {
    const auto k = static_cast<std::size_t>(b);
    return {bodies.id[k], bodies.motion[k] == bodies::Motion::fixed ? 0 : 1 / bodies.mass[k]};
  };
  contact::SolvedProblem solved;
  const auto n = static_cast<Eigen::Index>(pairs.size());
  solved.solution.r = solved.solution.u = VecX::Zero(3 * n);
  for (const auto& [a, b] : pairs) {
    detect::ContactPoint point;
    point.a = a;
    point.b = b;
    point.part_a = 4;
    point.part_b = 7;
    point.p = Vec3(1, 2, 3);
    point.n = Vec3(0, 0.6, 0.8);
    point.gap = -1e-4;
    point.key = 0xffff000000000001;
    solved.points.push_back(point);
    solved.touching.push_back({body(a), body(b)});
    solved.impulses.emplace_back(0.1, 0.2, 0.3);
    solved.problem.mu.push_back(0.5);
    solved.problem.force_limit.push_back(std::numeric_limits<double>::infinity());
    solved.problem.compliance.push_back(0);
    solved.problem.tangential_compliance.push_back(0);
  }
  return solved;
}

LoadedBodies vessel_only(const Vec3& com_V = Vec3::Zero()) {
  LoadedBodies loaded;
  loaded.vessel = 2;
  loaded.com_V = com_V;
  return loaded;
}

TEST(ContactRows, ForceAndNormalPointIntoTheVesselWhicheverSideItIs) {
  contact::SolvedProblem solved = touching({{0, 2}, {2, 3}, {0, 1}});
  solved.couples.assign(3, Vec3(1, 0, 0));
  const auto rows = contact_rows(solved, vessel_only(), false);
  ASSERT_EQ(rows.size(), 2u) << "two floes touching are no contact of the hull";
  EXPECT_EQ(rows[0].body, 3);
  EXPECT_EQ(rows[0].other, 1);
  EXPECT_EQ(rows[0].n, Vec3(0, 0.6, 0.8));
  EXPECT_EQ(rows[0].impulse, Vec3(0.1, 0.2, 0.3));
  EXPECT_EQ(rows[0].couple, Vec3(1, 0, 0));
  EXPECT_EQ(rows[0].part, 8);
  EXPECT_EQ(rows[0].other_part, 5);
  EXPECT_EQ(rows[1].body, 3);
  EXPECT_EQ(rows[1].other, 4);
  EXPECT_EQ(rows[1].n, -Vec3(0, 0.6, 0.8));
  EXPECT_EQ(rows[1].impulse, -Vec3(0.1, 0.2, 0.3));
  EXPECT_EQ(rows[1].couple, -Vec3(1, 0, 0));
  EXPECT_EQ(rows[1].part, 5);
  EXPECT_EQ(rows[1].key, 0xffff000000000001);
  EXPECT_EQ(contact_rows(solved, vessel_only(), true).size(), 3u);
  const auto ice_only = contact_rows(solved, {}, true);
  EXPECT_EQ(ice_only[2].body, 2) << "without a vessel the force acts on the higher id";
}

TEST(ContactRows, PointsStandInTheFrameOfTheHull) {
  contact::SolvedProblem solved = touching({{0, 2}});
  solved.vessel_p = Vec3(1, 0, 3);
  solved.vessel_R = Eigen::AngleAxisd(0.5 * k_pi, Vec3::UnitZ()).toRotationMatrix();
  const auto rows = contact_rows(solved, vessel_only(Vec3(2.5, 0, 0.25)), false);
  EXPECT_LT((rows.at(0).p_V - Vec3(4.5, 0, 0.25)).norm(), 1e-15);
  EXPECT_EQ(rows.at(0).p_G, Vec3(1, 2, 3));
}

/// A fixed body among floes, and one of a plane; a floe that came later has the higher id.
TEST(ContactRows, StructuresAreTheSideOnWhichTheForceActs) {
  bodies::Bodies bodies = test::sample_bodies();
  test::add_body(bodies, "pier", bodies::BodyKind::rigid, bodies::Motion::fixed, test::tetrahedron(), 1, Vec3::Zero());
  geometry::Shape plane;
  plane.kind = geometry::ShapeKind::plane;
  test::add_body(bodies, "ground", bodies::BodyKind::rigid, bodies::Motion::fixed, plane, 1, Vec3::Zero());
  test::add_body(bodies, "buoy", bodies::BodyKind::rigid, bodies::Motion::free, test::tetrahedron(), 1, Vec3::Zero());
  sim::RunInfo info;
  EXPECT_TRUE(loaded_bodies(bodies, info).structures.empty()) << "the run keeps no account of structures";
  info.structures = {{"pier", 1}};
  info.vessel_mass.com = Vec3(2, 0, 0);
  const LoadedBodies loaded = loaded_bodies(bodies, info);
  EXPECT_EQ(loaded.vessel, 2);
  EXPECT_EQ(loaded.com_V, Vec3(2, 0, 0));
  EXPECT_EQ(loaded.structures, std::vector<std::int64_t>{5});

  contact::SolvedProblem solved = touching({{0, 1}, {0, 2}, {0, 3}});
  solved.touching[0][0].id = 5;  // the pier and a floe of a higher id
  solved.touching[0][1].id = 9;
  solved.touching[2][1].id = 5;
  const auto rows = contact_rows(solved, loaded, false);
  ASSERT_EQ(rows.size(), 3u);
  EXPECT_EQ(rows[0].body, 5);
  EXPECT_EQ(rows[0].other, 9);
  EXPECT_EQ(rows[0].impulse, -Vec3(0.1, 0.2, 0.3));
  EXPECT_EQ(rows[1].body, 3) << "the vessel";
  EXPECT_EQ(rows[2].body, 5);
  EXPECT_EQ(rows[2].impulse, Vec3(0.1, 0.2, 0.3));
}

/// Impulses of the floe of 10 kg on the vessel: 1 N s corresponds to 0.1 m/s.
TEST(ContactRows, StatusFollowsFromImpulseAndVelocity) {
  const auto status = [&](const Vec3& r, const Vec3& u, Law law = Law::coulomb, double limit = 1e9,
                          double compliance = 0, double tangential = 0) {
    contact::SolvedProblem solved = touching({{0, 2}});
    solved.problem.law = law;
    solved.problem.force_limit[0] = solved.points[0].force_limit = limit;
    solved.problem.compliance[0] = compliance;
    solved.problem.tangential_compliance[0] = tangential;
    solved.solution.r = r;
    solved.solution.u = u;
    return contact_status(solved, 0);
  };
  EXPECT_EQ(status({0, 0, 0}, {0, 0, 0}), ContactStatus::open);
  EXPECT_EQ(status({0, 0, 0}, {0.1, 0, 0}), ContactStatus::open);
  EXPECT_EQ(status({1e-9, 0, 0}, {0.1, 0, 0}), ContactStatus::open) << "what an interior-point solver leaves";
  EXPECT_EQ(status({1, 0.3, 0}, {0, 0, 0}), ContactStatus::stick);
  EXPECT_EQ(status({1, 0.3, 0}, {1e-8, 1e-8, 0}), ContactStatus::stick) << "what the tolerance leaves";
  EXPECT_EQ(status({1, 0.5, 0}, {0, -0.1, 0}), ContactStatus::slip);
  EXPECT_EQ(status({1, 0.5, 0.5}, {0, -0.1, -0.1}, Law::pyramid), ContactStatus::slip);
  EXPECT_EQ(status({1, 0.4, 0.4}, {0, 0, 0}, Law::pyramid), ContactStatus::stick) << "within its box";
  EXPECT_EQ(status({1, 0, 0}, {0, 0.1, 0}, Law::frictionless), ContactStatus::slip);
  EXPECT_EQ(status({1, 0.2, 0}, {-0.1, 0, 0}, Law::coulomb, 1), ContactStatus::crush);
  EXPECT_EQ(status({1, 0.2, 0}, {-0.1, 0, 0}, Law::coulomb, 2, 0.1), ContactStatus::crush) << "u_N + c r_N = 0";
  const double none = std::numeric_limits<double>::infinity();
  EXPECT_EQ(status({1, 0.2, 0}, {-0.1, -0.04, 0}, Law::coulomb, none, 0.1, 0.2), ContactStatus::stick) << "elastic";
  EXPECT_EQ(status({1, 0.5, 0}, {-0.1, -0.3, 0}, Law::coulomb, none, 0.1, 0.2), ContactStatus::slip) << "elastic";
  EXPECT_EQ(status({0, 0, 0}, {0.1, 0, 0}, Law::coulomb, 2, 0.1), ContactStatus::open);
}

/// The impacts of this integrator lie within a step, and its last contacts name no bodies.
TEST(ContactsH5, IsNotWrittenWithTheReferenceIntegrator) {
  scene::Scene scene;
  sim::RunInfo info;
  info.has_vessel = true;
  EXPECT_TRUE(ContactsH5::asked(scene, info));
  scene.contact.integrator = Integrator::reference;
  EXPECT_FALSE(ContactsH5::asked(scene, info));
}

}  // namespace contact_rows_test
}  // namespace nilas::output
