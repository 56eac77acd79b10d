#pragma once
/// The views of drawings and how much they show.
#include <array>
#include <limits>
#include <string>
#include <vector>

#include "apps/report/contact_windows.h"
#include "core/geometry/mesh.h"

namespace nilas::report {

/// A view along an axis of the drawing's frame.
struct View {
  std::string name;          ///< name in the title of the picture
  int across = 0, up = 2;    ///< axes of the paper: 0 x, 1 y, 2 z
  bool reversed = false;     ///< the axis across runs to the left
  Vec3 from = Vec3::Zero();  ///< unit vector to the viewer
  bool is_plan() const { return up != 2; }
};

/// The views from the port side, from above and from the starboard side.
std::array<View, 3> hull_views();
/// The elevation that faces ice which moves along -`course` (horizontal, in G), the plan, and the other elevation.
std::array<View, 3> structure_views(const Vec2& course);

struct AxisExtent {
  double low = std::numeric_limits<double>::infinity(), high = -low;
  double width() const { return high - low; }
  void add(double x);
};

/// The ranges of the drawing's frame that are shown.
struct PictureFrame {
  std::array<AxisExtent, 3> axes;  ///< x, y, z [m]
  std::string left_out;            ///< a sentence about what lies beyond; empty if all is shown
};

/// The frame of a hull: from the aftmost contact to the bow, and at least two fifths of the length; without contacts
/// the whole hull.
PictureFrame hull_frame(const geometry::TriangleMesh& hull, const std::vector<ContactWindow>& windows);
/// The frame of structures: all of the plan, and of high structures the heights around `water_level` [m] and contacts.
PictureFrame structure_frame(const std::vector<geometry::TriangleMesh>& structures,
                             const std::vector<ContactWindow>& windows, double water_level);

}  // namespace nilas::report
