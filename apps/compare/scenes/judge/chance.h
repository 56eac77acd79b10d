#pragma once
/// The variance that chance alone gives to the difference of two runs.
#include <vector>

namespace nilas::compare {

/// The variance of the difference of two runs of one realisation that differ by chaos alone. It is the larger of two
/// estimates:
/// 1. the mean of the squared differences of the perturbed runs;
/// 2. twice the variance of a setting's differences from the reference over the realisations. The median over the
///    settings in each realisation, which is the reference's own chance, is removed first. The median of the variances
///    is divided by that of chi^2 over its degrees of freedom, so that a few settings of another kind do not count. For
///    few settings its mean is right to some tenths. For a single setting nothing is removed and nothing is doubled.
/// `settings`: one list per setting, one entry per realisation.
struct PooledVariance {
  double value = 0;
  double degrees = 0;        ///< degrees of freedom of the larger estimate
  bool by_settings = false;  ///< the estimate by the settings is larger, not that of the perturbed runs
};
PooledVariance pooled_variance(const std::vector<double>& twin_differences,
                               const std::vector<std::vector<double>>& settings);

}  // namespace nilas::compare
