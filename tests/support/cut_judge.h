#pragma once
/// Checks the quantities that a cut must conserve, without the cutting code.
#include <algorithm>
#include <cmath>
#include <vector>

#include "core/geometry/mass_properties.h"
#include "core/geometry/orientation.h"
#include "core/geometry/polygon.h"
#include "fracture/cut/cut_floe.h"
#include "fracture/cut/cut_outline.h"
#include "fracture/cut/snap_lines.h"
#include "tests/support/about_centroid.h"
#include "tests/support/cut_cases.h"
#include "tests/support/random_vectors.h"

namespace nilas::test {

inline double perimeter(const Outline& outline) {
  double sum = 0;
  for (std::size_t i = 0; i < outline.size(); ++i) sum += (outline[(i + 1) % outline.size()] - outline[i]).norm();
  return sum;
}

/// Area gained or lost [m^2].
inline double area_error(const Outline& outline, const std::vector<fracture::CutPiece>& pieces) {
  double sum = 0;
  for (const fracture::CutPiece& piece : pieces) sum += geometry::polygon_moments(piece.outline).area;
  return std::abs(sum - geometry::polygon_moments(outline).area);
}

inline Eigen::AlignedBox2d box_of(const Outline& outline) {
  Eigen::AlignedBox2d box;
  for (const Vec2& p : outline) box.extend(p);
  return box;
}

/// Deepest overlap between two of the outlines, over their convex parts by separating axes [m].
inline double deepest_overlap(const std::vector<Outline>& outlines) {
  std::vector<std::vector<Outline>> parts;
  for (const Outline& outline : outlines) parts.push_back(geometry::convex_pieces(outline));
  double deepest = 0;
  for (std::size_t i = 0; i < parts.size(); ++i)
    for (std::size_t j = i + 1; j < parts.size(); ++j)
      for (const Outline& a : parts[i])
        for (const Outline& b : parts[j])
          if (box_of(a).intersects(box_of(b))) deepest = std::max(deepest, geometry::convex_overlap(a, b));
  return deepest;
}

inline double deepest_overlap(const std::vector<fracture::CutPiece>& pieces) {
  std::vector<Outline> outlines;
  for (const fracture::CutPiece& piece : pieces) outlines.push_back(piece.outline);
  return deepest_overlap(outlines);
}

/// A uniform plate with this outline, moved to its centroid, at a random pose and with random velocities.
inline fracture::FloeState random_floe(Outline outline, RandomStream& random) {
  outline = about_centroid(std::move(outline));
  const double size_of_floe = std::sqrt(geometry::polygon_moments(outline).area);
  const auto vector = [&](double size) {
    return Vec3(size * random.normal(), size * random.normal(), size * random.normal());
  };
  fracture::FloeState floe;
  floe.thickness = random.uniform(0.02, 0.2) * size_of_floe;
  const geometry::MassProperties plate = geometry::prism_properties(outline, floe.thickness, 900);
  floe.mass = plate.mass;
  floe.inertia_B = plate.inertia;
  floe.pose.q = random_attitude(random);
  floe.pose.p = vector(10 * size_of_floe);
  floe.v_GB = vector(1);
  floe.w_GB = vector(0.1);
  floe.outline = std::move(outline);
  return floe;
}

/// Relative errors of a cut, each over the sum of the magnitudes of its summands.
struct MotionError {
  double mass = 0, momentum = 0, angular_momentum = 0, energy = 0;
  double worst() const { return std::max({mass, momentum, angular_momentum, energy}); }
};

inline MotionError motion_error(const fracture::FloeState& floe, const fracture::FloeCut& cut) {
  const Vec3& about = floe.pose.p;
  const fracture::MotionAccount before = fracture::motion_account(floe, about);
  fracture::MotionAccount after = cut.brash_account;
  after += cut.extruded_account;
  // Positions are rounded, which changes the lever arms of the momenta.
  const double size = std::sqrt(geometry::polygon_moments(floe.outline).area);
  double momentum = before.momentum.norm(), angular = before.angular_momentum.norm() + size * momentum;
  for (const fracture::FloePiece& piece : cut.pieces) {
    const fracture::MotionAccount part = fracture::motion_account(piece.state, about);
    after += part;
    momentum += part.momentum.norm();
    angular += part.angular_momentum.norm();
  }
  return {std::abs(after.mass - before.mass) / before.mass, (after.momentum - before.momentum).norm() / momentum,
          (after.angular_momentum - before.angular_momentum).norm() / angular,
          std::abs(after.kinetic_energy - before.kinetic_energy) / before.kinetic_energy};
}

/// The pieces in the floe's plane, with their own rounding. Pieces that rounding makes touch themselves are left out.
inline std::vector<Outline> pieces_in_plane(const fracture::FloeState& floe, const fracture::FloeCut& cut) {
  std::vector<Outline> outlines;
  for (const fracture::FloePiece& piece : cut.pieces) {
    const Vec3 r = floe.pose.q.conjugate() * (piece.state.pose.p - floe.pose.p);
    Outline outline = piece.state.outline;
    for (Vec2& p : outline) p += r.head<2>();
    if (sound(outline)) outlines.push_back(std::move(outline));
  }
  return outlines;
}

}  // namespace nilas::test
