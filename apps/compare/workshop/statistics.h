#pragma once
/// Means and standard errors of a handful of runs, and what of a difference is chance.
#include <vector>

namespace nilas {

double mean_of(const std::vector<double>& values);
/// Of the values about their mean, with one degree of freedom taken by it; NaN of fewer than two.
double variance_of(const std::vector<double>& values);
double median_of(std::vector<double> values);

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

/// 95 % quantile of the ratio of two variances of the same kind (Fisher); infinite without degrees of freedom.
double scatter_95(double degrees, double degrees_below);

/// Two-sided 95 % quantile of Student's t; infinite without degrees of freedom.
double student_95(double degrees);

}  // namespace nilas
