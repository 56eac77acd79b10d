#pragma once
/// Strengths of the ice of breakable floes, in arrays parallel to Bodies.
#include <Eigen/Geometry>
#include <functional>
#include <vector>

#include "core/bodies/bodies.h"

namespace nilas::bodies {

/// A strength of one floe: its mean over the floe, and how it varies inside.
struct FloeStrength {
  double mean = 0;                              ///< [Pa], of toughness [Pa sqrt(m)]
  std::function<double(double, double)> at_xy;  ///< at (x, y) of the floe's frame B [m]; empty: the mean

  double at(const Vec3& x_B) const { return at_xy ? at_xy(x_B.x(), x_B.y()) : mean; }
};

/// A line along which the ice of a floe is weaker: a refrozen crack, the seam between floes frozen together.
struct WeakLine {
  std::vector<Vec2> points;  ///< polyline in the floe's frame B [m]
  double strength = 1;       ///< share of flexural strength and fracture toughness that is left on it, in (0, 1]
};

/// The segments that may meet the outline, relative to `centre` in their frame; both frames have the same axes.
std::vector<WeakLine> lines_near(const std::vector<WeakLine>& lines, const Vec2& centre,
                                 const std::vector<Vec2>& outline);

/// One entry per body, in the order of the bodies; bodies that are no floes have zeros.
struct IceProperties {
  std::vector<char> breakable;
  std::vector<FloeStrength> flexural_strength, compressive_strength, fracture_toughness;
  std::vector<std::vector<WeakLine>> weak_lines;

  bool is_breakable(int b) const { return static_cast<std::size_t>(b) < breakable.size() && breakable[b] != 0; }
  /// Removes the marked entries.
  void remove(const std::vector<char>& gone) {
    const auto drop = [&](auto&... lists) { (remove_marked(gone, lists), ...); };
    drop(breakable, flexural_strength, compressive_strength, fracture_toughness, weak_lines);
  }
  /// Gives entries to all bodies up to `count`.
  void resize(std::size_t count) {
    breakable.resize(count, 0);
    flexural_strength.resize(count);
    compressive_strength.resize(count);
    fracture_toughness.resize(count);
    weak_lines.resize(count);
  }
};

}  // namespace nilas::bodies
