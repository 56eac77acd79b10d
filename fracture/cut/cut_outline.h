#pragma once
/// Cutting of a floe's outline along cracks.
#include <string>
#include <vector>

#include "core/base/math.h"

namespace nilas {

enum class CutStatus {
  cut,          ///< two pieces or more
  uncut,        ///< the cracks separate nothing: one piece, the outline as it was
  bad_outline,  ///< refused: not simple, not counter-clockwise or not finite
  bad_crack,    ///< refused: a crack has a coordinate that is not finite
  hole,         ///< refused: a piece would surround another
  pinched,      ///< refused: a piece would touch itself at a vertex
  rounding      ///< refused: no rounding to doubles was found that keeps all pieces simple
};
std::string name_of(CutStatus status);

struct CutPiece {
  std::vector<Vec2> outline;  ///< simple, counter-clockwise, convex or not [m]
  std::vector<bool> crack;    ///< edge i (vertices i, i + 1) is a new one
};

struct CutResult {
  CutStatus status = CutStatus::uncut;
  std::string message;           ///< why it was refused
  std::vector<CutPiece> pieces;  ///< none when refused
  double crack_length = 0;       ///< of all new edges, each counted once: two new faces belong to each [m]
  int slivers = 0;               ///< pieces thinner than snap_resolution that were left with a neighbour
};

/// Cuts a simple counter-clockwise outline along polylines that may begin and end outside, on or inside it; parts of
/// them that separate nothing are dropped. The pieces' interiors are disjoint exactly and together they fill the
/// outline up to the rounding of the points where cracks meet its edges: they share every common vertex bit for bit,
/// the outline's own vertices are kept, and every condition on the rounded pieces is decided exactly. Pieces come in
/// the order of their first edge along the outline, each beginning with that edge; those without one come last, from
/// the lowest x on, each beginning there. Refusals are told in the status; no geometry throws.
CutResult cut_outline(const std::vector<Vec2>& outline, const std::vector<std::vector<Vec2>>& cracks);

}  // namespace nilas
