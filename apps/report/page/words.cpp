#include "apps/report/page/words.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace nilas::report {

namespace {

std::string coordinates_text(const Vec3& place, int count) {
  constexpr double k_digits = 1e-4, k_finest = 1e-6;  // [-], [m]
  const double largest = place.head(count).cwiseAbs().maxCoeff();
  const double unit = std::max(k_finest, std::pow(10, std::ceil(std::log10(std::max(largest, k_finest) * k_digits))));
  std::string text;
  for (int k = 0; k < count; ++k)
    text += fmt::format("{}{} = {:.6g} m", k == 0 ? "" : ", ", "xyz"[k], std::round(place[k] / unit) * unit + 0.0);
  return text;
}

}  // namespace

std::string place_text(const Vec3& place) { return coordinates_text(place, 3); }
std::string horizontal_place_text(const Vec3& place) { return coordinates_text(place, 2); }

std::string error_force(double newton, double beside) {
  const output::ForceUnit unit = output::force_unit(std::max(std::abs(newton), std::abs(beside)));
  const double value = newton / unit.size;
  if (value == 0 || !std::isfinite(value)) return fmt::format("{:g} {}", value, unit.name);
  const double power = std::floor(std::log10(std::abs(value)));
  const double last = std::pow(10, power - 1);
  return fmt::format("{:.{}f} {}", std::round(value / last) * last, std::max(0, 1 - static_cast<int>(power)),
                     unit.name);
}

std::string mean_with_error(double mean, const std::optional<double>& error, bool at_least) {
  const std::string text = output::force_text(mean);
  if (!error) return text + " (± not known)";
  return text + " ± " + (at_least ? "at least " : "") + error_force(*error, mean);
}

std::string sided_mean(double mean, const std::optional<double>& error, const output::LoadSides& sides) {
  return mean_with_error(std::abs(mean), error, false) + " " + (mean < 0 ? sides.negative : sides.positive);
}

output::LoadSides sides_along(bool is_vessel) {
  return is_vessel ? output::k_astern : output::LoadSides{"along the drift", "against the drift"};
}

std::string time_text(double t, double step) {
  const int decimals = step > 0 ? std::clamp(static_cast<int>(std::ceil(-std::log10(step) - 1e-9)), 0, 6) : 3;
  std::string text = fmt::format("{:.{}f}", t, decimals);
  if (text.find('.') != std::string::npos) {
    text.erase(text.find_last_not_of('0') + 1);
    if (text.back() == '.') text.pop_back();
  }
  return text + " s";
}

std::string number_text(double value) { return fmt::format("{:.4g}", value); }

}  // namespace nilas::report
