#pragma once
#include <filesystem>
#include <fstream>
#include <vector>

#include "core/geometry/mesh.h"

namespace nilas_test {

/// Writes a text OBJ with the shells one after the other, in units of `unit` metres.
inline void write_obj(const std::filesystem::path& file, const std::vector<nilas::geometry::TriangleMesh>& shells,
                      double unit = 1) {
  std::ofstream out(file);
  out.precision(9);
  int first = 1;
  for (const auto& shell : shells) {
    for (const auto& p : shell.vertices)
      out << "v " << p.x() / unit << ' ' << p.y() / unit << ' ' << p.z() / unit << "\n";
    for (const auto& t : shell.triangles)
      out << "f " << first + t[0] << ' ' << first + t[1] << ' ' << first + t[2] << "\n";
    first += static_cast<int>(shell.vertices.size());
  }
}

}  // namespace nilas_test
