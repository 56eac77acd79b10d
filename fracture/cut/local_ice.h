#pragma once
/// The strengths of a floe's ice as functions of the place.
#include <functional>
#include <vector>

#include "core/base/math.h"
#include "core/bodies/ice_properties.h"

namespace nilas::fracture {

/// The strengths in the floe's frame B. An empty function means that the strength is the same everywhere.
struct LocalIce {
  std::function<double(const Vec2&)> flexural_strength;   ///< Flexural strength off the weak lines [Pa].
  std::function<double(const Vec2&)> fracture_toughness;  ///< Fracture toughness off the weak lines [Pa sqrt(m)].
  std::vector<bodies::WeakLine> weak_lines;

  /// Whether the ice is the same everywhere, so that cracks are straight.
  bool is_uniform() const { return !flexural_strength && !fracture_toughness && weak_lines.empty(); }
};

}  // namespace nilas::fracture
