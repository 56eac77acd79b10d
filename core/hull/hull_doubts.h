#pragma once
/// Hulls that can hardly be meant as they are: turned wrongly, in another unit, half, or too heavy or light.
#include <optional>
#include <string>
#include <vector>

#include "core/hull/hull_axes.h"

namespace nilas {

/// Where a hull comes from and what is made of it; advice names the file and the flags of `nilas hull`.
struct HullUse {
  std::string file = "MESH";               ///< that the hull can be made of again
  MeshAxes drawn = {};                     ///< of the file's axes, those that were taken as forward and up
  double scale = 1;                        ///< metres per unit of the file, as it was taken
  bool generated = false;                  ///< made by generate_hull(): lies as it should
  bool fixed = false;                      ///< a structure that stands or lies where it is
  std::optional<double> draught = {};      ///< as given, or at which it floats [m]
  std::optional<double> displaced = {};    ///< volume below the water as it is placed [m^3]
  std::optional<double> mass_afloat = {};  ///< volume that the given mass would displace [m^3]
};

/// Whole sentences, one entry for each probable mistake, with its cure; empty for what may well be meant. `mesh` is
/// closed and outward, in frame V [m].
std::vector<std::string> hull_doubts(const TriangleMesh& mesh, const HullUse& use);

}  // namespace nilas
