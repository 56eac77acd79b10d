#include "core/scene/check/cross_checks.h"
#include "core/scene/schema/attribute_values.h"
#include "core/scene/spec/values.h"

namespace nilas::scene {

namespace {

/// The still water between the walls.
struct Basin {
  double length, width;
  bool holds(const std::vector<double>& region) const {
    constexpr double k_rounding = 1e-9;
    const double slack = k_rounding * (length + width);
    return region[0] >= -slack && region[2] <= length + slack && region[1] >= -0.5 * width - slack &&
           region[3] <= 0.5 * width + slack;
  }
};

std::string in_words(const std::vector<double>& numbers) {
  std::string text;
  for (const double x : numbers) text += (text.empty() ? "" : " ") + format_number(x);
  return text;
}

}  // namespace

void check_tank(const SceneElement& root, const SceneElement& tank, std::vector<Fault>& faults) {
  const auto length = number_of(tank, "length"), width = number_of(tank, "width");
  const SceneElement* ice = child_of(root, "ice");
  if (!length || !width || !ice) return;
  const Basin basin{*length, *width};
  for (const auto& field : ice->children) {
    // fixed ice may overlap walls
    if (field.name != "field" || is_true(field, "fixed")) continue;
    const auto region = numbers_of(field, "region");
    if (!region || basin.holds(*region)) continue;
    faults.push_back(fault_of(field, "region",
                              "found " + in_words(*region) + "; allowed: within the tank's walls, x from 0 to " +
                                  format_number(*length) + " and y from " + format_number(-0.5 * *width) + " to " +
                                  format_number(0.5 * *width) + " [m]"));
  }
}

}  // namespace nilas::scene
