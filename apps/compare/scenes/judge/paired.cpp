#include "apps/compare/scenes/judge/paired.h"

#include <cmath>

#include "apps/compare/workshop/special_numbers.h"
#include "core/base/statistics.h"

namespace nilas::compare {

PairedDifference paired_difference(std::vector<int> realisations, std::vector<double> values,
                                   std::vector<double> limits, double rounding, bool one_for_all) {
  PairedDifference found{std::move(realisations), std::move(values), std::move(limits), k_unknown, k_unknown};
  const std::size_t count = found.values.size();
  if (count == 0) return found;
  found.mean = mean_of(found.values);
  bool measured = count > 1;
  for (std::size_t k = 0; k < count; ++k) {
    found.beyond_chance += std::abs(found.values[k]) > found.limits[k] + rounding ? 1 : 0;
    measured = measured || std::isfinite(found.limits[k]);
  }
  if (count > 1)
    found.half_width =
        student_95(static_cast<double>(count - 1)) *
        std::sqrt(variance_of(found.values) * ((one_for_all ? 1.0 : 0.0) + 1.0 / static_cast<double>(count)));
  if (std::abs(found.mean) > found.half_width + rounding)
    found.certainty = Certainty::everywhere;
  else if (found.beyond_chance > 0)
    found.certainty = Certainty::in_realisations;
  else if (measured)
    found.certainty = Certainty::none;
  return found;
}

bool is_sure(const PairedDifference& difference) {
  return difference.certainty == Certainty::everywhere || difference.certainty == Certainty::in_realisations;
}

bool is_below_change(const PairedDifference& difference, double reference_moves) {
  return is_sure(difference) && std::abs(difference.mean) < reference_moves;
}

double chance_limit(std::optional<double> twin_difference, const std::vector<double>& alike) {
  double variance = 0, degrees = 0;
  if (twin_difference) {
    variance = *twin_difference * *twin_difference;
    degrees = 1;
  }
  if (alike.size() > 1 && (degrees == 0 || 2 * variance_of(alike) > variance)) {
    variance = 2 * variance_of(alike);
    degrees = static_cast<double>(alike.size() - 1);
  }
  return degrees > 0 ? student_95(degrees) * std::sqrt(variance) : k_infinity;
}

}  // namespace nilas::compare
