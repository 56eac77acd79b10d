#pragma once
/// The specification of an ice field, and the resulting floes.
#include <cstdint>
#include <vector>

#include "core/base/math.h"
#include "core/bodies/ice_properties.h"
#include "core/choices/defaults.h"
#include "core/choices/ice_choices.h"

namespace nilas::field {

/// Largest shear of a parallelogram; beyond it floes are needles [rad].
constexpr double k_largest_shear = 80 * k_deg;

/// One floe of a field, in the still-water plane.
struct FieldFloe {
  std::vector<Vec2> outline;                               ///< counter-clockwise, in G [m]
  double thickness = 0;                                    ///< [m]; 0: the scene's
  double density = 0;                                      ///< [kg/m^3]; 0: the scene's
  double flexural_strength = 0, compressive_strength = 0;  ///< [Pa]; 0: the scene's
  double fracture_toughness = 0;                           ///< [Pa sqrt(m)]; 0: the scene's
  bool fixed = false;                                      ///< never moves, whatever the field says
};

struct PackedSpec {
  Vec2 low = Vec2::Zero(), high = Vec2::Ones();      ///< region [m]
  double concentration = defaults::k_concentration;  ///< area of ice / free area of region
  double overlap_tolerance =
      defaults::k_overlap_tolerance;  ///< largest overlap depth left, as a fraction of the mean floe size
  SizeDistribution distribution = SizeDistribution::lognormal;
  double mean = defaults::k_floe_mean, sd = defaults::k_floe_sd;  ///< mean and deviation of sqrt(area) [m]
  double min = defaults::k_floe_min, max = defaults::k_floe_max;  ///< limits of sqrt(area) [m]
  double exponent = defaults::k_size_exponent;                    ///< power law n(D) ~ D^-(1 + exponent)
  FloeShape shape = FloeShape::polygon;
  int vertices_min = defaults::k_vertices_min, vertices_max = defaults::k_vertices_max;
  double aspect = defaults::k_aspect;  ///< long side / short side of rectangle and parallelogram
  double shear = 0;                    ///< parallelogram, angle from a rectangle [rad]
  std::vector<std::vector<Vec2>>
      library;  ///< simple counter-clockwise outlines to draw from, scaled to the drawn sizes
  std::vector<std::vector<Vec2>>
      keep_out;  ///< convex counter-clockwise outlines that ice keeps clear of; their area is no part of the region
  double keep_out_margin = 0;  ///< [m]
  std::uint64_t seed = 1;
};
struct FieldResult {
  std::vector<FieldFloe> floes;
  double concentration = 0;  ///< concentration reached: ice area / free region area
  double worst_overlap = 0;  ///< depth [m]
  int passes = 0;            ///< relaxation passes used
  int fitted = 0;            ///< polygon floes whose outline was fitted to its neighbours, see pack_field
  int left_out = 0;          ///< floes dropped because they met a keep-out outline
  std::vector<bodies::WeakLine> weak_lines;  ///< lines of reduced strength, frame G
};

/// An intact sheet.
struct LevelSpec {
  Vec2 low = Vec2::Zero(), high = Vec2::Ones();  ///< region [m]
  std::vector<std::vector<Vec2>> keep_out;       ///< convex, counter-clockwise
  double keep_out_margin = 0;                    ///< [m]
  Vec2 aft = -Vec2::UnitX();                     ///< direction from which a hull came
};

/// A channel of broken ice along X between two sheets.
struct ChannelSpec {
  PackedSpec ice;             ///< specification of the whole region, but with the channel's concentration
  double width = 1;           ///< width of the channel, centred on the region's middle line [m]
  Vec2 aft = -Vec2::UnitX();  ///< see LevelSpec
};

struct GridSpec {
  Vec2 low = Vec2::Zero(), high = Vec2::Ones();
  int rows = 1;      ///< number along Y
  int columns = 1;   ///< number along X
  double gap = 0;    ///< gap between neighbours [m]
  double shear = 0;  ///< lines of constant X turned by this angle from Y, mirrored about the region's middle line [rad]
  bool stagger = false;  ///< every second row shifted by half a piece
  std::vector<std::vector<Vec2>> keep_out;
  double keep_out_margin = 0;
};

}  // namespace nilas::field
