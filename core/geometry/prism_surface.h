#pragma once
/// Closed triangle surface of an extruded outline.
#include <vector>

#include "core/geometry/mesh.h"

namespace nilas::geometry {

/// Prism over a simple counter-clockwise outline, z from -half to half [m]. `pieces`: its convex pieces as vertex
/// indices. Vertices: bottom loop, then top loop. No triangle has zero area, wherever vertices lie on straight edges.
TriangleMesh prism_surface(const std::vector<Vec2>& outline, const std::vector<std::vector<int>>& pieces, double half);

}  // namespace nilas::geometry
