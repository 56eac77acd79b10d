#pragma once
/// Values of <ice>.
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "core/base/math.h"
#include "core/choices/ice_choices.h"
#include "core/scene/elements/field_scene.h"

namespace nilas::scene {

struct FloeScene : IcePlacement {
  std::string name;
  std::vector<Vec2> outline;  ///< frame G [m]
  int line = 0;

  bool operator==(const FloeScene&) const = default;
};
struct VaryScene {
  FloeProperty property = FloeProperty::thickness;
  SpreadKind distribution = SpreadKind::normal;
  double cov = 0;
  double mean = 0;                                            ///< mean of a strength, in its unit; 0: that of the ice
  double correlation_length = 0;                              ///< [m]; 0: one value per floe
  std::vector<std::pair<FloeProperty, double>> correlations;  ///< of the normal scores with other properties
  int line = 0;

  bool operator==(const VaryScene&) const = default;
};
/// A weak line, in the ground frame at the start.
struct WeakLineScene {
  std::vector<Vec2> points;  ///< [m]
  double strength = 1;       ///< remaining share of flexural strength and fracture toughness

  bool operator==(const WeakLineScene&) const = default;
};
struct IceScene {
  double density = 920, youngs_modulus = 6e7, poisson = 0.3, thickness = 0.04;
  std::vector<FieldScene> fields;
  std::vector<FloeScene> floes;
  std::vector<WeakLineScene> weak_lines;
  std::vector<VaryScene> vary;

  bool operator==(const IceScene&) const = default;
};

}  // namespace nilas::scene
