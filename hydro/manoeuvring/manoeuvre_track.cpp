#include <cmath>

#include "hydro/manoeuvring/manoeuvre.h"

namespace nilas::hydro {

void ManoeuvreTrack::go_on(const VesselInPlane& now, double t, double h) {
  if (!has_begun()) {
    begun_ = 1;
    t0_ = t;
    speed0_ = now.speed();
    yaw_ = now.yaw;
    origin_ = now.midship;
    axis_ = now.ahead;
    return;
  }
  time_ = t - t0_;
  // The heading changes by less than half a turn in a substep.
  turned_ -= std::remainder(now.yaw - yaw_, 2 * k_pi);
  yaw_ = now.yaw;
  const Vec2 moved = now.midship - origin_ - time_ * frame_.current;
  ahead_ = moved.dot(axis_);
  aside_ = -cross2(axis_, moved);
  way_ += h * now.speed();
}

void ManoeuvreTrack::save(StateWriter out) const {
  out.add("track", std::array{begun_, t0_, speed0_, yaw_, time_, turned_, ahead_, aside_, way_});
  out.add("origin", origin_);
  out.add("axis", axis_);
}

void ManoeuvreTrack::restore(const StateReader& in) {
  std::array<double, 9> all{};
  in.get("track", all);
  begun_ = all[0];
  t0_ = all[1];
  speed0_ = all[2];
  yaw_ = all[3];
  time_ = all[4];
  turned_ = all[5];
  ahead_ = all[6];
  aside_ = all[7];
  way_ = all[8];
  in.get("origin", origin_);
  in.get("axis", axis_);
}

}  // namespace nilas::hydro
