#include "hydro/added_mass/floe_added_mass.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "core/base/error.h"

namespace nilas::hydro {

namespace {

constexpr double k_aspect_rounding = 1e-6;  // of the aspect

using Row = std::pair<double, double>;

/// Linear between the rows of a table, whose first numbers rise; constant beyond its ends.
template <std::size_t Rows>
double interpolated(const std::array<Row, Rows>& table, double x) {
  if (x <= table.front().first) return table.front().second;
  for (std::size_t k = 1; k < Rows; ++k)
    if (x < table[k].first) {
      const double share = (x - table[k - 1].first) / (table[k].first - table[k - 1].first);
      return table[k - 1].second + share * (table[k].second - table[k - 1].second);
    }
  return table.back().second;
}

/// The rectangle of a floe's area and second moments.
struct Rectangle {
  double area = 0;               ///< [m^2]
  double length = 0, width = 0;  ///< [m]
  Vec2 along = Vec2::UnitX();    ///< unit vector along the length, body axes
};

Rectangle rectangle_of(const std::vector<Vec2>& outline) {
  double area = 0;
  Eigen::Matrix2d moments =
      Eigen::Matrix2d::Zero();  // integrals of x x^T about the centroid, where the outline has its origin
  for (std::size_t k = 0; k < outline.size(); ++k) {
    const Vec2 &a = outline[k], &b = outline[(k + 1) % outline.size()];
    const double cross = a.x() * b.y() - a.y() * b.x();
    area += cross / 2;
    const Vec2 sum = a + b;
    moments += cross / 24 * (a * a.transpose() + b * b.transpose() + sum * sum.transpose());
  }
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix2d> axes(moments);
  const double aspect = std::sqrt(axes.eigenvalues()[1] / axes.eigenvalues()[0]);
  Rectangle found;
  found.area = area;
  found.width = std::sqrt(area / aspect);
  found.length = area / found.width;
  // The two second moments of a square agree to rounding, and any axes are principal.
  if (aspect > 1 + k_aspect_rounding) found.along = axes.eigenvectors().col(1);
  return found;
}

/// Added mass of a face of this width in motion across it, over a floe of `length` along the motion.
double face(double width, double length, double draught, double density) {
  return rectangle_coefficient(2 * draught / length) * k_pi / 2 * density * draught * draught * width;
}

}  // namespace

double plate_coefficient(double aspect) {
  static constexpr std::array<Row, 11> k_table{{{1.0, 0.579},
                                                {1.25, 0.642},
                                                {1.5, 0.690},
                                                {1.59, 0.704},
                                                {2.0, 0.757},
                                                {2.5, 0.801},
                                                {3.0, 0.830},
                                                {4.0, 0.871},
                                                {5.0, 0.897},
                                                {8.0, 0.934},
                                                {10.0, 0.947}}};
  if (aspect <= k_table.back().first) return interpolated(k_table, aspect);
  // A long plate lacks the flow around its ends: what is missing to 1 falls with the ratio.
  return 1 - (1 - k_table.back().second) * k_table.back().first / aspect;
}

double rectangle_coefficient(double ratio) {
  static constexpr std::array<Row, 7> k_table{
      {{0.1, 2.23}, {0.2, 1.98}, {0.5, 1.70}, {1.0, 1.51}, {2.0, 1.36}, {5.0, 1.21}, {10.0, 1.14}}};
  return interpolated(k_table, ratio);
}

Mat6 floe_added_mass(FloeAddedMass kind, const geometry::Shape& floe, double draught, double density) {
  NILAS_DEMAND(floe.kind == geometry::ShapeKind::prism && draught >= 0 && density > 0);
  if (kind == FloeAddedMass::none) return Mat6::Zero();
  const Rectangle rectangle = rectangle_of(floe.outline);
  const double length = rectangle.length, width = rectangle.width;
  // The aspect up to which a disc is nearer than a strip, rounding included: a floe of 3 m x 2 m is a disc, however it
  // is turned.
  constexpr double k_longest_disc = 1.5 * (1 + k_aspect_rounding);
  const bool disc =
      kind == FloeAddedMass::disc || (kind == FloeAddedMass::automatic && length <= k_longest_disc * width);
  Vec6 own;  // along length, width, vertical
  if (disc) {
    const double radius = std::sqrt(rectangle.area / k_pi), side = std::sqrt(rectangle.area);
    const double across = face(side, side, draught, density), tilt = 8.0 / 45 * density * std::pow(radius, 5);
    own << across, across, 4.0 / 3 * density * std::pow(radius, 3), tilt, tilt, 0;
  } else {
    const double heave = plate_coefficient(length / width) * k_pi / 8 * density * width * width * length;
    const double along = face(width, length, draught, density), across = face(length, width, draught, density);
    own << along, across, heave, k_pi / 16 * density * std::pow(width / 2, 4) * length, heave * length * length / 12,
        (along * width * width + across * length * length) / 12;
  }
  Mat3 axes = Mat3::Identity();
  axes.col(0) << rectangle.along, 0;
  axes.col(1) << -rectangle.along.y(), rectangle.along.x(), 0;
  Mat6 added = Mat6::Zero();
  added.topLeftCorner<3, 3>() = axes * own.head<3>().asDiagonal() * axes.transpose();
  added.bottomRightCorner<3, 3>() = axes * own.tail<3>().asDiagonal() * axes.transpose();
  return 0.5 * (added + added.transpose());
}

}  // namespace nilas::hydro
