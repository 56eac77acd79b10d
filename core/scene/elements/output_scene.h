#pragma once
/// Values of <output> and <view>.
#include <array>
#include <optional>
#include <string>

#include "core/base/math.h"
#include "core/choices/output_choices.h"

namespace nilas::scene {

struct OutputScene {
  std::string folder;             ///< relative to the working directory; empty: runs/<scene>-<time>
  double trajectory_every = 0.1;  ///< [s]; 0: none
  bool tank_walls = false;        ///< true: tank walls are part of trajectory frames
  StoredContacts contacts = StoredContacts::hull;
  StoredProblems problems = StoredProblems::never;
  double checkpoint_every = 0;                      ///< [s]; 0: none
  std::optional<bool> bodies;                       ///< default: true for up to 200 bodies
  std::optional<std::array<double, 2>> statistics;  ///< from, to [s]; default: end of the ramp and first ice, end
  std::optional<double> peak_filter;  ///< averaging time of filtered peaks [s]; default: follows from the length

  std::optional<int> load_checks;  ///< steps whose load is checked by a second solution; default: see build_load_checks

  bool operator==(const OutputScene&) const = default;
};

/// The first view of a viewer.
struct ViewScene {
  double camera_elevation_deg = 25, camera_heading_deg = 200;
  double camera_distance = 12;  ///< from the target [m]
  Vec3 target = Vec3::Zero();   ///< [m]
  ViewedMesh mesh = ViewedMesh::fluid;
  bool wireframe = false, normals = false;

  bool operator==(const ViewScene&) const = default;
};

}  // namespace nilas::scene
