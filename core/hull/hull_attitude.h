#pragma once
/// How a hull probably lies in the axes it was drawn in, told by its shape.
#include "core/hull/hull_axes.h"
#include "core/hull/hull_measures.h"

namespace nilas {

/// What of a hull's shape tells how it lies.
enum class AttitudeSign {
  none,      ///< as frame V wants it, as far as can be told
  symmetry,  ///< it has one plane of symmetry, and that is not the one between port and starboard
  slender,   ///< its sides' lengths alone
  ends,      ///< it is sharp at one end and blunt at the other
  faces,     ///< it is level on one side and tapers on the other
};

/// Its own axes that probably point forward and up, and the sign that led there.
struct HullAttitude {
  MeshAxes axes;
  AttitudeSign sign = AttitudeSign::none;
  bool as_it_should() const { return axes == MeshAxes{}; }
};

/// 1 where the sharp end is ahead, -1 where it is astern, 0 where the ends are too alike to tell.
int bow_direction(const HullMeasures& measures);

/// What is round, square, or as long as it is broad is left as it is. Of a `fixed` structure neither bow and stern nor
/// top and bottom are doubted: foundations spread downwards, and piers stand on end. The mesh must be closed and
/// outward.
HullAttitude probable_attitude(const TriangleMesh& mesh, bool fixed);

}  // namespace nilas
