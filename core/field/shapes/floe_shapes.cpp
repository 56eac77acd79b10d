#include "core/field/shapes/floe_shapes.h"

#include <algorithm>
#include <cmath>

namespace nilas::field {

namespace {

/// Largest axis ratio of the ellipse on which a polygon's corners lie.
constexpr double k_longest_ellipse = 1.4;
/// Largest deviation of corners from even spacing [share of the spacing]; the smallest angle between two is then 0.3 of
/// it.
constexpr double k_corner_stray = 0.35;

std::vector<Vec2> ellipse_polygon(int corners, double aspect, double stray, RandomStream& random) {
  std::vector<Vec2> outline;
  for (int i = 0; i < corners; ++i) {
    const double angle = 2 * k_pi * (i + (stray > 0 ? random.uniform(-stray, stray) : 0)) / corners;
    outline.emplace_back(aspect * std::cos(angle), std::sin(angle));
  }
  return outline;
}

/// Parallelogram with sides 2 aspect and 2, whose short sides lean by `shear` from the normal to the long ones.
std::vector<Vec2> parallelogram(double aspect, double shear) {
  const double lean = std::sin(shear), height = std::cos(shear);
  return {{-aspect - lean, -height}, {aspect - lean, -height}, {aspect + lean, height}, {-aspect + lean, height}};
}

const std::vector<Vec2>& any_of_library(const PackedSpec& spec, RandomStream& random) {
  return spec.library[static_cast<std::size_t>(random.uniform() * static_cast<double>(spec.library.size()))];
}

std::vector<Vec2> draw_outline(const PackedSpec& spec, RandomStream& random) {
  switch (spec.shape) {
    case FloeShape::rectangle:
      return parallelogram(spec.aspect, 0);
    case FloeShape::square:
      return parallelogram(1, 0);
    case FloeShape::parallelogram:
      return parallelogram(spec.aspect, spec.shear);
    case FloeShape::disc:
      return ellipse_polygon(k_disc_corners, 1, 0, random);
    case FloeShape::library:
      return any_of_library(spec, random);
    case FloeShape::polygon:
      break;
  }
  const int choices = spec.vertices_max - spec.vertices_min + 1;
  const int corners = spec.vertices_min + static_cast<int>(random.uniform() * choices);
  return ellipse_polygon(corners, random.uniform(1, k_longest_ellipse), k_corner_stray, random);
}

}  // namespace

LooseFloe draw_floe(const PackedSpec& spec, double area, RandomStream& random) {
  LooseFloe floe = hulled_floe(draw_outline(spec, random));
  floe = with_area(std::move(floe), area / floe.fill);
  floe.centre.setZero();
  return floe;
}

std::vector<LooseFloe> draw_library_floes(const PackedSpec& spec, double wanted, RandomStream& random) {
  std::vector<LooseFloe> floes;
  double sum = 0;
  while (true) {
    LooseFloe floe = hulled_floe(any_of_library(spec, random));
    floe.centre.setZero();
    const double area = floe.area * floe.fill;
    if (std::abs(sum + area - wanted) >= std::abs(sum - wanted)) break;  // without this floe the sum is nearer
    sum += area;
    floes.push_back(std::move(floe));
  }
  std::stable_sort(floes.begin(), floes.end(), [](const auto& a, const auto& b) { return a.area > b.area; });
  return floes;
}

}  // namespace nilas::field
