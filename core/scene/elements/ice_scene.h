#pragma once
/// Values of <ice>.
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "core/base/math.h"
#include "core/choices/ice_choices.h"
#include "core/scene/elements/field_scene.h"

namespace nilas {

struct FloeScene : IcePlacement {
  std::string name;
  std::vector<Vec2> outline;  ///< in G [m]
  int line = 0;

  bool operator==(const FloeScene&) const = default;
};
struct VaryScene {
  FloeProperty property = FloeProperty::thickness;
  SpreadKind distribution = SpreadKind::normal;
  double cov = 0;
  double mean = 0;                                            ///< of a strength, in its unit; 0: the ice's own
  double correlation_length = 0;                              ///< [m]; 0: one value per floe
  std::vector<std::pair<FloeProperty, double>> correlations;  ///< with other properties, of the normal scores
  int line = 0;

  bool operator==(const VaryScene&) const = default;
};
/// Ground frame at the start.
struct WeakLineScene {
  std::vector<Vec2> points;  ///< [m]
  double strength = 1;       ///< share left of flexural strength and fracture toughness

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

}  // namespace nilas
