#pragma once
/// Speeds of a carriage that stops, or takes others at once.
#include "core/vessel/model/vessel_model.h"

namespace nilas {

/// Where it is, without its speeds.
inline CarriageMotion::State stopped(CarriageMotion::State carriage) {
  carriage.v.setZero();
  carriage.yaw_rate = 0;
  return carriage;
}

/// With the mean of both speeds.
inline CarriageMotion::State between(const CarriageMotion::State& before, const CarriageMotion::State& after) {
  CarriageMotion::State carriage = before;
  carriage.v = 0.5 * (before.v + after.v);
  carriage.yaw_rate = 0.5 * (before.yaw_rate + after.yaw_rate);
  return carriage;
}

/// What turns the one's speeds into the other's, as an acceleration over one second.
inline CarriageMotion::State change_between(const CarriageMotion::State& before, const CarriageMotion::State& after) {
  CarriageMotion::State change;
  change.v = after.v - before.v;
  change.yaw_rate = after.yaw_rate - before.yaw_rate;
  return change;
}

}  // namespace nilas
