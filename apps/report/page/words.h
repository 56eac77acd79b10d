#pragma once
/// Numbers of a report as text.
#include <optional>
#include <string>

#include "core/base/math.h"
#include "core/output/loads/ice_load_text.h"

namespace nilas::report {

/// A force with two significant digits, as an error has, in the unit that suits the larger of it and `beside`.
std::string error_force(double newton, double beside);
/// A mean with its error: "41.3 kN ± 2.9 kN"; "at least" before the error where it is a lower bound.
std::string mean_with_error(double mean, const std::optional<double>& error, bool at_least);
/// The same with the side of the mean instead of its sign: "41.3 kN ± 2.9 kN forward".
std::string sided_mean(double mean, const std::optional<double>& error, const output::LoadSides& sides);
/// The words for the signs of the load along the course of a vessel, or along the drift on a fixed body.
output::LoadSides sides_along(bool is_vessel);
/// A time with as many digits as steps of this length need: "34.2 s".
std::string time_text(double t, double step);
/// A number with up to four significant digits.
std::string number_text(double value);

/// A place as "x = 12.34 m, y = 0 m, z = -1.5 m", or its horizontal part. Coordinates have the digits that four
/// significant ones of the largest leave, and a micrometre at most: smaller ones are rounding and become 0.
std::string place_text(const Vec3& place);
std::string horizontal_place_text(const Vec3& place);

}  // namespace nilas::report
