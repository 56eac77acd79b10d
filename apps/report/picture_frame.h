#pragma once
/// From where drawings look, and how much they show.
#include <array>
#include <limits>
#include <string>
#include <vector>

#include "apps/report/contact_windows.h"
#include "core/geometry/mesh.h"

namespace nilas {

/// A view along an axis of the drawing's frame.
struct View {
  std::string name;          ///< as the picture's title says it
  int across = 0, up = 2;    ///< axes of the paper: 0 x, 1 y, 2 z
  bool reversed = false;     ///< the axis across runs to the left
  Vec3 from = Vec3::Zero();  ///< unit vector to the viewer
  bool is_plan() const { return up != 2; }
};

/// Port side, plan and starboard side.
std::array<View, 3> hull_views();
/// The elevation that faces what comes along -`course` (horizontal, in G), the plan, and the other elevation.
std::array<View, 3> structure_views(const Vec2& course);

struct AxisExtent {
  double low = std::numeric_limits<double>::infinity(), high = -low;
  double width() const { return high - low; }
  void add(double x);
};

/// What of the drawing's frame is shown.
struct PictureFrame {
  std::array<AxisExtent, 3> axes;  ///< x, y, z [m]
  std::string left_out;            ///< what lies beyond, as a sentence; empty where all is shown
};

/// Of a hull the part that was touched, two fifths of its length at least, and all ahead of it.
PictureFrame hull_frame(const TriangleMesh& hull, const std::vector<ContactWindow>& windows);
/// Of structures all in the plan; of high ones the heights around `water_level` and contacts.
PictureFrame structure_frame(const std::vector<TriangleMesh>& structures, const std::vector<ContactWindow>& windows,
                             double water_level);

}  // namespace nilas
