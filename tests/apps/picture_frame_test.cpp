/// Tests of drawings of contacts: the direction of view, and how much of a hull or of structures they show.
#include "apps/report/picture_frame.h"

#include <gtest/gtest.h>

namespace nilas {
namespace picture_frame_test {

/// Only the corners matter.
geometry::TriangleMesh box(const Vec3& low, const Vec3& high) {
  geometry::TriangleMesh mesh;
  mesh.vertices = {low, high};
  return mesh;
}

report::ContactWindow touched_at(const std::vector<Vec3>& points) {
  report::ContactWindow window;
  for (const Vec3& p : points) window.marks.push_back({p, p, Vec3::UnitX()});
  return window;
}

TEST(PictureFrame, AHullIsShownWhereItWasTouchedAndWhatIsLeftOutIsSaid) {
  const geometry::TriangleMesh hull = box({0, -10, 0}, {100, 10, 9});
  const report::PictureFrame whole = report::hull_frame(hull, {touched_at({Vec3(1, 0, 5), Vec3(99, 0, 5)})});
  EXPECT_DOUBLE_EQ(whole.axes[0].low, -3);
  EXPECT_DOUBLE_EQ(whole.axes[0].high, 103);
  EXPECT_TRUE(whole.left_out.empty());
  const report::PictureFrame bow = report::hull_frame(hull, {touched_at({Vec3(90, 0, 5)})});
  EXPECT_DOUBLE_EQ(bow.axes[0].low, 60 - 3);
  EXPECT_NE(bow.left_out.find("aft of x = 60 m"), std::string::npos) << bow.left_out;
  const report::PictureFrame none = report::hull_frame(hull, {touched_at({})});
  EXPECT_DOUBLE_EQ(none.axes[0].low, -3) << "a hull that nothing touched is shown whole";
  EXPECT_DOUBLE_EQ(none.axes[1].width(), 20 * 1.24);
}

TEST(PictureFrame, OfHighStructuresTheWaterlineIsShown) {
  const geometry::TriangleMesh pier = box({10, -2, -50}, {14, 2, 20});
  const report::PictureFrame frame = report::structure_frame({pier}, {touched_at({Vec3(10, 0, -1)})}, 0);
  EXPECT_NEAR(frame.axes[2].low, -5 - 0.12 * 9, 1e-12);
  EXPECT_NEAR(frame.axes[2].high, 4 + 0.12 * 9, 1e-12);
  EXPECT_NE(frame.left_out.find("z = -50 m to 20 m"), std::string::npos) << frame.left_out;
  const report::PictureFrame low = report::structure_frame({box({0, -2, -3}, {4, 2, 3})}, {touched_at({})}, 0);
  EXPECT_TRUE(low.left_out.empty());
  const report::PictureFrame on_land = report::structure_frame({box({0, -2, 30}, {4, 2, 33})}, {touched_at({})}, 0);
  EXPECT_LT(on_land.axes[2].low, 30);
  EXPECT_GT(on_land.axes[2].high, 33);
}

TEST(PictureFrame, ElevationsFaceWhereTheIceComesFrom) {
  const auto views = report::structure_views(Vec2(-1, 0.1).normalized());  // the ice drifts along +x
  EXPECT_EQ(views[0].name, "seen from -x");
  EXPECT_EQ(views[0].from, -Vec3::UnitX());
  EXPECT_EQ(views[0].across, 1);
  EXPECT_EQ(views[2].name, "seen from +y");
  const auto others = report::structure_views(Vec2(0.1, -1));
  EXPECT_EQ(others[0].name, "seen from -y");
  EXPECT_EQ(others[2].name, "seen from +x");
  for (const auto& view :
       {views[0], views[2], others[0], others[2], report::hull_views()[0], report::hull_views()[2]}) {
    const Vec3 right = Vec3::UnitZ().cross(view.from);  // of a viewer who looks along -from
    EXPECT_DOUBLE_EQ(right[view.across], view.reversed ? -1 : 1) << view.name;
  }
}

}  // namespace picture_frame_test
}  // namespace nilas
