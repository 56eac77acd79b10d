/// The impulses on a floe that broke are the first guess of the impulses on its pieces.
#include "fracture/model/broken_contacts.h"

#include <gtest/gtest.h>

#include <memory>

#include "contact/assemble.h"
#include "contact/law/contact_frame.h"
#include "contact/measure/measure.h"
#include "contact/problem/row_of.h"
#include "contact/registry.h"
#include "core/base/error.h"
#include "tests/core/sim/crushing_rig.h"
#include "tests/support/mirrored.h"

namespace broken_contacts_test {

using namespace nilas;
using namespace nilas::fracture;

constexpr double k_thick = 0.1, k_h = 0.01;

/// Upright prisms with ids 1, 2 ...
bodies::Bodies blocks(int count) {
  bodies::Bodies bodies;
  for (int k = 0; k < count; ++k) {
    bodies::BodySpec spec;
    spec.name = "block";
    spec.shape =
        std::make_shared<const geometry::Shape>(geometry::prism_shape({{-1, -1}, {1, -1}, {1, 1}, {-1, 1}}, k_thick));
    spec.mass = 1;
    bodies.add(spec);
  }
  return bodies;
}

contact::SolvedProblem pressed(const std::vector<std::pair<std::int64_t, std::int64_t>>& ids,
                               const std::vector<Vec3>& places, const std::vector<Vec3>& impulses) {
  contact::SolvedProblem solved;
  solved.problem.h = k_h;
  for (std::size_t i = 0; i < ids.size(); ++i) {
    detect::ContactPoint point;
    point.p = places[i];
    solved.points.push_back(point);
    solved.touching.push_back({contact::TouchingBody{ids[i].first, 1}, contact::TouchingBody{ids[i].second, 1}});
  }
  solved.impulses = impulses;
  return solved;
}

FractureEvent broke(std::int64_t floe, const std::vector<std::int64_t>& pieces) {
  FractureEvent event;
  event.kind = "bending";
  event.floe = floe;
  event.pieces = pieces;
  return event;
}

detect::ContactPoint touch(int a, int b, const Vec3& p, const Vec3& n = Vec3::UnitX()) {
  detect::ContactPoint point;
  point.a = a;
  point.b = b;
  point.p = p;
  point.n = n.normalized();
  return point;
}

/// Impulses on the points' bodies b, in G.
std::vector<Vec3> guessed(const BrokenContacts& broken, const bodies::Bodies& bodies,
                          const std::vector<detect::ContactPoint>& points) {
  std::vector<Mat3> C;
  for (const detect::ContactPoint& c : points) C.push_back(contact::contact_frame(c.n, bodies.R_GB[c.a], 0.3));
  VecX guess = VecX::Zero(contact::row_of(points.size()));
  broken.add_to(bodies, points, C, guess);
  std::vector<Vec3> all;
  for (std::size_t i = 0; i < points.size(); ++i) all.emplace_back(C[i] * guess.segment<3>(contact::row_of(i)));
  return all;
}

void expect_near(const Vec3& a, const Vec3& b, double tolerance = 1e-12) {
  EXPECT_LE((a - b).norm(), tolerance) << a.transpose() << " against " << b.transpose();
}

/// Body 1 is a hull, 2 broke into 4 and 5, 3 is a floe beside it. The hull's and the floe's ids are below the pieces',
/// so that their pair is the other way round than before for the floe.
TEST(BrokenContacts, GoToTheNearestPointOfTheSamePair) {
  bodies::Bodies bodies = blocks(5);
  const Vec3 on_floe(2, 0.5, -0.25), on_neighbour(0.5, 3, 0);
  BrokenContacts broken;
  broken.note(pressed({{1, 2}, {2, 3}, {1, 3}}, {{0, 0.1, 0}, {1, 1, 0}, {0, 0, 0}}, {on_floe, on_neighbour, on_floe}),
              {broke(2, {4, 5})});
  const std::vector<detect::ContactPoint> points{touch(0, 3, {0, 0.05, 0}), touch(0, 4, {0, 0.17, 0}),
                                                 touch(0, 2, {0, 0, 0}), touch(2, 4, {1.01, 1, 0}, -Vec3::UnitY()),
                                                 touch(3, 4, {0, 0.1, 0})};
  const std::vector<Vec3> guess = guessed(broken, bodies, points);
  expect_near(guess[0], on_floe);
  expect_near(guess[1], Vec3::Zero());
  expect_near(guess[2], Vec3::Zero());  // none of the floe that broke
  expect_near(guess[3], -on_neighbour);
  expect_near(guess[4], Vec3::Zero());  // of two pieces
  broken.forget();
  expect_near(guessed(broken, bodies, points)[0], Vec3::Zero());
}

TEST(BrokenContacts, OfTwoFloesThatBrokeTogetherGoToTheirPieces) {
  BrokenContacts broken;
  broken.note(pressed({{1, 2}}, {{0, 0, 0}}, {{2, 0.5, -0.25}}), {broke(1, {3, 4}), broke(2, {5})});
  const std::vector<Vec3> guess =
      guessed(broken, blocks(5), {touch(2, 4, {0, 0.02, 0}), touch(3, 4, {0, 0.01, 0}), touch(2, 3, {0, 0, 0})});
  expect_near(guess[0], Vec3::Zero());
  expect_near(guess[1], {2, 0.5, -0.25});
  expect_near(guess[2], Vec3::Zero());
}

/// A crack through a point leaves one to each piece. Turned over, with the points in another order, it is the same.
TEST(BrokenContacts, AreSharedByPointsThatAreEquallyNear) {
  BrokenContacts broken, in_the_mirror;
  const std::vector<Vec3> impulses{{2, 0.5, -0.25}, {0.7, 0.1, 0.3}, {0.1, 0.2, 0.9}};
  const std::vector<Vec3> places{{0, 0.1, 0}, {0, 0.13, 0.01}, {0, 0.08, 0.02}};
  broken.note(pressed({{1, 2}, {1, 2}, {1, 2}}, places, impulses), {broke(2, {3, 4})});
  in_the_mirror.note(pressed({{1, 2}, {1, 2}, {1, 2}},
                             {test::mirrored(places[2]), test::mirrored(places[1]), test::mirrored(places[0])},
                             {test::mirrored(impulses[2]), test::mirrored(impulses[1]), test::mirrored(impulses[0])}),
                     {broke(2, {3, 4})});
  const std::vector<Vec3> guess = guessed(broken, blocks(4), {touch(0, 2, {0, 0.1, 0}), touch(0, 3, {0, 0.1, 0})});
  const std::vector<Vec3> of_image =
      guessed(in_the_mirror, blocks(4), {touch(0, 2, {0, -0.1, 0}), touch(0, 3, {0, -0.1, 0})});
  const Vec3 half = 0.5 * (impulses[0] + impulses[1] + impulses[2]);
  expect_near(guess[0], half);
  expect_near(guess[1], half);
  for (int k = 0; k < 2; ++k) expect_near(test::mirrored(of_image[k]), half, 1e-15);
}

TEST(BrokenContacts, OutOfReachOrPullingAreLeftOut) {
  BrokenContacts broken;
  broken.note(pressed({{1, 2}}, {{0, 0, 0}}, {{1, 0, 0}}), {broke(2, {3, 4})});
  const bodies::Bodies bodies = blocks(4);
  expect_near(guessed(broken, bodies, {touch(0, 2, {0, 2.01 * k_thick, 0})})[0], Vec3::Zero());
  expect_near(guessed(broken, bodies, {touch(0, 2, {0, 0, 0}, {-1, 0.1, 0})})[0], Vec3::Zero());
  // one that it does not press on is passed over
  expect_near(guessed(broken, bodies, {touch(0, 2, {0, 0, 0}, {-1, 0.1, 0}), touch(0, 3, {0, 0.1, 0}, {1, 1, 0})})[1],
              Vec3::UnitX());
}

/// Both bodies have moved on since.
TEST(BrokenContacts, MoveWithTheirBodies) {
  BrokenContacts broken;
  broken.note(pressed({{1, 2}}, {{0, 0, 0}}, {{1, 0, 0}}), {broke(2, {3, 4})});
  bodies::Bodies bodies = blocks(4);
  for (Vec3& v : bodies.v_GB) v = Vec3(0, 50 * k_thick / k_h, 0);
  expect_near(guessed(broken, bodies, {touch(0, 2, {0, 50 * k_thick, 0})})[0], Vec3::UnitX());
}

TEST(BrokenContacts, AreSavedAndRestored) {
  BrokenContacts broken, again;
  broken.note(pressed({{1, 2}}, {{0, 0, 0}}, {{1, 0.3, 0.1}}), {broke(2, {3, 4})});
  State state, second;
  broken.save(StateWriter(state));
  again.restore(StateReader(state));
  again.save(StateWriter(second));
  EXPECT_EQ(second.entries, state.entries);
  EXPECT_EQ(guessed(again, blocks(4), {touch(0, 2, {0, 0, 0})}), guessed(broken, blocks(4), {touch(0, 2, {0, 0, 0})}));
  std::get<std::vector<std::int64_t>>(state.entries.at("piece_of")).push_back(7);
  EXPECT_THROW(again.restore(StateReader(state)), InputError);
}

/// The bow is so blunt that friction holds the halves of the floe that it splits.
struct BluntHull {
  BluntHull() {
    std::vector<Vec3> vertices;
    for (const double z : {-1.0, 1.0})
      vertices.insert(vertices.end(), {Vec3(0, 0, z), Vec3(-0.3, 2, z), Vec3(-0.3, -2, z)});
    folder.write("blunt.stl", test::stl(vertices, {{1, 4, 3, 0}, {3, 5, 2, 0}, {2, 1, 0}, {4, 5, 3}, {2, 5, 4, 1}}));
  }
  test::ScratchFolder folder;
};

/// It goes slowly into a floe that stands against a pier, and crushes it until it splits.
struct Pressed : BluntHull, test::Rig {
  Pressed()
      : Rig("<vessel hull='" + (BluntHull::folder / "blunt.stl").string() +
                "' position='-0.001 0.02 0'><mass value='1000'/><carriage speed='0.005'/></vessel>"
                "<body name='pier' shape='box' size='0.2 4 2' position='2.1 0 0' fixed='true'/>"
                "<water density='1000'/><hydro><buoyancy/></hydro><ice thickness='0.05' density='900' "
                "youngs_modulus='1e8'><floe breakable='true' outline='0 -1 2 -1 2 1 0 1'/></ice><fracture "
                "compressive_strength='2e5' fracture_toughness='2e4'><crushing model='explicit'/><splitting "
                "model='lefm'/></fracture>",
            0.01, 1, "", 0.3, {0, 0, -9.81}) {
    for (int k = 0; k < 1000 && record.broken.empty(); ++k) record = step();
  }
  sim::StepRecord record;
};

/// Sum of the impulses on the body with this id [N s].
Vec3 sum_on(std::int64_t id, const contact::SolvedProblem& solved, const std::vector<Vec3>& impulses) {
  Vec3 sum = Vec3::Zero();
  for (std::size_t i = 0; i < solved.points.size(); ++i) {
    if (solved.touching[i][0].id == id) sum -= impulses[i];
    if (solved.touching[i][1].id == id) sum += impulses[i];
  }
  return sum;
}

TEST(BrokenContacts, SumToWhatPressedOnTheFloe) {
  Pressed rig;
  ASSERT_EQ(rig.record.broken.size(), 1u);
  const contact::SolvedProblem old = rig.simulation.last_problem();
  const bodies::Bodies bodies = rig.bodies();
  BrokenContacts broken;
  broken.note(old, rig.record.broken);
  rig.step();
  const contact::SolvedProblem& now = rig.simulation.last_problem();
  const std::vector<Vec3> guess = guessed(broken, bodies, now.points);
  int pressing = 0;
  for (std::size_t b = 0; b < bodies.id.size(); ++b) {
    if (bodies.kind[b] == bodies::BodyKind::floe) continue;
    const Vec3 before = sum_on(bodies.id[b], old, old.impulses);
    EXPECT_GT(before.norm(), 5) << "the vessel on one side, the pier on the other";
    expect_near(sum_on(bodies.id[b], now, guess), before, 1e-9 * before.norm());
    ++pressing;
  }
  EXPECT_EQ(pressing, 2);
}

/// A press on the corners of a floe that lies on the ground at them, of no weight, and breaks in two: the guess is the
/// solution, where the points are.
TEST(BrokenContacts, BalanceAStaticLoad) {
  bodies::Bodies bodies = blocks(5);  // the ground, the press, the floe that is gone, its halves
  bodies.motion[0] = bodies::Motion::fixed;
  bodies.set_pose(1, {0, 0, k_thick}, Quat::Identity());
  bodies.set_pose(3, {-0.5, 0, 0}, Quat::Identity());
  bodies.set_pose(4, {0.5, 0, 0}, Quat::Identity());
  const double weight = 50;
  std::vector<std::pair<std::int64_t, std::int64_t>> ids;
  std::vector<Vec3> places, impulses;
  std::vector<detect::ContactPoint> points;
  for (const double x : {-1.0, 1.0})
    for (const double y : {-1.0, 1.0}) {
      const int half = x < 0 ? 3 : 4;
      const Vec3 bottom(x, y, -0.5 * k_thick), top(x, y, 0.5 * k_thick);
      ids.insert(ids.end(), {{1, 3}, {2, 3}});
      places.insert(places.end(), {bottom, top});
      impulses.insert(impulses.end(), {Vec3(0, 0, 0.25 * weight * k_h), Vec3(0, 0, -0.25 * weight * k_h)});
      const Vec3 at_crack(0, y, -0.5 * k_thick);
      points.insert(points.end(), {touch(0, half, bottom, Vec3::UnitZ()), touch(0, half, at_crack, Vec3::UnitZ()),
                                   touch(1, half, top, -Vec3::UnitZ())});
    }
  for (std::size_t i = 0; i < points.size(); ++i) points[i].key = i + 1;
  BrokenContacts broken;
  broken.note(pressed(ids, places, impulses), {broke(3, {4, 5})});

  contact::FrictionTable friction;
  contact::AssemblySettings settings;
  settings.h = k_h;
  bodies::Wrenches loads(5);
  loads[1].force.z() = -weight;
  const contact::AssembledContacts contacts =
      contact::assemble(bodies, loads, points, friction.resolve(bodies.materials), settings, {});
  const VecX nothing = VecX::Zero(contact::row_of(points.size()));
  VecX guess = nothing;
  broken.add_to(bodies, points, contacts.C, guess);
  EXPECT_GT(contact::measure(contacts.problem, nothing).law_map_m_s, 0.1);
  EXPECT_LT(contact::measure(contacts.problem, guess).law_map_m_s, 1e-12);
  contact::SolverSettings solver;
  solver.tolerance = 1e-9;
  const auto nsgs = contact::find_solver("nsgs").make(solver);
  const contact::ContactSolution warm = nsgs->solve(contacts.problem, guess),
                                 cold = nsgs->solve(contacts.problem, nothing);
  EXPECT_LT(warm.iterations, cold.iterations);
  EXPECT_LE((warm.v - cold.v).norm(), 1e-6);
}

}  // namespace broken_contacts_test
