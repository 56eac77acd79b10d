#pragma once
/// What pictures show of a module beside the bodies.
#include <string>
#include <vector>

#include "core/base/math.h"

namespace nilas::bodies {

/// A line, or an arrow for the force of something. The numbers of the kinds are those of docs/reference/replay-file.md.
struct DrawnLine {
  enum class Kind { mooring = 0, rod = 1, thruster = 2, carriage = 3, wind = 4, path = 5 };
  Kind kind = Kind::mooring;
  std::string name;
  double force = 0;          ///< tension or force [N]
  std::vector<Vec3> points;  ///< in G; of an arrow where the force acts, and a point in its direction [m]
};

/// An arrow for a force at a point, both in G; none where there is no force.
inline void add_arrow(DrawnLine::Kind kind, const std::string& name, const Vec3& at, const Vec3& force,
                      std::vector<DrawnLine>& lines) {
  const double size = force.norm();
  if (size > 0) lines.push_back({kind, name, size, {at, at + force / size}});
}

}  // namespace nilas::bodies
