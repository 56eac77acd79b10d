#pragma once
/// Cutting of a floe into pieces that carry its mass and motion on.
#include <limits>
#include <string>
#include <vector>

#include "core/base/math.h"
#include "core/choices/fracture_choices.h"
#include "fracture/crush/ice_columns.h"
#include "fracture/cut/cut_outline.h"

namespace nilas {

/// A floe of uniform thickness and density.
struct FloeState {
  std::vector<Vec2> outline;      ///< in B, counter-clockwise about its centroid [m]
  double thickness = 0;           ///< [m]
  double mass = 0;                ///< [kg]
  Mat3 inertia_B = Mat3::Zero();  ///< about the centre of mass [kg m^2]
  Pose pose;                      ///< of the centre of mass in G
  Vec3 v_GB = Vec3::Zero();       ///< of the centre of mass [m/s]
  Vec3 w_GB = Vec3::Zero();       ///< in G [rad/s]
};

/// What breaking must not change, in G.
struct MotionAccount {
  double mass = 0;                       ///< [kg]
  Vec3 momentum = Vec3::Zero();          ///< [N s]
  Vec3 angular_momentum = Vec3::Zero();  ///< about the point asked for [N m s]
  double kinetic_energy = 0;             ///< [J]
  MotionAccount& operator+=(const MotionAccount& o);
};
MotionAccount motion_account(const FloeState& floe, const Vec3& about_G);

struct PieceLimits {
  double min_area = 0;                                          ///< [m^2]
  double max_aspect = std::numeric_limits<double>::infinity();  ///< of the smallest box around a piece
  SmallPieces small = SmallPieces::refuse;                      ///< what becomes of pieces beyond these limits
};

enum class FloeCutStatus {
  cut,        ///< pieces and brash take the floe's place
  uncut,      ///< the cracks separate nothing
  geometry,   ///< refused: see outline_status
  too_small,  ///< refused: a piece is below min_area
  too_narrow  ///< refused: a piece is longer than max_aspect
};

struct FloePiece {
  FloeState state;
  std::vector<bool> crack;  ///< edge i of its outline is a new one
  double area = 0;          ///< [m^2]
};

struct FloeCut {
  FloeCutStatus status = FloeCutStatus::uncut;
  CutStatus outline_status = CutStatus::uncut;
  std::string message;              ///< why it was refused
  std::vector<FloePiece> pieces;    ///< empty unless cut
  std::vector<FloePiece> brash;     ///< pieces that the limits turn into brash
  MotionAccount brash_account;      ///< of `brash`, angular momentum about the floe's centre of mass
  std::vector<FloePiece> extruded;  ///< of crushed ice, whatever its size
  MotionAccount extruded_account;   ///< of `extruded`, likewise
  double crack_length = 0;          ///< [m]
};

/// Cuts along `cracks`, polylines in B. Masses are shares of the floe's by area, the largest piece taking what rounding
/// leaves, and the pieces lie about the floe's centre of mass, which their common centroid misses by a rounding; each
/// moves as the floe did, v + w x r and w. Mass, momentum, angular momentum and energy are thus kept to rounding.
/// Pieces that `crushed` squeezes out leave; where that is all of the floe no crack needs to cut it.
/// Throws ContractError when thickness or mass is not positive, or when the inertia or centroid are not those of a
/// uniform plate (1e-9 of its own).
FloeCut cut_floe(const FloeState& floe, const std::vector<std::vector<Vec2>>& cracks, const PieceLimits& limits,
                 const CrushedIce& crushed = {});

}  // namespace nilas
