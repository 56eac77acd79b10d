#include "core/field/pack/centre_grid.h"

namespace nilas::field {

CentreGrid::CentreGrid(const Vec2& low, const Vec2& high, double cell)
    : low_(low),
      cell_(cell),
      columns_(std::max(1, static_cast<int>(std::ceil((high.x() - low.x()) / cell)))),
      rows_(std::max(1, static_cast<int>(std::ceil((high.y() - low.y()) / cell)))),
      cells_(static_cast<std::size_t>(columns_) * static_cast<std::size_t>(rows_)) {}

void CentreGrid::clear() {
  for (auto& cell : cells_) cell.clear();
}

void CentreGrid::erase(int floe, const Vec2& centre) {
  auto& cell = cells_[cell_of(centre)];
  cell.erase(std::find(cell.begin(), cell.end(), floe));
}

}  // namespace nilas::field
