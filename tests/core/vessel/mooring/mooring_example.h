#pragma once
/// A hull on a spread of mooring lines, for tests.
#include <string>

#include "core/vessel/mooring/mooring_model.h"

namespace nilas::example {

/// `count` chains around a hull in 100 m of water, evenly but for a small skew, so that nothing cancels by symmetry.
/// Even lines pull at the hull, odd ones at a turret if there is one.
inline vessel::MooringModel mooring(int count, bool with_turret) {
  vessel::MooringModel model;
  model.bed = -100;
  if (with_turret) model.turret = vessel::Turret{{30, 0, -8}, 0};
  for (int k = 0; k < count; ++k) {
    const Vec2 away = direction_of(2 * k_pi * k / count + 0.1 * k);
    vessel::MooringLine line;
    line.name = "m" + std::to_string(k + 1);
    line.on_turret = with_turret && k % 2 == 1;
    const Vec3 centre = line.on_turret ? model.turret->at_B : Vec3(0, 0, -5);
    const double radius = line.on_turret ? 5 : 40;
    line.fairlead_B = centre + Vec3(radius * away.x(), 0.3 * radius * away.y(), 0);
    line.anchor = {(620 + 3 * k) * away.x(), 610 * away.y(), -100};
    line.form = vessel::CatenaryLine{600, 1500, 8e8, 0.3};
    model.lines.push_back(line);
  }
  return model;
}

inline vessel::MooringState unbroken(const vessel::MooringModel& model) {
  return {std::vector<char>(model.lines.size(), 0), 0};
}

inline Pose pose_of_hull() { return {Quat(Eigen::AngleAxisd(0.2, Vec3(0.1, 0.3, 2).normalized())), {4, -3, 1}}; }

}  // namespace nilas::example
