#pragma once
/// Changes of a carriage's speeds at one instant.
#include "core/vessel/model/vessel_model.h"

namespace nilas::vessel {

/// The carriage at the same place with zero speeds.
inline CarriageMotion::State stopped(CarriageMotion::State carriage) {
  carriage.v.setZero();
  carriage.yaw_rate = 0;
  return carriage;
}

/// The carriage at the place of `before`, with the mean of both speeds.
inline CarriageMotion::State between(const CarriageMotion::State& before, const CarriageMotion::State& after) {
  CarriageMotion::State carriage = before;
  carriage.v = 0.5 * (before.v + after.v);
  carriage.yaw_rate = 0.5 * (before.yaw_rate + after.yaw_rate);
  return carriage;
}

/// The change from the speeds of `before` to those of `after`, as an acceleration over one second.
inline CarriageMotion::State change_between(const CarriageMotion::State& before, const CarriageMotion::State& after) {
  CarriageMotion::State change;
  change.v = after.v - before.v;
  change.yaw_rate = after.yaw_rate - before.yaw_rate;
  return change;
}

}  // namespace nilas::vessel
