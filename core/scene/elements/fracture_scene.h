#pragma once
/// Values of <fracture>.
#include <optional>

#include "core/choices/defaults.h"
#include "core/choices/fracture_choices.h"

namespace nilas::scene {

struct CrushingScene {
  CrushingModel model = CrushingModel::explicit_area;
  double coefficient = 1e5, exponent = -0.7;  ///< parameters of model pressure-area [Pa m^(-2 exponent), -]
  bool between_floes = false;
  std::optional<double> clear_volume;  ///< [m^3]

  bool operator==(const CrushingScene&) const = default;
};
struct BendingScene {
  BendingModel model = BendingModel::nevel;
  double wedge_angle_deg = defaults::k_wedge_angle_deg;
  double speed_slope = 0;  ///< [s/m]

  bool operator==(const BendingScene&) const = default;
};
struct SplittingScene {
  SplittingModel model = SplittingModel::geometric;
  double multiplier = defaults::k_split_multiplier;

  bool operator==(const SplittingScene&) const = default;
};
struct CracksScene {
  CrackPathKind path = CrackPathKind::straight;
  double segment_thicknesses = defaults::k_segment_thicknesses;

  bool operator==(const CracksScene&) const = default;
};
struct DamageScene {
  double exponent = 13.5, endurance = 0.6;

  bool operator==(const DamageScene&) const = default;
};
struct FractureScene {
  double flexural_strength = 4e4, compressive_strength = 1e5;  ///< [Pa]
  double fracture_toughness = 3e3;                             ///< [Pa sqrt(m)]
  double min_area = 2e-4;                                      ///< [m^2]
  double max_aspect = defaults::k_max_aspect;
  SmallPieces small_pieces = SmallPieces::brash;
  std::optional<CrushingScene> crushing;
  std::optional<BendingScene> bending;
  std::optional<SplittingScene> splitting;
  std::optional<CracksScene> cracks;
  std::optional<DamageScene> damage;

  /// Whether floes can break into pieces.
  bool cuts_floes() const { return bending || splitting || (crushing && crushing->clear_volume); }

  bool operator==(const FractureScene&) const = default;
};

}  // namespace nilas::scene
