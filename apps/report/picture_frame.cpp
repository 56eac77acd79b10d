#include "apps/report/picture_frame.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace nilas::report {

namespace {

constexpr double k_margin = 0.12, k_margin_along = 0.03;  // shares of what is shown

std::array<AxisExtent, 3> extents(const std::vector<geometry::TriangleMesh>& meshes) {
  std::array<AxisExtent, 3> axes;
  for (const geometry::TriangleMesh& mesh : meshes)
    for (const Vec3& p : mesh.vertices)
      for (std::size_t k = 0; k < axes.size(); ++k) axes[k].add(p[static_cast<Eigen::Index>(k)]);
  return axes;
}

AxisExtent touched(const std::vector<ContactWindow>& windows, int axis) {
  AxisExtent range;
  for (const auto& window : windows)
    for (const auto& mark : window.marks) range.add(mark.p[axis]);
  return range;
}

void widen(AxisExtent& range, double margin) {
  range.low -= margin;
  range.high += margin;
}

}  // namespace

void AxisExtent::add(double x) {
  low = std::min(low, x);
  high = std::max(high, x);
}

std::array<View, 3> hull_views() {
  return {View{"port side", 0, 2, true, Vec3::UnitY()}, View{"plan", 0, 1, false, Vec3::UnitZ()},
          View{"starboard side", 0, 2, false, -Vec3::UnitY()}};
}

std::array<View, 3> structure_views(const Vec2& course) {
  // the axis along which the ice moves more comes first
  const bool along_x = std::abs(course.x()) >= std::abs(course.y());
  const auto elevation = [&](bool from_x) {
    const bool positive = (from_x ? course.x() : course.y()) > 0;
    View view{fmt::format("seen from {}{}", positive ? "+" : "-", from_x ? "x" : "y"), from_x ? 1 : 0, 2, false,
              (positive ? 1 : -1) * Vec3(from_x ? Vec3::UnitX() : Vec3::UnitY())};
    view.reversed = from_x != positive;  // right of a viewer at +x is +y, right of one at -y is +x
    return view;
  };
  return {elevation(along_x), View{"plan", 0, 1, false, Vec3::UnitZ()}, elevation(!along_x)};
}

PictureFrame hull_frame(const geometry::TriangleMesh& hull, const std::vector<ContactWindow>& windows) {
  constexpr double k_least_share = 0.4;
  PictureFrame frame{.axes = extents({hull}), .left_out = ""};
  AxisExtent& x = frame.axes[0];
  const AxisExtent whole = x, ice = touched(windows, 0);
  const double margin = k_margin_along * whole.width();
  if (ice.low <= ice.high)
    x.low = std::max(x.low, std::min(ice.low - margin, whole.high - k_least_share * whole.width()));
  if (x.low > whole.low)
    frame.left_out =
        fmt::format("The hull reaches aft to x = {:.4g} m; at these times nothing touched it aft of x = {:.4g} m.",
                    whole.low, x.low);
  widen(x, margin);
  for (std::size_t k = 1; k < 3; ++k) widen(frame.axes[k], k_margin * frame.axes[k].width());
  return frame;
}

PictureFrame structure_frame(const std::vector<geometry::TriangleMesh>& structures,
                             const std::vector<ContactWindow>& windows, double water_level) {
  PictureFrame frame{.axes = extents(structures), .left_out = ""};
  const double plan = std::max(frame.axes[0].width(), frame.axes[1].width());
  AxisExtent& z = frame.axes[2];
  const AxisExtent whole = z;
  AxisExtent shown = touched(windows, 2);
  shown.add(water_level);
  widen(shown, plan);
  z = {std::max(z.low, shown.low), std::min(z.high, shown.high)};
  if (!(z.low < z.high)) z = whole;  // the structures stand far from the water
  if (z.width() < whole.width())
    frame.left_out = fmt::format(
        "The structures reach from z = {:.4g} m to {:.4g} m; at these times nothing touched them beyond "
        "what is shown.",
        whole.low, whole.high);
  for (AxisExtent& axis : frame.axes) widen(axis, k_margin * axis.width());
  return frame;
}

}  // namespace nilas::report
