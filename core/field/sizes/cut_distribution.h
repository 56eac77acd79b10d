#pragma once
/// Distributions of the properties of ice, as shares of their mean, cut to physical limits.
#include "core/choices/ice_choices.h"

namespace nilas::field {

/// A distribution with mean 1 and standard deviation `cov` before it is cut. The part within the limits is scaled to
/// probability 1. Values do not accumulate at the limits, and mean and deviation change through the cut.
class CutDistribution {
 public:
  /// cov in [0, 1]; 0: always 1. 0 < low < 1 < high, which may be infinite. Throws InputError for anything else.
  CutDistribution(SpreadKind kind, double cov, double low, double high);

  /// The value with the same cumulative probability as the standard normal score z. It is strictly increasing, so that
  /// a Gaussian copula keeps its order, and exact in both tails.
  double at_score(double z) const;
  /// The quantile of probability u in [0, 1].
  double quantile(double u) const;
  double lowest() const { return lowest_; }
  double highest() const { return highest_; }

 private:
  double from_tails(double below, double above) const;

  SpreadKind kind_;
  double cov_;
  double first_ = 0, second_ = 0;  ///< parameters of the distribution before the cut, in Boost's order
  double lowest_, highest_;
  double cut_below_ = 0, cut_above_ = 0;  ///< probabilities cut off
};

}  // namespace nilas::field
