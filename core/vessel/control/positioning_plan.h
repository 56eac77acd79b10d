#pragma once
/// Where dynamic positioning shall be: a set-point or a path over time.
#include <string>
#include <vector>

#include "core/base/math.h"

namespace nilas::vessel {

class PositioningPlan {
 public:
  struct Target {
    Vec3 position = Vec3::Zero();  ///< x, y [m], heading [rad], continuous in time
    Vec3 rate = Vec3::Zero();      ///< [m/s, rad/s]
  };
  /// One set-point. Its heading is taken the shortest way from `heading_now` [rad].
  static PositioningPlan hold(const Vec3& setpoint, double heading_now);
  /// Rows t_s,x_m,y_m,heading_deg of a CSV file, in the ground frame, with straight lines between them; at rest before
  /// the first and after the last. Headings turn the shortest way from row to row, the first from `heading_now`.
  /// Lengths are times `scale`, and times are times its root. Throws FileError, or InputError "file:line: ..." where
  /// times do not rise.
  static PositioningPlan path(const std::string& csv_file, double heading_now, double scale = 1);
  Target at(double t) const;
  /// Its way as a line, thinned to about 100 points; one point for a set-point [m].
  std::vector<Vec2> way() const;

 private:
  std::vector<double> t_;
  std::vector<Vec3> position_;
};

}  // namespace nilas::vessel
