#pragma once
/// Dimensions of the units of a scene's values, and the factors of Froude's and Cauchy's laws that follow from them.
#include <functional>
#include <optional>
#include <string>

namespace nilas::scene {

/// The exponents of mass [kg], length [m] and time [s] in a unit. Angles have none.
struct Dimension {
  double mass = 0, length = 0, time = 0;

  bool operator==(const Dimension&) const = default;
};

/// The value of an exponent that a unit names; empty where nothing has that name.
using NamedExponents = std::function<std::optional<double>(const std::string& name)>;

/// The dimension of a unit: symbols kg g m mm km s min h N kN Pa kPa MPa GPa J W Hz rad deg % and 1, joined by blanks
/// (times) and '/', which divides by the one symbol after it. A symbol may have a power, "m^2", "m^-1" or
/// "m^(-2 exponent)", where `exponent` is one that `named` knows, and sqrt() encloses one symbol. An empty text has no
/// dimension. Returns nothing for a text that is no such unit.
std::optional<Dimension> parse_unit(const std::string& unit, const NamedExponents& named = {});

/// The factor of a value when lengths grow by `lambda` > 0 by Froude's and Cauchy's laws with densities and
/// accelerations kept (ITTC): mass by lambda^3, length by lambda, time by lambda^0.5. So velocities grow by lambda^0.5,
/// forces by lambda^3, stresses and moduli by lambda, and fracture toughness by lambda^1.5. Exact where the root of
/// lambda is a power of two and the exponent of that root is whole.
double scale_factor(const Dimension& dimension, double lambda);

}  // namespace nilas::scene
