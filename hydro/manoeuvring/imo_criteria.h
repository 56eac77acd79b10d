#pragma once
/// The manoeuvring standards of the IMO, Resolution MSC.137(76) of 2002, section 5.3. They hold for ships of 100 m and
/// more in deep, calm water, at a test speed of at least 90 % of the speed at 85 % of the engine's output.
#include <optional>

namespace nilas::hydro {

/// Largest advance and tactical diameter at the largest rudder angle, and the largest way until the heading has changed
/// by 10 degrees with a rudder of 10 degrees; over L.
inline constexpr double k_imo_advance = 4.5, k_imo_tactical_diameter = 5, k_imo_initial_turning = 2.5;

/// The largest overshoot of a zigzag [deg]: the first and second of 10/10, by L/V, and the first of 20/20. Nothing for
/// others. `rudder_deg`, `heading_deg`: of the zigzag; `index`: 1, 2, ...; `length_over_speed`: [s].
std::optional<double> imo_overshoot(double rudder_deg, double heading_deg, int index, double length_over_speed);

}  // namespace nilas::hydro
