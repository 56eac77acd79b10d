#pragma once
/// Ships from a user's file.
#include <string>
#include <vector>

#include "hydro/manoeuvring/manoeuvring_ship.h"

namespace nilas::hydro {

/// Reads a CSV file with the columns `name,value`; lines that begin with # are comments. The names are those of the
/// members of the structs of this folder; docs/theory/manoeuvring.md lists them with their units.
///   mmg          those of MmgHull: length_m, draught_m, m_x, m_y, J_z, R_0 and the derivatives; absent ones are 0
///   derivatives  length_m, scaling, draught_m, mass_kg, reference_speed_m_s, the accelerations and any terms
///   open-water   propeller_diameter_m, max_rps, k_0 to w_P0, C_1, C_2_plus, C_2_minus, x_P
///   thrust-curve max_speed_m_s, max_rps, and pull_N, or power_W, propeller_diameter_m and screws; pull_a_1, pull_a_2
///   rudder       rudder_area_m2 and the others of MmgRudder; no rudder without an area
/// `gravity` [m/s^2] is the unit of acceleration in the bis system. Throws FileError where the file cannot be read, and
/// InputError "file:line: ..." for an unknown, repeated or missing name, a value that is no finite number or not
/// allowed, and an added mass that is not positive.
ManoeuvringShip read_ship(const std::string& file, ManoeuvringModel model, PropulsionKind propulsion, double gravity);

}  // namespace nilas::hydro
