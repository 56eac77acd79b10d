#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "core/base/error.h"
#include "core/field/field.h"
#include "core/field/spec/keep_out.h"
#include "core/field/spec/loose_floe.h"
#include "core/geometry/mass_properties.h"

namespace nilas::field {

namespace {

void demand_of_grid(bool holds, const char* parameter, double found, const char* allowed) {
  if (!holds) throw InputError(fmt::format("grid field: {}: found {}, allowed {}", parameter, found, allowed));
}

/// Lays out the rows from the region's middle line upwards; each piece next to the line has its mirror image below.
class Grid {
 public:
  explicit Grid(const GridSpec& spec) : spec_(spec), middle_(0.5 * (spec.low.y() + spec.high.y())) {
    check();
    const Vec2 side = spec.high - spec.low;
    height_ = (side.y() - (spec.rows - 1) * spec.gap) / spec.rows;
    demand_of_grid(height_ > 0, "gap", spec.gap, "less than the region's width over its rows");
    lean_ = std::tan(spec.shear);
    along_gap_ = spec.gap / std::cos(spec.shear);
    // The sheared rows stay within the region, whose ends keep a notch.
    first_ = spec.low.x() + std::max(0.0, -lean_) * sheared_height();
    const double length = side.x() - std::abs(lean_) * sheared_height();
    width_ = (length - (spec.columns - 1) * along_gap_) / spec.columns;
    demand_of_grid(width_ > (spec.stagger ? along_gap_ : 0), "columns", spec.columns,
                   "fewer, or a smaller gap or shear: the pieces have no width left");
  }

  std::vector<std::vector<Vec2>> pieces() const {
    std::vector<std::vector<Vec2>> all;
    const bool middle_row = spec_.rows % 2 == 1;
    if (middle_row)
      for (const auto& [left, right] : row_columns(0)) all.push_back(middle_piece(left, right));
    for (int row = 0; row < spec_.rows / 2; ++row)
      for (const auto& [left, right] : row_columns(middle_row ? row + 1 : row)) {
        all.push_back(upper_piece(row, left, right));
        all.push_back(mirrored(all.back()));
      }
    return all;
  }

 private:
  void check() const {
    const Vec2 side = spec_.high - spec_.low;
    demand_of_grid(side.x() > 0 && std::isfinite(side.x()), "region", side.x(), "a length along X of more than 0 m");
    demand_of_grid(side.y() > 0 && std::isfinite(side.y()), "region", side.y(), "a width along Y of more than 0 m");
    demand_of_grid(spec_.rows >= 1, "rows", spec_.rows, "1 or more");
    demand_of_grid(spec_.columns >= 1, "columns", spec_.columns, "1 or more");
    demand_of_grid(spec_.gap >= 0 && std::isfinite(spec_.gap), "gap", spec_.gap, "0 m or more");
    demand_of_grid(std::abs(spec_.shear) <= k_largest_shear, "shear_deg", spec_.shear / k_deg, "-80 to 80");
  }

  /// Height of the sheared rows on one side of the middle line, without a middle row [m].
  double sheared_height() const { return 0.5 * (spec_.high.y() - spec_.low.y()) - base(0); }
  /// Height of the lower edge of the k-th row above the middle line, not counting a middle row [m].
  double base(int row) const {
    const double start = spec_.rows % 2 == 1 ? 0.5 * height_ + spec_.gap : 0.5 * spec_.gap;
    return start + row * (height_ + spec_.gap);
  }

  /// Left and right ends of the pieces of a row, before shear. A shifted row has half pieces at its ends.
  std::vector<std::pair<double, double>> row_columns(int rows_from_middle) const {
    std::vector<std::pair<double, double>> columns;
    const double pitch = width_ + along_gap_, end = first_ + spec_.columns * pitch - along_gap_;
    const bool shifted = spec_.stagger && rows_from_middle % 2 == 1;
    for (int k = 0; k < spec_.columns + (shifted ? 1 : 0); ++k) {
      const double left = first_ + (shifted ? k - 0.5 : k) * pitch;
      columns.emplace_back(std::max(left, first_), std::min(left + width_, end));
    }
    return columns;
  }

  std::vector<Vec2> middle_piece(double left, double right) const {
    const double half = 0.5 * height_;
    return {{left, middle_ - half}, {right, middle_ - half}, {right, middle_ + half}, {left, middle_ + half}};
  }

  std::vector<Vec2> upper_piece(int row, double left, double right) const {
    const double low = base(row), high = low + height_;
    const double at_low = lean_ * (low - base(0)), at_high = lean_ * (high - base(0));
    return {{left + at_low, middle_ + low},
            {right + at_low, middle_ + low},
            {right + at_high, middle_ + high},
            {left + at_high, middle_ + high}};
  }

  std::vector<Vec2> mirrored(const std::vector<Vec2>& piece) const {
    std::vector<Vec2> image;
    for (auto corner = piece.rbegin(); corner != piece.rend(); ++corner)
      image.emplace_back(corner->x(), 2 * middle_ - corner->y());
    return image;
  }

  const GridSpec& spec_;
  double middle_;         ///< Y of the region's middle line [m]
  double height_ = 0;     ///< height of a row [m]
  double width_ = 0;      ///< width of a piece along X [m]
  double along_gap_ = 0;  ///< gap between columns along X [m]
  double lean_ = 0;       ///< shift along X per height
  double first_ = 0;      ///< X of the first piece's left end where the shear starts [m]
};

bool meets(const std::vector<Vec2>& piece, const std::vector<Obstacle>& obstacles) {
  ConvexOutline outline;
  outline.corners = piece;
  fill_normals(outline);
  return std::any_of(obstacles.begin(), obstacles.end(),
                     [&](const Obstacle& o) { return best_axis(outline, o.outline).gap < 0; });
}

}  // namespace

FieldResult grid_field(const GridSpec& spec) {
  const auto keep_out = grown_outlines(spec.keep_out, spec.keep_out_margin);
  std::vector<Obstacle> obstacles;
  for (const auto& outline : keep_out) obstacles.push_back(obstacle(outline));
  FieldResult result;
  double ice = 0;
  for (auto& piece : Grid(spec).pieces()) {
    if (meets(piece, obstacles)) {
      ++result.left_out;
      continue;
    }
    ice += geometry::polygon_moments(piece).area;
    result.floes.push_back({std::move(piece)});
  }
  const double free = free_area(spec.low, spec.high, keep_out);
  result.concentration = free > 0 ? ice / free : 0;
  return result;
}

}  // namespace nilas::field
