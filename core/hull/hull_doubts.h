#pragma once
/// Checks for implausible hulls: wrong orientation or unit, half a hull, too heavy or too light.
#include <optional>
#include <string>
#include <vector>

#include "core/hull/hull_axes.h"

namespace nilas::hull {

/// Origin and use of a hull; advice names the file and the flags of `nilas hull`.
struct HullUse {
  std::string file = "MESH";               ///< file from which the hull can be made again
  MeshAxes drawn = {};                     ///< axes of the file that were taken as forward and up
  double scale = 1;                        ///< metres per unit of the file that were assumed
  bool generated = false;                  ///< made by generate_hull(): its orientation is right
  bool fixed = false;                      ///< true for a fixed structure
  std::optional<double> draught = {};      ///< given draught, or that at which it floats [m]
  std::optional<double> displaced = {};    ///< volume below the water at its place in the scene [m^3]
  std::optional<double> mass_afloat = {};  ///< volume that the given mass would displace [m^3]
};

/// Whole sentences, one entry for each probable mistake, with its correction; empty for a plausible hull. `mesh`:
/// closed and outward, in frame V [m].
std::vector<std::string> hull_doubts(const geometry::TriangleMesh& mesh, const HullUse& use);

}  // namespace nilas::hull
