#pragma once
/// The module of a vessel's manoeuvring.
#include <memory>

#include "core/base/channels.h"
#include "core/bodies/module.h"
#include "hydro/manoeuvring/manoeuvring_ship.h"

namespace nilas::hydro {

/// Names of channels. The rudder angle [rad] is positive with the trailing edge to starboard, which turns the bow to
/// starboard. The thrust [N] is that which drives the propeller's jet: of an open-water propeller the one before thrust
/// deduction, of a thrust curve the net thrust without the ship's resistance in it.
inline constexpr const char* k_rudder_channel = "rudder";
inline constexpr const char* k_propeller_channel = "propeller";
inline constexpr const char* k_thrust_channel = "propeller.thrust_actual";

/// The vessel's rudder and propeller as machines: they follow commands at a limited rate.
struct ManoeuvringSettings {
  ManoeuvringShip ship;
  int vessel = 0;               ///< index of the hull among the bodies
  double density = 0;           ///< of the water [kg/m^3]
  Vec3 current = Vec3::Zero();  ///< velocity of the water [m/s]
  double midship = 0;           ///< x of the point amidships in body axes, from the centre of mass [m]
  double rudder_rate = 0;       ///< [rad/s]
  double max_rudder = 0;        ///< [rad]
  double propeller_rate = 0;    ///< [1/s^2]
  double rps = 0;               ///< rate of revolutions at the start [1/s]
};

/// Loads on a free vessel in surge, sway and yaw, by its motion through the water, in axes that turn with its yaw. They
/// act at the height of the centre of mass, so heave, roll and pitch take none. With ship_loads() of the ship and the
/// added mass of planar_added_mass() in the mass of the vessel (vessel_added_mass()), the vessel obeys the equations of
/// the ship's model while it is upright: kirchhoff_terms_in_model() cancels what would count twice.
///   MMG  (m + m_x) u' - (m + m_y) v r - x_G m r^2 = X,  (m + m_y) v' + (m + m_x) u r + x_G m r' = Y,
///        (I_zG + x_G^2 m + J_z) r' + x_G m (v' + u r) = N             [Yasukawa & Yoshimura 2015, eq. 4]
/// Adds the channels k_rudder_channel [rad] and k_propeller_channel [1/s], which it follows, and k_thrust_channel [N],
/// which it sets. Its columns are the machines' states, the thrust, and the motion of midship through the water.
std::unique_ptr<bodies::ForceModule> make_manoeuvring(ManoeuvringSettings settings, std::shared_ptr<Channels> commands);

}  // namespace nilas::hydro
