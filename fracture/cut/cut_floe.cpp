#include "fracture/cut/cut_floe.h"

#include <algorithm>
#include <utility>

#include "core/base/error.h"
#include "core/geometry/mass_properties.h"
#include "core/geometry/polygon.h"
#include "fracture/cut/smallest_box.h"

namespace nilas::fracture {

namespace {

/// Throws ContractError unless the floe is a uniform plate about its centroid.
void check(const FloeState& floe) {
  constexpr double k_rounding = 1e-9;
  NILAS_DEMAND(floe.thickness > 0 && floe.mass > 0);
  const geometry::MassProperties plate = geometry::prism_properties(floe.outline, floe.thickness, 1);
  const Mat3 inertia = floe.mass / plate.mass * plate.inertia;
  NILAS_DEMAND((floe.inertia_B - inertia).norm() <= k_rounding * inertia.norm());
  double reach = 0;
  for (const Vec2& p : floe.outline) reach = std::max(reach, p.norm());
  NILAS_DEMAND(plate.com.norm() <= k_rounding * reach);
}

struct PieceShape {
  std::vector<Vec2> outline;      ///< The outline about its centroid [m].
  geometry::MassProperties unit;  ///< Properties at density 1; the centre is in the floe's B.
};

PieceShape shape_of(const CutPiece& piece, double thickness) {
  PieceShape shape{piece.outline, geometry::prism_properties(piece.outline, thickness, 1)};
  for (Vec2& p : shape.outline) p -= shape.unit.com.head<2>();
  return shape;
}

std::vector<double> masses_of(const std::vector<PieceShape>& shapes, double mass) {
  double volume = 0;
  for (const PieceShape& shape : shapes) volume += shape.unit.mass;
  std::vector<double> masses;
  std::size_t largest = 0;
  for (std::size_t i = 0; i < shapes.size(); ++i) {
    masses.push_back(mass * (shapes[i].unit.mass / volume));
    if (masses[i] > masses[largest]) largest = i;
  }
  double others = 0;
  for (std::size_t i = 0; i < masses.size(); ++i)
    if (i != largest) others += masses[i];
  masses[largest] = mass - others;
  return masses;
}

Vec3 common_centre(const std::vector<PieceShape>& shapes, const std::vector<double>& masses, double mass) {
  Vec3 centre = Vec3::Zero();
  for (std::size_t i = 0; i < shapes.size(); ++i) centre += masses[i] / mass * shapes[i].unit.com;
  return centre;
}

/// The piece of this mass with the floe's motion at its centre, `from_centre` [m] in the floe's B.
FloePiece piece_of(const FloeState& floe, PieceShape shape, double mass, const Vec3& from_centre) {
  const Vec3 r = floe.pose.q.normalized() * from_centre;
  FloePiece piece;
  piece.area = shape.unit.mass / floe.thickness;
  piece.state = floe;
  piece.state.outline = std::move(shape.outline);
  piece.state.mass = mass;
  piece.state.inertia_B = mass / shape.unit.mass * shape.unit.inertia;
  piece.state.pose.p += r;
  piece.state.v_GB += floe.w_GB.cross(r);
  return piece;
}

FloeCut refused(FloeCutStatus status, const CutResult& cut, std::string why) {
  FloeCut result;
  result.status = status;
  result.outline_status = cut.status;
  result.message = std::move(why);
  return result;
}

bool too_small(const FloePiece& piece, const PieceLimits& limits) { return piece.area < limits.min_area; }

bool too_narrow(const FloePiece& piece, const PieceLimits& limits) {
  return smallest_box(piece.state.outline).aspect() > limits.max_aspect;
}

/// Removes small corners that crushing left on a piece. Their mass and motion go to the account of extruded ice.
void trim(FloePiece& piece, MotionAccount& extruded, const Vec3& about_G) {
  constexpr double k_corner = 0.02;  // in thicknesses
  FloeState& state = piece.state;
  std::vector<bool> crack = piece.crack;
  PieceShape shape{state.outline, {}};
  if (!trim_corners(shape.outline, crack, k_corner * state.thickness, state.thickness)) return;
  shape.unit = geometry::prism_properties(shape.outline, state.thickness, 1);
  for (Vec2& p : shape.outline) p -= shape.unit.com.head<2>();
  const double mass = state.mass * std::min(1.0, shape.unit.mass / (piece.area * state.thickness));
  const MotionAccount before = motion_account(state, about_G);
  const Vec3 from_centre = shape.unit.com;
  piece = piece_of(state, std::move(shape), mass, from_centre);
  piece.crack = std::move(crack);
  const MotionAccount after = motion_account(piece.state, about_G);
  extruded += {before.mass - after.mass, before.momentum - after.momentum,
               before.angular_momentum - after.angular_momentum, before.kinetic_energy - after.kinetic_energy};
}

/// Sorts the pieces by the limits into pieces, brash and extruded ice, or refuses the cut.
FloeCut sorted(std::vector<FloePiece> all, const CutResult& cut, const PieceLimits& limits, const Vec3& about_G,
               const CrushedIce& crushed) {
  FloeCut result;
  result.status = FloeCutStatus::cut;
  result.outline_status = cut.status;
  result.crack_length = cut.crack_length;
  for (std::size_t i = 0; i < all.size(); ++i) {
    FloePiece& piece = all[i];
    if (is_squeezed_out(crushed, cut.pieces[i].outline)) {
      result.extruded_account += motion_account(piece.state, about_G);
      result.extruded.push_back(std::move(piece));
      continue;
    }
    if (!crushed.columns.empty()) trim(piece, result.extruded_account, about_G);
    const bool small = too_small(piece, limits), narrow = too_narrow(piece, limits);
    if ((small || narrow) && limits.small == SmallPieces::refuse)
      return small ? refused(FloeCutStatus::too_small, cut, "a piece is smaller than min_area")
                   : refused(FloeCutStatus::too_narrow, cut, "a piece is longer than max_aspect");
    // The shift to its own centroid rounded the piece once more.
    if (!small && !narrow && !geometry::is_simple(piece.state.outline))
      return refused(FloeCutStatus::geometry, cut, "a piece is not simple about its own centroid");
    if (small || narrow) result.brash_account += motion_account(piece.state, about_G);
    (small || narrow ? result.brash : result.pieces).push_back(std::move(piece));
  }
  return result;
}

}  // namespace

MotionAccount& MotionAccount::operator+=(const MotionAccount& o) {
  mass += o.mass;
  momentum += o.momentum;
  angular_momentum += o.angular_momentum;
  kinetic_energy += o.kinetic_energy;
  return *this;
}

MotionAccount motion_account(const FloeState& floe, const Vec3& about_G) {
  const Mat3 R = floe.pose.q.normalized().toRotationMatrix();
  const Vec3 spin = R * (floe.inertia_B * (R.transpose() * floe.w_GB)), momentum = floe.mass * floe.v_GB;
  return {floe.mass, momentum, spin + (floe.pose.p - about_G).cross(momentum),
          0.5 * (momentum.dot(floe.v_GB) + spin.dot(floe.w_GB))};
}

FloeCut cut_floe(const FloeState& floe, const std::vector<std::vector<Vec2>>& cracks, const PieceLimits& limits,
                 const CrushedIce& crushed) {
  const CutResult cut = cut_outline(floe.outline, cracks);
  if (cut.pieces.empty()) return refused(FloeCutStatus::geometry, cut, cut.message);
  check(floe);
  if (cut.status == CutStatus::uncut && !is_squeezed_out(crushed, floe.outline))
    return refused(FloeCutStatus::uncut, cut, "the cracks separate nothing");
  std::vector<PieceShape> shapes;
  for (const CutPiece& piece : cut.pieces) shapes.push_back(shape_of(piece, floe.thickness));
  const std::vector<double> masses = masses_of(shapes, floe.mass);
  const Vec3 centre = common_centre(shapes, masses, floe.mass);
  std::vector<FloePiece> all;
  for (std::size_t i = 0; i < shapes.size(); ++i) {
    const Vec3 from_centre = shapes[i].unit.com - centre;
    all.push_back(piece_of(floe, std::move(shapes[i]), masses[i], from_centre));
    all.back().crack = cut.pieces[i].crack;
  }
  return sorted(std::move(all), cut, limits, floe.pose.p, crushed);
}

}  // namespace nilas::fracture
