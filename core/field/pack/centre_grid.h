#pragma once
/// A grid of square cells over the region that stores the floe centres in each.
#include <algorithm>
#include <cmath>
#include <vector>

#include "core/base/math.h"

namespace nilas::field {

class CentreGrid {
 public:
  CentreGrid(const Vec2& low, const Vec2& high, double cell);
  void clear();
  void insert(int floe, const Vec2& centre) { cells_[cell_of(centre)].push_back(floe); }
  void erase(int floe, const Vec2& centre);
  /// Calls visit(floe) for every floe in the cells within `distance` of `centre`, in a fixed order.
  template <class Visit>
  void visit_near(const Vec2& centre, double distance, const Visit& visit) const {
    const int x0 = column(centre.x() - distance), x1 = column(centre.x() + distance);
    const int y0 = row(centre.y() - distance), y1 = row(centre.y() + distance);
    for (int x = x0; x <= x1; ++x)
      for (int y = y0; y <= y1; ++y)
        for (const int floe : cells_[x * rows_ + y]) visit(floe);
  }

 private:
  int column(double x) const {
    return std::clamp(static_cast<int>(std::floor((x - low_.x()) / cell_)), 0, columns_ - 1);
  }
  int row(double y) const { return std::clamp(static_cast<int>(std::floor((y - low_.y()) / cell_)), 0, rows_ - 1); }
  std::size_t cell_of(const Vec2& p) const { return static_cast<std::size_t>(column(p.x()) * rows_ + row(p.y())); }

  Vec2 low_;
  double cell_;
  int columns_, rows_;
  std::vector<std::vector<int>> cells_;
};

}  // namespace nilas::field
