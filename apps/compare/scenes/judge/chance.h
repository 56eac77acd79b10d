#pragma once
/// The variance that chance alone gives to the difference of two runs.
#include <vector>

namespace nilas {

/// Variance of the difference of two runs of one realisation that nothing but chaos sets apart. `settings`: differences
/// from the reference, one list per setting, one entry per realisation. The larger of what the twins say (mean of their
/// squared differences) and of twice what a setting's differences scatter over the realisations once what all settings
/// share in each (their median: the reference's own chance) is taken out: the median over settings, divided by that of
/// chi^2 over its degrees of freedom, so that a few settings of another kind do not count; right in the mean to some
/// tenths for few settings. Of one setting alone plainly what its differences scatter.
struct PooledVariance {
  double value = 0;
  double degrees = 0;        ///< of freedom behind it, of the one that is larger
  bool by_settings = false;  ///< which is larger; else the twins' is
};
PooledVariance pooled_variance(const std::vector<double>& twin_differences,
                               const std::vector<std::vector<double>>& settings);

}  // namespace nilas
