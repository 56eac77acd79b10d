#pragma once
/// The cutting of a floe's outline along cracks.
#include <string>
#include <vector>

#include "core/base/math.h"

namespace nilas::fracture {

enum class CutStatus {
  cut,          ///< There are two pieces or more.
  uncut,        ///< The cracks separate nothing: one piece, the unchanged outline.
  bad_outline,  ///< Refused: the outline is not simple, not counter-clockwise or not finite.
  bad_crack,    ///< Refused: a crack has a coordinate that is not finite.
  hole,         ///< Refused: a piece would surround another.
  pinched,      ///< Refused: a piece would touch itself at a vertex.
  rounding      ///< Refused: no rounding to doubles was found that keeps all pieces simple.
};
std::string name_of(CutStatus status);

struct CutPiece {
  std::vector<Vec2> outline;  ///< Simple and counter-clockwise, convex or not [m].
  std::vector<bool> crack;    ///< Edge i (vertices i, i + 1) is new.
};

struct CutResult {
  CutStatus status = CutStatus::uncut;
  std::string message;           ///< The reason of a refusal.
  std::vector<CutPiece> pieces;  ///< The pieces; none when refused.
  double crack_length = 0;       ///< Length of all new edges; one shared by two pieces counts once [m].
  int slivers = 0;               ///< Number of pieces thinner than snap_resolution that joined a neighbour.
};

/// Cuts a simple counter-clockwise outline along polylines, which may begin and end outside, on or inside it. Parts of
/// them that separate nothing are dropped. The interiors of the pieces are exactly disjoint. Together the pieces fill
/// the outline up to the rounding of the points where cracks meet its edges. They share every common vertex bit for
/// bit, the outline's own vertices are kept, and every condition on the rounded pieces is decided exactly. Pieces are
/// in the order of their first edge along the outline, and begin with that edge. Pieces without one are last, in the
/// order of their point of least x, then y, and begin there. A refusal is in the status: no geometry throws.
CutResult cut_outline(const std::vector<Vec2>& outline, const std::vector<std::vector<Vec2>>& cracks);

}  // namespace nilas::fracture
