#include "core/field/sizes/cut_distribution.h"

#include <fmt/format.h>

#include <algorithm>
#include <boost/math/distributions/lognormal.hpp>
#include <boost/math/distributions/normal.hpp>
#include <boost/math/distributions/uniform.hpp>
#include <boost/math/distributions/weibull.hpp>
#include <boost/math/tools/toms748_solve.hpp>
#include <cmath>
#include <cstdint>

#include "core/base/error.h"

namespace nilas::field {

namespace {

/// Calls use(distribution) with Boost's distribution of this kind.
template <class Use>
double with_distribution(SpreadKind kind, double first, double second, const Use& use) {
  switch (kind) {
    case SpreadKind::lognormal:
      return use(boost::math::lognormal(first, second));
    case SpreadKind::uniform:
      return use(boost::math::uniform(first, second));
    case SpreadKind::weibull:
      return use(boost::math::weibull(first, second));
    case SpreadKind::normal:
      break;
  }
  return use(boost::math::normal(first, second));
}

/// Shape k of the Weibull distribution: cov^2 = G(1 + 2/k) / G(1 + 1/k)^2 - 1.
double weibull_shape(double cov) {
  const auto lack = [&](double k) {
    return std::lgamma(1 + 2 / k) - 2 * std::lgamma(1 + 1 / k) - std::log1p(cov * cov);
  };
  constexpr double k_exponential = 1;  // a shape of 1 has a cov of 1
  if (lack(k_exponential) <= 0) return k_exponential;
  std::uintmax_t iterations = 200;
  const auto [low, high] = boost::math::tools::toms748_solve(lack, k_exponential, 10 / cov,
                                                             boost::math::tools::eps_tolerance<double>(), iterations);
  return 0.5 * (low + high);
}

}  // namespace

CutDistribution::CutDistribution(SpreadKind kind, double cov, double low, double high)
    : kind_(kind), cov_(cov), lowest_(low), highest_(high) {
  if (!(cov >= 0 && cov <= 1))
    throw InputError(fmt::format("spread of a property: cov: found {}, allowed 0 to 1", cov));
  if (!(low > 0 && low < 1 && high > 1))
    throw InputError(
        fmt::format("spread of a property: found limits {} and {} of the mean, allowed: the mean between "
                    "them",
                    low, high));
  if (cov == 0) {
    lowest_ = highest_ = 1;
    return;
  }
  switch (kind) {
    case SpreadKind::normal:
      first_ = 1, second_ = cov;
      break;
    case SpreadKind::lognormal:
      second_ = std::sqrt(std::log1p(cov * cov));
      first_ = -0.5 * second_ * second_;
      break;
    case SpreadKind::uniform:
      first_ = 1 - std::sqrt(3.0) * cov, second_ = 1 + std::sqrt(3.0) * cov;
      lowest_ = std::max(lowest_, first_);
      highest_ = std::min(highest_, second_);
      break;
    case SpreadKind::weibull:
      first_ = weibull_shape(cov);
      second_ = 1 / std::tgamma(1 + 1 / first_);
      break;
  }
  cut_below_ = with_distribution(kind, first_, second_, [&](const auto& d) { return cdf(d, lowest_); });
  if (std::isfinite(highest_))
    cut_above_ = with_distribution(kind, first_, second_, [&](const auto& d) { return cdf(complement(d, highest_)); });
}

double CutDistribution::from_tails(double below, double above) const {
  if (cov_ == 0) return 1;
  if (below <= 0) return lowest_;
  if (above <= 0) return highest_;
  const double share = 1 - cut_below_ - cut_above_;
  const double value = with_distribution(kind_, first_, second_, [&](const auto& d) {
    return below <= above ? boost::math::quantile(d, cut_below_ + share * below)
                          : boost::math::quantile(complement(d, cut_above_ + share * above));
  });
  return std::clamp(value, lowest_, highest_);
}

double CutDistribution::at_score(double z) const {
  return from_tails(0.5 * std::erfc(-z / std::sqrt(2.0)), 0.5 * std::erfc(z / std::sqrt(2.0)));
}

double CutDistribution::quantile(double u) const { return from_tails(u, 1 - u); }

}  // namespace nilas::field
