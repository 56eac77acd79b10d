#include "fracture/bend/sloping_structure.h"

#include <boost/math/special_functions/ellint_1.hpp>
#include <boost/math/special_functions/ellint_2.hpp>
#include <cmath>

#include "core/base/error.h"
#include "core/base/math.h"
#include "fracture/bend/plate.h"

namespace nilas::fracture {

namespace {

double cot(double angle) { return 1 / std::tan(angle); }

void check(const SlopingStructure& structure, const LevelIce& ice) {
  NILAS_DEMAND(structure.width > 0 && structure.slope > 0 && structure.slope < k_pi / 2);
  NILAS_DEMAND(ice.thickness > 0 && ice.flexural_strength > 0 && ice.density > 0);
  NILAS_DEMAND(ice.friction >= 0 && ice.friction * std::tan(structure.slope) < 1);
  NILAS_DEMAND(ice.friction < std::tan(structure.slope));
}

void check(const Rubble& rubble, double slope) {
  NILAS_DEMAND(rubble.height >= 0 && rubble.cohesion >= 0 && rubble.ice_friction >= 0);
  NILAS_DEMAND(rubble.porosity >= 0 && rubble.porosity < 1);
  NILAS_DEMAND(rubble.angle > 0 && rubble.angle <= slope);
}

/// Quantities that several components of Croasdale's load share.
struct Croasdale {
  SlopingStructure structure;
  LevelIce ice;
  Rubble rubble;
  double a = structure.slope, mu = ice.friction, h = ice.thickness, w = structure.width;
  double h_r = rubble.height, mu_i = rubble.ice_friction;
  double xi = (std::sin(a) + mu * std::cos(a)) / (std::cos(a) - mu * std::sin(a));
  double q = 1 - std::tan(rubble.angle) / std::tan(a);
  double weight = ice.density * ice.gravity, pile = weight * (1 - rubble.porosity);

  double cracked_width() const {
    const double L_c = characteristic_length({h, ice.youngs_modulus, ice.poisson, ice.water_density, ice.gravity});
    return structure.edge_cracks ? w + k_pi * k_pi * L_c / 4 : w;
  }
  double breaking() const {
    return 0.68 * xi * ice.flexural_strength *
           std::pow(ice.water_density * ice.gravity * std::pow(h, 5) / ice.youngs_modulus, 0.25) * cracked_width();
  }
  double push_through() const { return w * h_r * h_r * mu_i * pile * q * q / (2 * std::tan(rubble.angle)); }
  double ride_up() const {
    const double under_pile =
        0.5 * mu_i * (mu_i + mu) * pile * h_r * h_r * std::sin(a) * (cot(rubble.angle) - cot(a)) * q +
        0.5 * (mu_i + mu) * pile * h_r * h_r * std::cos(a) * cot(a) * q;
    const double own_weight = h_r * h * weight * (std::sin(a) + mu * std::cos(a)) / std::sin(a);
    return w * (under_pile + own_weight) / (std::cos(a) - mu * std::sin(a));
  }
  double lifting() const {
    const double shear = 0.5 * h_r * pile * (cot(rubble.angle) - cot(a) + q * std::tan(rubble.friction_angle));
    return w * h_r * xi * q * (shear + rubble.cohesion);
  }
  double turning() const { return 1.5 * w * h * h * weight * std::cos(a) / (std::sin(a) - mu * std::cos(a)); }
};

}  // namespace

SlopeLoad croasdale_load(const SlopingStructure& structure, const LevelIce& ice, const Rubble& rubble) {
  check(structure, ice);
  check(rubble, structure.slope);
  const Croasdale c{structure, ice, rubble};
  SlopeLoad load{c.breaking(), c.push_through(), c.ride_up(), c.lifting(), c.turning(), 0};
  const double crushing_share = load.breaking / (ice.flexural_strength * c.cracked_width() * ice.thickness);
  NILAS_DEMAND(crushing_share < 1);
  load.total = (load.breaking + load.push_through + load.ride_up + load.lifting + load.turning) / (1 - crushing_share);
  return load;
}

RalstonLoad ralston_load(const SlopingStructure& cone, double top_diameter, double ride_up_thickness,
                         const LevelIce& ice) {
  check(cone, ice);
  NILAS_DEMAND(top_diameter >= 0 && top_diameter <= cone.width && ride_up_thickness >= 0);
  const double a = cone.slope, mu = ice.friction, h = ice.thickness, D = cone.width, Y = 2.711;
  const double weight = ice.density * ice.gravity, sigma = ice.flexural_strength;
  const double g_r =
      (std::sin(a) + a / std::cos(a)) / (2 * mu * a * std::cos(a) + 0.5 * k_pi * std::sin(a) * std::sin(a));
  NILAS_DEMAND(mu * g_r < 1);
  const double G = weight * D * D / (4 * sigma * h);
  const double x = 1 + 1 / std::sqrt(3 * G + 0.5 * Y);
  const double breaking =
      sigma * h * h / 3 * std::tan(a) / (1 - mu * g_r) * (G * (x - 1) * (x + 2) + (1 + Y * x * std::log(x)) / (x - 1));
  const double W = weight * ride_up_thickness * (D * D - top_diameter * top_diameter) / (4 * std::cos(a));
  const double modulus = std::sin(a);
  const double f = modulus + mu * boost::math::ellint_1(modulus) * std::cos(a);
  const double ride_up =
      W * (std::tan(a) + mu * (boost::math::ellint_2(modulus) - f * g_r * std::cos(a))) / (1 - mu * g_r);
  return {breaking, ride_up};
}

}  // namespace nilas::fracture
