#include "core/vessel/tree/held_speeds.h"

#include "core/vessel/model/cells.h"
#include "core/vessel/tree/carried_vessel.h"

namespace nilas::vessel {

HullCells hull_cells(const CarriageModel& carriage, int speeds) {
  const Mat6 wrenches = cell_wrenches(carriage.cells);
  HullCells cells{Eigen::PartialPivLU<Mat6>(wrenches), MatX::Zero(speeds, speeds),
                  carriage.damping / carriage.stiffness, free_coordinates(carriage)};
  cells.stiffness.topLeftCorner<6, 6>() = condensed_stiffness(wrenches, carriage.stiffness, cells.free);
  for (int i = 6; i < speeds; ++i) cells.free.push_back(i);
  return cells;
}

std::vector<int> loose_speeds(const JointedTree& tree, const std::optional<HullCells>& cells) {
  std::vector<int> loose;
  for (int i = 0; i < tree.num_speeds(); ++i)
    if (tree.stiffness()[i] == 0 && (!cells || cells->stiffness(i, i) == 0)) loose.push_back(i);
  return loose;
}

}  // namespace nilas::vessel
