#pragma once
/// Values of <ice>.
#include <array>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "core/base/math.h"
#include "core/choices/defaults.h"
#include "core/choices/ice_choices.h"

namespace nilas {

struct SizeScene {
  SizeDistribution distribution = SizeDistribution::lognormal;
  double mean = defaults::k_floe_mean, sd = defaults::k_floe_sd;  ///< [m]
  double min = defaults::k_floe_min, max = defaults::k_floe_max;  ///< [m]
  double exponent = defaults::k_size_exponent;

  bool operator==(const SizeScene&) const = default;
};
struct ShapeScene {
  FloeShape kind = FloeShape::polygon;
  int vertices_min = defaults::k_vertices_min, vertices_max = defaults::k_vertices_max;
  double aspect = defaults::k_aspect;
  std::string library;  ///< absolute path; empty: `kind`

  bool operator==(const ShapeScene&) const = default;
};
struct FieldScene {
  FieldKind kind = FieldKind::packed;
  std::array<double, 4> region{0, 0, 1, 1};  ///< x0 y0 x1 y1 [m]
  double concentration = defaults::k_concentration;
  bool breakable = false;
  double overlap_tolerance = defaults::k_overlap_tolerance;
  std::optional<double> channel_width;  ///< [m]
  int rows = 1, columns = 1;
  double gap = 0, shear_deg = 0;
  bool stagger = false;
  std::string file;  ///< absolute path of a GeoJSON field
  bool fixed = false;
  Vec3 velocity = Vec3::Zero();
  double z = 0;  ///< offset from floating equilibrium [m]
  std::optional<double> thickness;
  SizeScene size;
  ShapeScene shape;
  std::optional<double> bond;  ///< strength left on the seams of floes that are frozen together

  bool operator==(const FieldScene&) const = default;
};
struct FloeScene {
  std::string name;
  std::vector<Vec2> outline;  ///< in G [m]
  bool fixed = false, breakable = false;
  Vec3 velocity = Vec3::Zero();
  double z = 0;
  std::optional<double> thickness;
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
