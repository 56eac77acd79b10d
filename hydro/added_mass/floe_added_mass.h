#pragma once
/// Added mass of thin floating floes in closed form.
#include "core/choices/water_choices.h"
#include "core/geometry/shape.h"

namespace nilas::hydro {

/// Added mass of a floating floe, 6 x 6 about its centre of mass in its own axes, velocity before rotation
/// [kg, kg m^2]. Half of the water that moves with the double body in unbounded fluid: the limit of high frequency.
/// With a the radius of the disc of equal area, and L, s the sides of the rectangle of equal area and second moments:
///   heave  disc 4/3 rho a^3, plate C(L/s) pi/8 rho s^2 L                      [Lamb 1932, 102, 108; DNV-RP-C205, table
///   D-2] tilt   disc 8/45 rho a^5; plate about the long side pi/16 rho (s/2)^4 L, about the short side that of heave
///   times
///          L^2/12                                                            [Lamb; Newman 1977, table 4.3; strips]
///   surge, sway  C_A pi/2 rho d^2 W for a face of width W and draught d       [DNV-RP-C205, table D-1]
///   yaw    plate: the shares of surge and sway along the faces; disc: none
/// The terms that couple surge with pitch are left out: their lever is at most half of the thickness.
/// `draught`: of the floe at rest [m]; `density`: of the water [kg/m^3]; kind none gives zero.
Mat6 floe_added_mass(FloeAddedMass kind, const geometry::Shape& floe, double draught, double density);

/// C(L/s) of DNV-RP-C205, table D-2: added mass of a thin rectangular plate against strip theory. `aspect`: L/s >= 1.
double plate_coefficient(double aspect);
/// C_A of DNV-RP-C205, table D-1, for a rectangular section that moves along its side b: added mass over rho pi a^2.
/// `ratio`: a/b, where a is half of the side across the motion. Below 0.1, that of 0.1.
double rectangle_coefficient(double ratio);

}  // namespace nilas::hydro
