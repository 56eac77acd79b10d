#pragma once
/// A picture of where ice touched a hull or structures, and with what force.
#include <string>
#include <vector>

#include "apps/report/contact_windows.h"
#include "apps/report/picture_frame.h"
#include "core/geometry/mesh.h"

namespace nilas::report {

/// A row of the picture.
struct PictureRow {
  ContactWindow window;
  std::string loads;                     ///< the mean load in words
  std::vector<std::vector<Vec3>> floes;  ///< outlines in the frame of the drawing [m]; may be empty
};

struct ContactPictureInput {
  std::string title;
  std::vector<geometry::TriangleMesh> bodies;  ///< surfaces in the frame of the drawing [m]
  std::array<View, 3> views;
  PictureFrame frame;
  std::vector<PictureRow> rows;
  double water_level = 0;  ///< height of the water surface in G [m]
};

/// The script with which gnuplot draws contacts.svg and contacts.png: a row per window with the three views. Marks are
/// coloured by the force of one step, on a logarithmic scale that all rows share.
std::string contact_picture_script(const ContactPictureInput& input);

}  // namespace nilas::report
