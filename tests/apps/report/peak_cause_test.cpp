/// Which floe made the largest load, and in what two scenes differ.
#include "apps/report/run/peak_cause.h"

#include <gtest/gtest.h>

#include "apps/report/run/scene_difference.h"
#include "core/base/error.h"

namespace peak_cause_test {

using namespace nilas;
using namespace nilas::report;

/// Contacts of one step at 2 s.
HullContacts at_two_seconds(const std::vector<std::pair<std::int64_t, Vec3>>& forces) {
  HullContacts contacts;
  for (const auto& [floe, force] : forces) {
    contacts.time.push_back(2);
    contacts.step.push_back(200);
    contacts.other.push_back(floe);
    contacts.place.emplace_back(static_cast<double>(floe), 1, 0);
    contacts.normal.emplace_back(force.normalized());
    contacts.force.push_back(force);
    contacts.impulse.emplace_back(0.01 * force);
    contacts.crushes.push_back(false);
  }
  return contacts;
}

/// The course points along Y: a load astern is a force along -Y, one to port along -X.
TEST(PeakCause, TheFloeWithTheLargestShareAndTheCourse) {
  const HullContacts contacts =
      at_two_seconds({{5, {2, -30, 4}}, {9, {0, -50, 0}}, {5, {3, -10, 0}}, {6, {-9, 10, 0}}});
  const auto cause = peak_cause(contacts, 2, 0.01, 80, 4);
  ASSERT_TRUE(cause);
  EXPECT_EQ(cause->floe, 9);
  EXPECT_EQ(cause->floes, 3u);
  EXPECT_NEAR(cause->share, 50.0 / 80, 1e-12);
  EXPECT_NEAR((cause->course - Vec2::UnitY()).norm(), 0, 1e-12);
  EXPECT_NEAR((cause->place - Vec3(9, 1, 0)).norm(), 0, 1e-12);
  EXPECT_FALSE(peak_cause(contacts, 3, 0.01, 80, 4)) << "no contact in that step";
}

TEST(PeakCause, ALoadForwardIsMadeByTheFloeThatPushesForward) {
  const auto cause = peak_cause(at_two_seconds({{5, {0, 70, 0}}, {6, {0, -10, 0}}}), 2, 0.01, -60, 0);
  ASSERT_TRUE(cause);
  EXPECT_EQ(cause->floe, 5);
  EXPECT_NEAR((cause->course - Vec2::UnitY()).norm(), 0, 1e-12);
}

/// A wall of the tank that pushes harder than all floes takes no part in the load by ice.
TEST(PeakCause, WallsAndBodiesDoNotCount) {
  const HullContacts contacts = at_two_seconds({{5, {0, -30, 0}}, {7, {900, -400, 0}}, {9, {0, -50, 0}}});
  const auto cause = peak_cause(contacts, 2, 0.01, 80, 0, {6, 7});
  ASSERT_TRUE(cause);
  EXPECT_EQ(cause->floe, 9);
  EXPECT_EQ(cause->floes, 2u);
  EXPECT_NEAR(cause->share, 50.0 / 80, 1e-12);
  EXPECT_NEAR((cause->course - Vec2::UnitY()).norm(), 0, 1e-12);
  EXPECT_FALSE(peak_cause(at_two_seconds({{7, {1, 0, 0}}}), 2, 0.01, 1, 0, {7}));
}

TEST(PeakCause, PlacesOnAVesselHaveNames) {
  geometry::TriangleMesh mesh;
  mesh.vertices = {{0, -2, 0}, {30, 2, 5}};
  EXPECT_EQ(place_on_vessel({28, 1, 0}, mesh), "at the bow on the port side");
  EXPECT_EQ(place_on_vessel({15, -2, 0}, mesh), "amidships on the starboard side");
  EXPECT_EQ(place_on_vessel({1, 0.05, 0}, mesh), "at the stern near the centre plane");
}

TEST(SceneDifference, NamesTheAttributesThatDiffer) {
  const std::string first =
      R"(<scene name="a"><ice thickness="0.1"><field concentration="0.8"/><field concentration="0.5"/></ice>
<body name="west" mass="1"/><body name="east" mass="1"/><output folder="x"/></scene>)";
  std::string second = first;
  second.replace(second.find("0.5"), 3, "0.6");
  second.replace(second.rfind("mass=\"1\""), 8, "mass=\"2\"");
  second.replace(second.find("folder=\"x\""), 10, "folder=\"y\"");
  const auto differences = scene_differences({first, second});
  ASSERT_EQ(differences.size(), 2u);
  EXPECT_EQ(differences[0].path, "ice/field[2]/@concentration");
  EXPECT_EQ(differences[0].values, (std::vector<std::string>{"0.5", "0.6"}));
  EXPECT_EQ(differences[1].path, "body[@name='east']/@mass");
  EXPECT_TRUE(scene_differences({first, first}).empty());
  EXPECT_THROW(scene_differences({first, "<scene"}), InputError);
  const std::string alone =
      R"(<scene><body name="west" mass="1"/><ice><field a="1"/></ice><output statistics="0 5"/></scene>)";
  const std::string beside =
      R"(<scene><body name="west" mass="1"/><body name="east" mass="1"/><ice><field a="1"/><field a="2"/></ice>
<output statistics="0 6"/></scene>)";
  std::vector<std::string> paths;
  for (const auto& difference : scene_differences({alone, beside})) paths.push_back(difference.path);
  EXPECT_EQ(paths, (std::vector<std::string>{"output/@statistics", "body[@name='east']/@name",
                                             "body[@name='east']/@mass", "ice/field[2]/@a"}))
      << "an element that got a sibling is the same element, and a window changes the figures";
}

}  // namespace peak_cause_test
