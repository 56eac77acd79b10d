#pragma once
/// What the ice of a floe bears from place to place.
#include <functional>
#include <vector>

#include "core/base/math.h"
#include "core/bodies/ice_properties.h"

namespace nilas {

/// In the floe's frame B. A function that is empty means that the strength is the same everywhere.
struct LocalIce {
  std::function<double(const Vec2&)> flexural_strength;   ///< off the weak lines [Pa]
  std::function<double(const Vec2&)> fracture_toughness;  ///< off the weak lines [Pa sqrt(m)]
  std::vector<WeakLine> weak_lines;

  /// A crack has no reason to leave its straight way.
  bool is_uniform() const { return !flexural_strength && !fracture_toughness && weak_lines.empty(); }
};

}  // namespace nilas
