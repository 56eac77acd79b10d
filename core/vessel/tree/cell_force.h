#pragma once
/// The load cells of a force balance as force elements of Simbody. Include it in sources only.
#include <vector>

#include "core/vessel/tree/simbody.h"
#include "core/vessel/tree/vessel_tree.h"

namespace nilas::vessel {

class CellForces {
 public:
  /// Adds one element per cell, which acts along the coordinates of the joint between `vessel` and its carriage. Call
  /// before the tree is complete.
  void add(SimTK::GeneralForceSubsystem& forces, const SimTK::MobilizedBody& vessel,
           const std::vector<TreeCell>& cells);
  /// Generalised force of all cells along all speeds of the tree. The state must be realised to Velocity.
  VecX along_speeds(const SimTK::State& state) const;
  double energy(const SimTK::State& state) const;  ///< energy of the springs [J]; state realised to Position

 private:
  std::vector<SimTK::Force::Custom> cells_;
};

}  // namespace nilas::vessel
