#pragma once
/// Solids as texts of STL files.
#include <sstream>
#include <string>
#include <vector>

#include "core/base/math.h"

namespace nilas::test {

/// The text of an STL file of convex faces, which are loops of indices into the vertices, counter-clockwise from
/// outside. Each face is cut into triangles from its first vertex.
inline std::string stl(const std::vector<Vec3>& vertices, const std::vector<std::vector<int>>& faces) {
  std::ostringstream out;
  out.precision(17);
  out << "solid hull\n";
  const auto vertex = [&](int v) { out << "vertex " << vertices[v].transpose() << "\n"; };
  for (const auto& face : faces)
    for (std::size_t k = 2; k < face.size(); ++k) {
      out << "facet normal 0 0 0\nouter loop\n";
      for (const int v : {face[0], face[k - 1], face[k]}) vertex(v);
      out << "endloop\nendfacet\n";
    }
  out << "endsolid hull\n";
  return out.str();
}

}  // namespace nilas::test
