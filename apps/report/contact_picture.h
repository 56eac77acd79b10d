#pragma once
/// A picture of where ice met the hull and with what force.
#include <string>
#include <vector>

#include "apps/report/contact_windows.h"
#include "core/bodies/mesh.h"

namespace nilas {

struct ContactPictureInput {
  std::string title;
  TriangleMesh hull;  ///< in V
  std::vector<ContactWindow> windows;
  std::vector<std::vector<std::vector<Vec3>>> floes;  ///< per window outlines in V; may be empty
  double water_level = 0;                             ///< in G [m]
};

/// Script for gnuplot that draws contacts.svg and contacts.png: a row per window with port side, plan and starboard
/// side. Marks are coloured by the force of one step, on a logarithmic scale that all rows share.
std::string contact_picture_script(const ContactPictureInput& input);

}  // namespace nilas
