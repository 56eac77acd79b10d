#pragma once
/// A ship in the horizontal plane: hull, propulsion and rudder.
#include <optional>
#include <string>
#include <variant>

#include "core/base/math.h"
#include "hydro/manoeuvring/derivatives_hull.h"
#include "hydro/manoeuvring/mmg_hull.h"
#include "hydro/manoeuvring/mmg_rudder.h"
#include "hydro/manoeuvring/propulsion.h"

namespace nilas::hydro {

struct ManoeuvringShip {
  std::variant<MmgHull, DerivativesHull> hull;
  std::variant<OpenWaterPropeller, ThrustCurve> propulsion;
  std::optional<MmgRudder> rudder;  ///< none: the rudder acts by derivatives, or not at all
  double max_rps = 0;               ///< largest rate of revolutions of the propeller [1/s]

  double length() const;  ///< L [m]
  bool steers() const;    ///< whether its rudder exerts any load: one of its own, or derivatives of the rudder angle
};

/// Loads by their source, about the point amidships.
struct ShipLoads {
  PlanarLoads hull, propeller, rudder;
  double thrust = 0;  ///< of the propeller, before thrust deduction; of a thrust curve, the net thrust [N]
  double jet = 0;     ///< the thrust that drives the propeller's jet; of a thrust curve, without the resistance [N]

  PlanarLoads sum() const;
};

/// The loads at this motion through the water. `angle`: of the rudder [rad], positive with the trailing edge to
/// starboard. `rps`: [1/s]. With a thrust curve the hull's load at (u, 0, 0) is left out, since the curve holds the
/// resistance, and the rudder feels the jet of the net thrust less its value at rps = 0.
ShipLoads ship_loads(const ManoeuvringShip& ship, double density, const PlanarMotion& motion, double angle, double rps);

PlanarAddedMass planar_added_mass(const ManoeuvringShip& ship, double density);

/// The 6 x 6 added mass about another point in axes with x forward, y to port and z up, velocity before rotation; only
/// surge, sway and yaw have any. `arm` leads from that point to the point amidships, along x [m].
Mat6 added_mass(const PlanarAddedMass& planar, double arm);

/// The ship at another scale by Froude's law, with density and gravity kept: lengths grow by `ratio`, velocities by its
/// root, and all else follows.
ManoeuvringShip scaled(ManoeuvringShip ship, double ratio);

/// What has to be added to a rigid body that carries `added` by Kirchhoff's equations, so that the equations of the
/// model result. With A the added mass, Kirchhoff's terms that are quadratic in the velocities are
///   X = (A22 v + A26 r) r,  Y = -A11 u r,  N = -(A22 - A11) u v - A26 u r.
/// The MMG equations [Yasukawa & Yoshimura 2015, eq. 4] keep X and Y of these as (m + m_y) v r and (m + m_x) u r. They
/// hold N, the Munk moment, in the measured N_H, so (A22 - A11) u v is added. Given derivatives hold all three, so all
/// are added with the other sign.
PlanarLoads kirchhoff_terms_in_model(const ManoeuvringShip& ship, const PlanarAddedMass& added,
                                     const PlanarMotion& motion);

/// The rate of revolutions at which a straight course at this speed through the water is steady: propulsion and hull
/// balance, to the last bit that the rate resolves. Zero at speed 0. Throws InputError where no rate up to the largest
/// is enough, naming both speeds.
double self_propulsion(const ManoeuvringShip& ship, double density, double speed);

}  // namespace nilas::hydro
