#pragma once
/// Statistics of samples. Sums run from the first value to the last, so that results repeat to the last bit; boost,
/// whose summation differs between its versions, gives the quantiles of distributions only.
#include <vector>

namespace nilas {

/// Arithmetic mean; NaN of no values.
double mean_of(const std::vector<double>& values);

/// Sum of the squared deviations from `mean`.
double squares_about(const std::vector<double>& values, double mean);

/// Variance of the population that the sample was drawn from, with n - 1 degrees of freedom; NaN of fewer than two
/// values.
double variance_of(const std::vector<double>& values);

/// Middle value, of an even number the mean of the two in the middle; NaN of no values.
double median_of(std::vector<double> values);

/// Value below which `share` (0 to 1) of the sample lies, linear between neighbours. Demands at least one value.
double percentile_of(std::vector<double> values, double share);

/// Two-sided 95 % quantile of Student's t; infinite without degrees of freedom.
double student_95(double degrees);

/// One-sided 95 % quantile of Fisher's F, the ratio of two variances of the same population; infinite without degrees
/// of freedom.
double fisher_95(double degrees, double degrees_below);

}  // namespace nilas
