#include "fracture/bend/resistance.h"

#include <cmath>

#include "core/base/error.h"
#include "core/base/math.h"

namespace nilas::fracture {

namespace {

void check(const LevelIce& ice) {
  NILAS_DEMAND(ice.thickness > 0 && ice.flexural_strength > 0 && ice.youngs_modulus > 0);
  NILAS_DEMAND(ice.density > 0 && ice.water_density > ice.density && ice.gravity > 0);
  NILAS_DEMAND(ice.friction >= 0 && ice.poisson >= 0 && ice.poisson <= 0.5);
}

void check(const IcebreakingHull& hull) {
  NILAS_DEMAND(hull.length > 0 && hull.beam > 0 && hull.draught > 0);
  NILAS_DEMAND(hull.stem_angle > 0 && hull.stem_angle < k_pi / 2);
  NILAS_DEMAND(hull.waterline_angle > 0 && hull.waterline_angle < k_pi / 2);
}

/// The angle psi of the bow's surface from the horizontal, in the plane normal to the waterline [rad].
double flare(const IcebreakingHull& hull) {
  return std::atan(std::tan(hull.stem_angle) / std::sin(hull.waterline_angle));
}

double crushing(const IcebreakingHull& hull, const LevelIce& ice) {
  const double phi = hull.stem_angle, psi = flare(hull), mu = ice.friction;
  NILAS_DEMAND(mu * std::sin(phi) < std::cos(psi));
  return 0.5 * ice.flexural_strength * ice.thickness * ice.thickness *
         (std::tan(phi) + mu * std::cos(phi) / std::cos(psi)) / (1 - mu * std::sin(phi) / std::cos(psi));
}

double bending(const IcebreakingHull& hull, const LevelIce& ice) {
  const double phi = hull.stem_angle, psi = flare(hull), mu = ice.friction;
  const double stiffness =
      ice.youngs_modulus / (12 * (1 - ice.poisson * ice.poisson) * ice.water_density * ice.gravity);
  return 27.0 / 64 * ice.flexural_strength * hull.beam * std::pow(ice.thickness, 1.5) / std::sqrt(stiffness) *
         (std::tan(psi) + mu * std::cos(phi) / (std::sin(hull.waterline_angle) * std::cos(psi))) *
         (1 + 1 / std::cos(psi));
}

double submersion(const IcebreakingHull& hull, const LevelIce& ice) {
  const double phi = hull.stem_angle, alpha = hull.waterline_angle, B = hull.beam, T = hull.draught;
  const double bow = T * std::cos(phi) * std::cos(flare(hull)) *
                     std::sqrt(1 / std::pow(std::sin(phi), 2) + 1 / std::pow(std::tan(alpha), 2));
  const double rubbed = 0.7 * hull.length - T / std::tan(phi) - B / (4 * std::tan(alpha)) + bow;
  return (ice.water_density - ice.density) * ice.gravity * ice.thickness * B *
         (T * (B + T) / (B + 2 * T) + ice.friction * rubbed);
}

}  // namespace

LindqvistResistance lindqvist_resistance(const IcebreakingHull& hull, const LevelIce& ice, double speed) {
  check(hull);
  check(ice);
  NILAS_DEMAND(speed >= 0);
  LindqvistResistance r{crushing(hull, ice), bending(hull, ice), submersion(hull, ice), 0};
  r.total = (r.crushing + r.bending) * (1 + 1.4 * speed / std::sqrt(ice.gravity * ice.thickness)) +
            r.submersion * (1 + 9.4 * speed / std::sqrt(ice.gravity * hull.length));
  return r;
}

double zuev_resistance(double beam, const LevelIce& ice, double concentration, double speed) {
  check(ice);
  NILAS_DEMAND(beam > 0 && speed >= 0 && concentration >= 0 && concentration <= 1);
  const double froude = speed / std::sqrt(ice.gravity * ice.thickness);
  return ice.density * ice.gravity * beam * ice.thickness * ice.thickness *
         (0.13 * beam / ice.thickness + 1.3 * froude + 0.5 * froude * froude) * (2 - concentration) * concentration *
         concentration;
}

}  // namespace nilas::fracture
