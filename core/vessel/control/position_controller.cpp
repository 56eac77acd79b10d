#include "core/vessel/control/position_controller.h"

namespace nilas::vessel {

PositionController::PositionController(const ControllerSettings& settings) : settings_(settings) {
  constexpr double k_integral_share = 0.1;  // of the bandwidth [Fossen 2011]
  const Vec3& w = settings.bandwidth;
  proportional_ = w.cwiseProduct(w).cwiseProduct(settings.mass);
  derivative_ = 2 * settings.damping_ratio * w.cwiseProduct(settings.mass) - settings.damping;
  integral_ = k_integral_share * w.cwiseProduct(proportional_);
}

Vec3 PositionController::load(const PassiveObserver& estimate, const ReferenceFilter& reference,
                              const Vec3& known) const {
  const Mat3 to_vessel = plane_rotation(estimate.position().z()).transpose();
  const Vec3 offset = to_vessel * (estimate.position() - reference.position());
  const Vec3 velocity = to_vessel * reference.velocity(), acceleration = to_vessel * reference.acceleration();
  return settings_.mass.cwiseProduct(acceleration) + settings_.damping.cwiseProduct(velocity) -
         proportional_.cwiseProduct(offset) - derivative_.cwiseProduct(estimate.velocity() - velocity) -
         to_vessel * sum_ - known;
}

void PositionController::integrate(const PassiveObserver& estimate, const ReferenceFilter& reference,
                                   const Vec3& shortfall, double h) {
  const Mat3 R = plane_rotation(estimate.position().z());
  const Vec3 offset = R.transpose() * (estimate.position() - reference.position());
  sum_ += h * (R * (integral_.cwiseProduct(offset) + settings_.bandwidth.cwiseProduct(shortfall)));
}

}  // namespace nilas::vessel
