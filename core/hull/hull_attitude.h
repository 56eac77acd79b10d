#pragma once
/// Estimates from a hull's shape how it is oriented in the axes of its drawing.
#include "core/hull/hull_axes.h"
#include "core/hull/hull_measures.h"

namespace nilas::hull {

/// The feature of the shape that indicates the orientation.
enum class AttitudeSign {
  none,      ///< no feature indicates an orientation other than that of frame V
  symmetry,  ///< its one plane of symmetry is not that between port and starboard
  slender,   ///< lengths of its sides
  ends,      ///< one end is sharp and the other blunt
  faces,     ///< one side is level and the other tapers
};

/// The mesh axes that probably point forward and up, and the feature that indicates this.
struct HullAttitude {
  MeshAxes axes;
  AttitudeSign sign = AttitudeSign::none;
  /// Whether the mesh axes are those of frame V already.
  bool as_it_should() const { return axes == MeshAxes{}; }
};

/// Direction of the bow: 1 where the sharp end is ahead, -1 where it is astern, 0 where the ends are too similar.
int bow_direction(const HullMeasures& measures);

/// The probable attitude. Hulls that are round, square or as long as broad keep theirs. For a `fixed` structure, bow
/// and stern as well as top and bottom stay, unless its plane of symmetry shows that it lies across: foundations widen
/// downwards, and piers stand upright. One that lies across has its bow as the ends show it, and its deck as the faces
/// show it if it has a bow. The mesh must be closed and outward.
HullAttitude probable_attitude(const geometry::TriangleMesh& mesh, bool fixed);

}  // namespace nilas::hull
