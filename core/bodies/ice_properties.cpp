#include "core/bodies/ice_properties.h"

namespace nilas::bodies {

std::vector<WeakLine> lines_near(const std::vector<WeakLine>& lines, const Vec2& centre,
                                 const std::vector<Vec2>& outline) {
  Eigen::AlignedBox2d box;
  for (const Vec2& p : outline) box.extend(p);
  std::vector<WeakLine> near;
  for (const WeakLine& line : lines) {
    bool joins = false;  // the last segment taken ends where the next one starts
    for (std::size_t i = 0; i + 1 < line.points.size(); ++i) {
      const Vec2 a = line.points[i] - centre, b = line.points[i + 1] - centre;
      Eigen::AlignedBox2d segment(a);
      segment.extend(b);
      if (!segment.intersects(box)) {
        joins = false;
        continue;
      }
      if (joins) {
        near.back().points.push_back(b);
      } else {
        near.push_back({{a, b}, line.strength});
      }
      joins = true;
    }
  }
  return near;
}

}  // namespace nilas::bodies
