#pragma once
/// Ships whose coefficients are published.
#include "hydro/manoeuvring/manoeuvring_ship.h"

namespace nilas::hydro {

/// The tanker KVLCC2 with the coefficients of Yasukawa & Yoshimura 2015, tables 2 to 5, at another length than 320 m
/// scaled by Froude's law: lengths by the ratio, the largest rate of revolutions by its inverse root. The wake fraction
/// is that of the full-scale ship, 0.35; on models of 7 m it is 0.40. The largest rate is 120 rpm at full scale, our
/// own choice: the paper gives none. `length` [m].
ManoeuvringShip kvlcc2(double length);
extern const double k_kvlcc2_length;  ///< [m]

/// A supply vessel at low speed in the bis system [Fossen, Sagatun & Sorensen 1996, with the added mass in M less the
/// mass and an inertia of m (L/4)^2], with `length` [m], mass and time scaled by Froude's law from 76.2 m and 6000 t.
/// Its propulsion is a thrust curve of two propellers of 799 kN whose open-water speed is 7 m/s, our own choice: the
/// source gives their thrust at rest only. It has no rudder.
ManoeuvringShip supply_vessel(double length, double gravity);
extern const double k_supply_length;  ///< [m]

}  // namespace nilas::hydro
