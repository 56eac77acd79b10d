#include "core/geometry/orientation.h"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>

#include <algorithm>

namespace nilas::geometry {

int orientation(const Vec2& a, const Vec2& b, const Vec2& c) {
  using Point = CGAL::Exact_predicates_inexact_constructions_kernel::Point_2;
  return static_cast<int>(CGAL::orientation(Point(a.x(), a.y()), Point(b.x(), b.y()), Point(c.x(), c.y())));
}

bool is_clockwise(const std::vector<Vec2>& outline) {
  const auto lower = [](const Vec2& a, const Vec2& b) { return a.y() < b.y() || (a.y() == b.y() && a.x() < b.x()); };
  const auto lowest = std::min_element(outline.begin(), outline.end(), lower);
  const std::size_t n = outline.size(), i = static_cast<std::size_t>(lowest - outline.begin());
  // the lowest, then leftmost vertex is a corner of the hull
  return orientation(outline[(i + n - 1) % n], *lowest, outline[(i + 1) % n]) < 0;
}

}  // namespace nilas::geometry
