#include "apps/compare/scenes/judge/chance.h"

#include <algorithm>
#include <boost/math/distributions/chi_squared.hpp>

#include "core/base/statistics.h"

namespace nilas::compare {

PooledVariance pooled_variance(const std::vector<double>& twin_differences,
                               const std::vector<std::vector<double>>& settings) {
  PooledVariance pooled;
  for (const double difference : twin_differences)
    pooled.value += difference * difference / static_cast<double>(twin_differences.size());
  pooled.degrees = static_cast<double>(twin_differences.size());
  if (settings.empty() || settings.front().size() < 2) return pooled;
  const std::size_t realisations = settings.front().size();
  const auto count = static_cast<double>(settings.size()), degrees = static_cast<double>(realisations - 1);
  std::vector<double> shared(realisations, 0);
  for (std::size_t r = 0; settings.size() > 1 && r < realisations; ++r) {
    std::vector<double> of_all;
    for (const auto& differences : settings) of_all.push_back(differences[r] - mean_of(differences));
    shared[r] = median_of(of_all);
  }
  // the median uses one of `count` degrees of freedom, and the reference scatters as the settings do
  const double both = settings.size() > 1 ? 2 * count / (count - 1) : 1;
  std::vector<double> variances;
  for (auto differences : settings) {
    for (std::size_t r = 0; r < realisations; ++r) differences[r] -= shared[r];
    variances.push_back(both * variance_of(differences));
  }
  const boost::math::chi_squared spread(degrees);
  constexpr double k_worth = 0.37;  // of a degree of freedom, in a median of squares (Hampel 1974)
  const PooledVariance of_settings{median_of(variances) * degrees / boost::math::quantile(spread, 0.5),
                                   std::max(degrees, k_worth * degrees * (count - 1)), true};
  return of_settings.value >= pooled.value ? of_settings : pooled;
}

}  // namespace nilas::compare
