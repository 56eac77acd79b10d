#pragma once
/// Which speeds of a vessel of several bodies something holds, and how stiffly.
#include <optional>
#include <vector>

#include "core/vessel/tree/jointed_tree.h"

namespace nilas {

/// The cells of the carriage as the step needs them.
struct HullCells {
  Eigen::PartialPivLU<Mat6> layout;
  MatX stiffness;           ///< n x n; the hull's speeds come first
  double damping_time = 0;  ///< [s]
  std::vector<int> free;    ///< speeds that no cell holds: of the parts, and of the hull's free axes
};
/// `speeds`: n of the tree.
HullCells hull_cells(const CarriageModel& carriage, int speeds);

/// Speeds that neither a joint's spring nor a cell holds, in rising order.
std::vector<int> loose_speeds(const JointedTree& tree, const std::optional<HullCells>& cells);

}  // namespace nilas
