#pragma once
/// Speeds of a vessel of several bodies that springs or cells hold, and the stiffness along them.
#include <optional>
#include <vector>

#include "core/vessel/tree/jointed_tree.h"

namespace nilas::vessel {

/// The carriage's cells in the form that the step needs.
struct HullCells {
  Eigen::PartialPivLU<Mat6> layout;
  MatX stiffness;           ///< n x n; the hull's speeds come first
  double damping_time = 0;  ///< [s]
  std::vector<int> free;    ///< speeds that no cell holds: those of the parts, and of the hull's free axes
};
/// The cells of `carriage`. `speeds`: number n of the tree's speeds.
HullCells hull_cells(const CarriageModel& carriage, int speeds);

/// Speeds that neither a joint's spring nor a cell holds, in rising order.
std::vector<int> loose_speeds(const JointedTree& tree, const std::optional<HullCells>& cells);

}  // namespace nilas::vessel
