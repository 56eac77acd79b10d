#pragma once
/// A hull as lines for drawings.
#include <array>
#include <vector>

#include "core/geometry/mesh.h"

namespace nilas::report {

using Segment = std::array<Vec3, 2>;

/// The lines of a closed mesh that is seen from far away in the direction -`from`: its silhouette and the sharp edges
/// on the near side.
std::vector<Segment> visible_lines(const geometry::TriangleMesh& mesh, const Vec3& from);

/// The lines in which the mesh meets the plane z = level.
std::vector<Segment> waterline(const geometry::TriangleMesh& mesh, double level);

}  // namespace nilas::report
