#pragma once
/// Rules that say whether a floe breaks under a load on its edge, and along which cracks. docs/theory/fracture.md
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

namespace nilas::fracture {

struct FailureSettings {
  double youngs_modulus = 5e9;  ///< [Pa]
  double poisson = 0.3;
  double water_density = defaults::k_water_density;  ///< [kg/m^3]
  double gravity = defaults::k_gravity;              ///< [m/s^2]
  bool bending = false;
  double wedge_angle = defaults::k_wedge_angle_deg * k_deg;  ///< alpha_wedge [rad]
  SpeedRule speed;                                           ///< The rule of the breaking length at speed.
  std::optional<SplittingModel> splitting;
  double multiplier = defaults::k_split_multiplier;  ///< S_k of the rule `geometric`.
  double min_area = 0;                               ///< Least area of a piece that this rule leaves [m^2].
  double max_aspect = defaults::k_max_aspect;        ///< R_size: largest aspect of such a piece.
  bool curved = false;                               ///< Cracks follow the weak ice around the contact.
  double segment = defaults::k_segment_thicknesses;  ///< longest segment of curved splitting cracks [thicknesses]
};

/// Thickness and strengths of a floe near a contact.
struct IceAtContact {
  double thickness = 0;              ///< [m]
  double flexural_strength = 0;      ///< [Pa]
  double fracture_toughness = 0;     ///< [Pa sqrt(m)]
  const LocalIce* around = nullptr;  ///< The ice around, for curved cracks; null: uniform.
};

enum class FailureKind { bending, splitting, crushing };
std::string name_of(FailureKind kind);

/// A failure mode of a floe under a load, with its cracks.
struct Failure {
  FailureKind kind = FailureKind::bending;
  /// The load over the load that the ice bears; the floe breaks from 1 on. For crushing: the volume of crushed ice over
  /// clear_volume.
  double ratio = 0;
  /// The point of the edge where the break starts, in B; for crushing the centroid of the ice that leaves [m].
  Vec2 point = Vec2::Zero();
  /// Largest radius of the circumferential crack [m]. For splitting by `geometric` R_bending of its rule, 0 for `lefm`
  /// and crushing.
  double radius = 0;
  std::vector<std::vector<Vec2>> cracks;  ///< The cracks for cut_floe, in B [m].
  CrushedIce crushed = {};                ///< The crushed ice for cut_floe; empty unless `kind` is crushing.
};

/// Stresses at an edge under a load, over the flexural strength.
struct BendingState {
  double radial = 0;  ///< Largest stress of the uncracked sheet over the strength; radial cracks from 1 on.
  double wedges = 0;  ///< The same for the wedges between radial cracks; circumferential crack from 1 on.
  double radius = 0;  ///< R_bending [m]
  WedgeFan fan;
  std::vector<double> radii;  ///< Radii of a curved circumferential crack, for wedge_cracks [m]; else empty.
};

/// The failure rules of a scene. The constructor builds the tables of bending, and for `lefm` that of splitting; all
/// else is pure. Throws ContractError unless 0 < wedge_angle < pi, segment > 0 and 0 <= poisson <= 0.5.
class FailureRules {
 public:
  explicit FailureRules(const FailureSettings& settings);

  /// The two stages of bending (docs/theory/fracture-breaking.md). First the edge of a half-infinite plate under the
  /// vertical load P, spread over the contact's width, cracks radially at its flexural strength (EdgeLoad). Then the
  /// wedges between those cracks share P over the contact's depth and break at x_max (WedgeTable, bending_radius). The
  /// wedges span the ice from edge to edge, with angles nearest to `wedge_angle`. Half widths and depths below 1.724 h
  /// become Westergaard's equivalent length sqrt(1.6 x^2 + h^2) - 0.675 h (1926; Huang 2004, eq. 4.19). With curved
  /// cracks each wedge breaks at its weakest section (weakest_sections), once the edge has cracked: from a `radial` of
  /// `least` on, which is below 1 in scenes with <damage>.
  BendingState bending_state(const std::vector<Vec2>& outline, const EdgeContact& contact, const IceAtContact& ice,
                             double least = 1) const;
  /// Splitting by `lefm`: the crack, and F_Y over the force that the floe bears.
  struct SplittingState {
    double ratio = 0;
    std::vector<Vec2> crack;
  };
  /// Returns the state of splitting by `lefm`. The floe has the crack's length L and the width W across it. It bears
  /// the splitting_force of a short starter crack. A curved crack (crack_path) runs through at the largest value of
  /// K_IC(A) h sqrt(L) / H(A/L, W/L), with A measured along the crack and L straight. Returns nothing where the load
  /// is vertical or no line leads through the ice. Also where W > 8 L, since the crack would only cut off a corner
  /// of the floe. Throws ContractError unless the settings name `lefm`.
  std::optional<SplittingState> splitting_state(const std::vector<Vec2>& outline, const EdgeContact& contact,
                                                const IceAtContact& ice) const;

  bool has_curved_cracks() const { return settings_.curved; }

  /// The distance within which loads on the edge act as one [m]: half of the wedges' characteristic length.
  double link(const IceAtContact& ice) const;
  /// The failure modes with a ratio of `least` or more, the largest ratio first. There are none under a load whose
  /// middle is farther from the edge than link() and half its depth.
  ///   bending: both stages reach the strength, and the ice reaches farther than R_bending from the contact in the
  ///     middle of at least one wedge. A tongue therefore breaks off, however narrow it is across the load.
  ///     Cracks that end on the sides of the fan come behind those that go on to free edges.
  ///   geometric: the edge cracks radially, and split_along takes the chord along the load's direction. The floe then
  ///     bends only where that cut is refused.
  ///   lefm: F_Y reaches the force that the floe bears. The larger ratio wins against bending: small floes split first.
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

}  // namespace nilas::fracture
