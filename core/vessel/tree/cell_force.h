#pragma once
/// The load cells of a force balance as force elements of Simbody. Include it in sources only.
#include <vector>

#include "core/vessel/tree/simbody.h"
#include "core/vessel/tree/vessel_tree.h"

namespace nilas {

class CellForces {
 public:
  /// Before the tree stands: one element per cell, which acts along the coordinates of the joint of `vessel` to its
  /// carriage.
  void add(SimTK::GeneralForceSubsystem& forces, const SimTK::MobilizedBody& vessel,
           const std::vector<TreeCell>& cells);
  /// What all of them do along all speeds of the tree. The state must be realised to Velocity.
  VecX along_speeds(const SimTK::State& state) const;
  double energy(const SimTK::State& state) const;  ///< of the springs [J]; realised to Position

 private:
  std::vector<SimTK::Force::Custom> cells_;
};

}  // namespace nilas
