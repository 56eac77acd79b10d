#pragma once
/// The cutting of a floe into pieces that keep its mass and motion.
#include <limits>
#include <string>
#include <vector>

#include "core/base/math.h"
#include "core/choices/fracture_choices.h"
#include "fracture/crush/ice_columns.h"
#include "fracture/cut/cut_outline.h"

namespace nilas::fracture {

/// A floe of uniform thickness and density.
struct FloeState {
  std::vector<Vec2> outline;      ///< Outline in B, counter-clockwise, about its centroid [m].
  double thickness = 0;           ///< [m]
  double mass = 0;                ///< [kg]
  Mat3 inertia_B = Mat3::Zero();  ///< Inertia about the centre of mass [kg m^2].
  Pose pose;                      ///< Pose of the centre of mass in G.
  Vec3 v_GB = Vec3::Zero();       ///< Velocity of the centre of mass in G [m/s].
  Vec3 w_GB = Vec3::Zero();       ///< Angular velocity in G [rad/s].
};

/// The sums over bodies that breaking must not change, in G.
struct MotionAccount {
  double mass = 0;                       ///< [kg]
  Vec3 momentum = Vec3::Zero();          ///< [N s]
  Vec3 angular_momentum = Vec3::Zero();  ///< Angular momentum about the chosen point [N m s].
  double kinetic_energy = 0;             ///< [J]
  MotionAccount& operator+=(const MotionAccount& o);
};
MotionAccount motion_account(const FloeState& floe, const Vec3& about_G);

struct PieceLimits {
  double min_area = 0;  ///< [m^2]
  double max_aspect =
      std::numeric_limits<double>::infinity();  ///< Largest aspect of the smallest box around a piece [-].
  SmallPieces small = SmallPieces::refuse;      ///< Treatment of pieces beyond these limits.
};

enum class FloeCutStatus {
  cut,        ///< Pieces and brash take the floe's place.
  uncut,      ///< The cracks separate nothing.
  geometry,   ///< Refused: see outline_status, or a piece is not simple about its own centroid.
  too_small,  ///< Refused: a piece is below min_area.
  too_narrow  ///< Refused: the aspect of a piece is above max_aspect.
};

struct FloePiece {
  FloeState state;
  std::vector<bool> crack;  ///< Edge i of its outline is new.
  double area = 0;          ///< [m^2]
};

struct FloeCut {
  FloeCutStatus status = FloeCutStatus::uncut;
  CutStatus outline_status = CutStatus::uncut;
  std::string message;              ///< The reason of a refusal.
  std::vector<FloePiece> pieces;    ///< The pieces; empty unless cut.
  std::vector<FloePiece> brash;     ///< Pieces that the limits turn into brash.
  MotionAccount brash_account;      ///< Account of `brash`, about the floe's centre of mass.
  std::vector<FloePiece> extruded;  ///< Pieces of crushed ice of any size.
  MotionAccount extruded_account;   ///< The same of `extruded` and of corners that were trimmed off pieces.
  double crack_length = 0;          ///< [m]
};

/// Cuts a floe along `cracks`, polylines in B [m]. Each piece gets its share of the mass by area; the largest takes
/// what rounding leaves. The pieces are shifted together so that their common centre is the floe's, from which it
/// differs by a rounding. Each moves as the floe did, with v + w x r and w. Mass, momentum, angular momentum and energy
/// are therefore kept to rounding. Pieces that `crushed` squeezes out leave the floe. Where the whole floe leaves no
/// crack needs to cut it. Throws ContractError unless thickness and mass are positive, and inertia and centroid are
/// those of a uniform plate (within 1e-9).
FloeCut cut_floe(const FloeState& floe, const std::vector<std::vector<Vec2>>& cracks, const PieceLimits& limits,
                 const CrushedIce& crushed = {});

}  // namespace nilas::fracture
