#pragma once
/// Drawings of a run as <svg> elements. Their colours are those of the page's style sheet, by class.
#include <string>
#include <vector>

#include "apps/report/hull_lines.h"
#include "core/base/math.h"

namespace nilas::report {

/// What a drawing shows, in metres, with y upwards.
struct DrawnShapes {
  std::vector<std::vector<Vec2>> ice;            ///< closed outlines
  std::vector<std::array<Vec2, 2>> hull, water;  ///< lines of bodies, and of the water
  std::vector<std::vector<Vec2>> tank;           ///< closed outlines
  std::vector<Vec2> marks;                       ///< places of the largest load
  std::vector<std::vector<Vec2>> culprits;       ///< closed outlines of the floe that made it
  std::string mark_name;                         ///< stands beside the marks; empty: nothing
};

/// The part of the plane that a drawing shows [m].
struct DrawnArea {
  Vec2 low = Vec2::Zero(), high = Vec2::Ones();
};

/// The <svg> element, with a scale. Ice outside of the area is left out, and of very many floes the smallest are.
/// `label`: what it shows, for those who do not see it.
std::string svg_drawing(const DrawnShapes& shapes, const DrawnArea& area, const std::string& label);

}  // namespace nilas::report
