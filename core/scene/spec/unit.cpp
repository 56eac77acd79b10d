#include "core/scene/spec/unit.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <string_view>

#include "core/scene/spec/values.h"

namespace nilas::scene {

namespace {

struct UnitSymbol {
  std::string_view name;
  Dimension dimension;
};

/// The units that the attributes of scenes and columns of files have. Those without a dimension have no exponent.
constexpr Dimension k_newton{1, 1, -2}, k_pascal{1, -1, -2};
constexpr UnitSymbol k_symbols[] = {
    {"kg", {1, 0, 0}}, {"m", {0, 1, 0}},   {"s", {0, 0, 1}},  {"N", k_newton},    {"Pa", k_pascal}, {"J", {1, 2, -2}},
    {"W", {1, 2, -3}}, {"Hz", {0, 0, -1}}, {"rad", {}},       {"deg", {}},        {"1", {}},        {"%", {}},
    {"g", {1, 0, 0}},  {"mm", {0, 1, 0}},  {"km", {0, 1, 0}}, {"min", {0, 0, 1}}, {"h", {0, 0, 1}}, {"kN", k_newton},
    {"kPa", k_pascal}, {"MPa", k_pascal},  {"GPa", k_pascal}};

/// Reads one unit from left to right.
class UnitText {
 public:
  UnitText(std::string_view text, const NamedExponents& named) : rest_(text), named_(named) {}

  std::optional<Dimension> read() {
    Dimension sum;
    double sign = 1;
    while (true) {
      const auto one = factor();
      if (!one) return std::nullopt;
      sum.mass += sign * one->mass;
      sum.length += sign * one->length;
      sum.time += sign * one->time;
      if (rest_.empty()) return sum;
      if (!take(" ") && !starts_with('/')) return std::nullopt;
      sign = take("/") ? -1 : 1;
    }
  }

 private:
  bool starts_with(char c) const { return !rest_.empty() && rest_.front() == c; }
  bool take(std::string_view word) {
    if (rest_.substr(0, word.size()) != word) return false;
    rest_.remove_prefix(word.size());
    return true;
  }

  /// The text up to a character of `ends`, or to the end.
  std::string_view up_to(const char* ends) {
    const std::string_view word = rest_.substr(0, rest_.find_first_of(ends));
    rest_.remove_prefix(word.size());
    return word;
  }

  /// A symbol with its power, or a root.
  std::optional<Dimension> factor() {
    if (take("sqrt(")) {
      const auto inner = symbol(up_to(")"));
      if (!inner || !take(")")) return std::nullopt;
      return times(*inner, 0.5);
    }
    const auto base = symbol(up_to(" /^"));
    if (!base || !take("^")) return base;
    const auto exponent = power();
    return exponent ? std::optional(times(*base, *exponent)) : std::nullopt;
  }

  static std::optional<Dimension> symbol(std::string_view name) {
    const auto found = std::find_if(std::begin(k_symbols), std::end(k_symbols),
                                    [&](const UnitSymbol& known) { return known.name == name; });
    return found == std::end(k_symbols) ? std::nullopt : std::optional(found->dimension);
  }

  static Dimension times(const Dimension& d, double power) {
    return {d.mass * power, d.length * power, d.time * power};
  }

  /// A number, or in parentheses a product of numbers and names.
  std::optional<double> power() {
    if (!take("(")) return parse_number(up_to(" /"));
    const auto words = split_words(up_to(")"));
    if (words.empty() || !take(")")) return std::nullopt;
    double product = 1;
    for (const std::string& word : words) {
      const auto value = parse_number(word) ? parse_number(word) : named_ ? named_(word) : std::nullopt;
      if (!value) return std::nullopt;
      product *= *value;
    }
    return product;
  }

  std::string_view rest_;
  const NamedExponents& named_;
};

}  // namespace

std::optional<Dimension> parse_unit(const std::string& unit, const NamedExponents& named) {
  if (unit.empty()) return Dimension{};
  return UnitText(unit, named).read();
}

double scale_factor(const Dimension& dimension, double lambda) {
  // In powers of the root of lambda, so that whole powers need no rounding.
  constexpr double k_mass = 6, k_length = 2, k_time = 1;
  const double power = k_mass * dimension.mass + k_length * dimension.length + k_time * dimension.time;
  const double root = std::sqrt(lambda);
  if (power != std::round(power)) return std::pow(root, power);
  double factor = 1;
  for (double k = 0; k < std::abs(power); ++k) factor *= root;
  return power < 0 ? 1 / factor : factor;
}

}  // namespace nilas::scene
