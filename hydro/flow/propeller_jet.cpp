#include "hydro/flow/propeller_jet.h"

#include <cmath>

#include "core/base/error.h"

namespace nilas::hydro {

PropellerJet::PropellerJet(double diameter, double density, double spread)
    : disc_area_(k_pi * diameter * diameter / 4), density_(density), spread_(spread), radius_(diameter / std::sqrt(8)) {
  NILAS_DEMAND(diameter > 0 && density > 0 && spread > 0);
}

void PropellerJet::set(const Vec3& position, const Vec3& direction, double thrust) {
  position_ = position;
  direction_ = thrust < 0 ? Vec3(-direction) : direction;
  efflux_ = std::sqrt(2 * std::abs(thrust) / (density_ * disc_area_));
}

double PropellerJet::speed(double x, double r) const {
  if (!(x >= 0) || efflux_ == 0) return 0;
  const double s = spread_ * x;
  if (s >= radius_) return efflux_ * radius_ / s * std::exp(-0.5 * r * r / (s * s));
  const double half = std::sqrt(k_pi) / 2 * s;
  const double core = std::sqrt(radius_ * radius_ - s * s + half * half) - half;
  if (r <= core) return efflux_;
  return s == 0 ? 0 : efflux_ * std::exp(-0.5 * (r - core) * (r - core) / (s * s));
}

Vec3 PropellerJet::velocity(const Vec3& p_G, double /*t*/) const {
  if (efflux_ == 0) return Vec3::Zero();
  const Vec3 from = p_G - position_;
  const double x = from.dot(direction_);
  if (!(x >= 0)) return Vec3::Zero();
  return speed(x, (from - x * direction_).norm()) * direction_;
}

}  // namespace nilas::hydro
