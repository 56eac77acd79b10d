#pragma once
/// Moves a database to another origin of its modes.
#include "hydro/database/database.h"

namespace nilas::hydro {

/// A database whose modes still refer to the point that its file names.
struct UnmovedDatabase {
  Database database;
  std::optional<Vec3> reference;  ///< [m], frame D
};

/// A database whose modes refer to the point `reference` of frame D becomes one whose modes refer to the origin of D.
/// With T = [1, -skew(reference); 0, 1], which takes motions about the origin to those about the point:
///   M = T' M T for A, B, C and mass, X = T' X for loads, x = T^-1 x for motions.
/// Phases of waves refer to the origin of D before and after.
Database about_origin(Database database, const Vec3& reference);

}  // namespace nilas::hydro
