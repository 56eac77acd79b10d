#pragma once
/// A packed field that moves on given paths. It is cheap to make in any size.
#include <memory>
#include <vector>

#include "core/base/random.h"
#include "core/bodies/bodies.h"
#include "core/geometry/mass_properties.h"
#include "core/geometry/shape.h"

namespace nilas::bench {

/// Cells of a jittered grid as floes of four to eight corners at about 96 % concentration. All drift. Each swings and
/// turns about its place so far that about every other pair of neighbours overlaps by up to some millimetres at any
/// time.
class MovingField {
 public:
  explicit MovingField(int floes);
  const bodies::Bodies& bodies() const { return bodies_; }
  double concentration() const { return concentration_; }
  /// Sets poses and velocities at time t [s].
  void move_to(double t);

 private:
  struct Path {
    Vec3 place = Vec3::Zero(), swing = Vec3::Zero(), turn = Vec3::Zero();
    double rate = 0, phase = 0;  ///< Angular frequency and phase of a floe [rad/s], [rad].
  };
  std::vector<Vec2> cell(int i, int j, RandomStream& random) const;
  void add_floe(std::vector<Vec2> outline, RandomStream& random);

  bodies::Bodies bodies_;
  std::vector<Path> paths_;
  std::vector<Vec2> corners_;  ///< Corners of the grid, row by row.
  int columns_ = 0;
  double concentration_ = 0;
};

}  // namespace nilas::bench
