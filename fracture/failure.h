#pragma once
/// Whether a floe breaks under what presses on its edge, and along which cracks. docs/theory/fracture.md
#include <optional>
#include <string>
#include <vector>

#include "core/choices/defaults.h"
#include "core/choices/fracture_choices.h"
#include "fracture/bend/edge_contact.h"
#include "fracture/bend/edge_load.h"
#include "fracture/bend/plate.h"
#include "fracture/bend/wedge.h"
#include "fracture/crush/ice_columns.h"
#include "fracture/cut/crack_lines.h"
#include "fracture/cut/crack_path.h"
#include "fracture/cut/local_ice.h"
#include "fracture/split/splitting_lefm.h"

namespace nilas {

struct FailureSettings {
  double youngs_modulus = 5e9;  ///< [Pa]
  double poisson = 0.3;
  double water_density = defaults::k_water_density;  ///< [kg/m^3]
  double gravity = defaults::k_gravity;              ///< [m/s^2]
  bool bending = false;
  double wedge_angle = defaults::k_wedge_angle_deg * k_deg;  ///< alpha_wedge [rad]
  SpeedRule speed;                                           ///< of the breaking length
  std::optional<SplittingModel> splitting;
  double multiplier = defaults::k_split_multiplier;  ///< S_k of splitting by geometry
  double min_area = 0;                               ///< of a piece that splitting leaves [m^2]
  double max_aspect = defaults::k_max_aspect;        ///< R_size, of the same
  bool curved = false;                               ///< cracks go where the ice around the contact is weak
  double segment = defaults::k_segment_thicknesses;  ///< longest segment of curved splitting cracks [thicknesses]
};

/// What a floe bears near a contact.
struct IceAtContact {
  double thickness = 0;              ///< [m]
  double flexural_strength = 0;      ///< [Pa]
  double fracture_toughness = 0;     ///< [Pa sqrt(m)]
  const LocalIce* around = nullptr;  ///< for curved cracks; none: alike everywhere
};

enum class FailureKind { bending, splitting, crushing };
std::string name_of(FailureKind kind);

/// A way to break.
struct Failure {
  FailureKind kind = FailureKind::bending;
  double ratio = 0;           ///< load over what the ice bears; it breaks from 1 on
  Vec2 point = Vec2::Zero();  ///< of the edge where it starts, in B; of crushing the middle of what goes [m]
  double radius = 0;          ///< of the circumferential crack, where it is farthest [m]; 0 of splitting by lefm
  std::vector<std::vector<Vec2>> cracks;  ///< for cut_floe
  CrushedIce crushed = {};                ///< for cut_floe; none but of crushing
};

/// Stresses at an edge under a load, over what the ice bears.
struct BendingState {
  double radial = 0;  ///< largest stress of the whole sheet over the flexural strength: radial cracks from 1 on
  double wedges = 0;  ///< of the wedges between radial cracks: the circumferential crack from 1 on
  double radius = 0;  ///< R_bending [m]
  WedgeFan fan;
  std::vector<double> radii;  ///< of the circumferential crack where it is curved, as wedge_cracks takes them [m]
};

/// Tables of the models that are asked for, built once; then pure.
class FailureRules {
 public:
  explicit FailureRules(const FailureSettings& settings);

  /// Two stages [Nevel; the order of Metrikin 2014]: the floe's edge as that of a half-infinite plate under the
  /// vertical load P, spread over the contact's width, cracks radially at its flexural strength (EdgeLoad); then the
  /// wedges between those cracks, as many as span the ice from edge to edge in angles nearest to `wedge_angle`, share P
  /// over the contact's depth and break at x_max (WedgeTable, bending_radius). Half the width, and the depth, are
  /// Westergaard's equivalent lengths of loads narrower than 1.724 h, sqrt(1.6 x^2 + h^2) - 0.675 h. With curved cracks
  /// each wedge breaks at its weakest section (weakest_sections), once the edge has cracked.
  BendingState bending_state(const std::vector<Vec2>& outline, const EdgeContact& contact,
                             const IceAtContact& ice) const;
  /// F_Y over the largest force that a floe with the crack's length and the width across it bears (splitting_force of a
  /// short starter crack), and the crack. None where no line leads through the ice,
  /// or where it is more than eight times wider than long: there a corner is cut off, no floe split. A curved crack
  /// (crack_path) runs through at the largest force that its ice bears on the way: of K_IC(A) h sqrt(L) / H(A/L, W/L),
  /// A measured along it, L its straight length.
  struct SplittingState {
    double ratio = 0;
    std::vector<Vec2> crack;
  };
  std::optional<SplittingState> splitting_state(const std::vector<Vec2>& outline, const EdgeContact& contact,
                                                const IceAtContact& ice) const;

  bool has_curved_cracks() const { return settings_.curved; }

  /// Loads on the edge this near to each other act as one: half of the wedges' characteristic length [m].
  double link(const IceAtContact& ice) const;
  /// Ways to break of a ratio of `least` or more, the largest ratio first. None under a load whose middle is farther
  /// from the edge than link() and half its depth.
  ///   bending: both stages at their strength, where the ice goes farther than R_bending from the contact in the
  ///     middle of one of the wedges at least (a tongue breaks off, however narrow it is across the load);
  ///   geometric: radial cracks, and a chord along the load's direction that split_along takes; bending then
  ///     only where that cut is refused;
  ///   lefm: F_Y at what the floe bears. It competes with bending by the ratios: small floes split first.
  std::vector<Failure> failures(const std::vector<Vec2>& outline, const EdgeContact& contact, const IceAtContact& ice,
                                double least = 1) const;

 private:
  IcePlate plate(const IceAtContact& ice) const;
  bool curves(const IceAtContact& ice) const;
  CrackPath path_from(const Vec2& start, const std::vector<Vec2>& outline, const EdgeContact& contact,
                      const IceAtContact& ice) const;
  double bearable_force(const CrackPath& path, const SplittingFloe& floe) const;
  std::optional<Failure> geometric_split(const std::vector<Vec2>& outline, const EdgeContact& contact,
                                         const BendingState& state, const IceAtContact& ice, double least) const;

  FailureSettings settings_;
  EdgeLoad edge_;
  WedgeTable wedge_;
  std::optional<SplittingTable> splitting_;
};

}  // namespace nilas
