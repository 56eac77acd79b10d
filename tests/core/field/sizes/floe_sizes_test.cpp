#include "core/field/sizes/floe_sizes.h"

#include <gtest/gtest.h>

#include <cmath>

#include "core/field/sizes/distribution_statistics.h"

namespace nilas::field {
namespace floe_sizes_test {

PackedSpec spec_of(SizeDistribution distribution) {
  PackedSpec spec;
  spec.distribution = distribution;
  return spec;
}

/// 1.63 / sqrt(n) is exceeded by one sample in a hundred.
TEST(FloeSizes, TheDrawsFollowTheQuantiles) {
  for (const auto distribution :
       {SizeDistribution::lognormal, SizeDistribution::uniform, SizeDistribution::power_law}) {
    const PackedSpec spec = spec_of(distribution);
    RandomStream random(3, "sizes");
    std::vector<double> sizes;
    for (const double area : draw_areas(spec, 3000, random)) sizes.push_back(std::sqrt(area));
    ASSERT_GT(sizes.size(), 2000u);
    EXPECT_LT(ks_distance(sizes, [&](double u) { return size_quantile(spec, u); }),
              1.63 / std::sqrt(static_cast<double>(sizes.size())))
        << static_cast<int>(distribution);
  }
}

/// Far from its ends the lognormal has the requested moments.
TEST(FloeSizes, TheQuantilesHaveTheMoments) {
  PackedSpec spec = spec_of(SizeDistribution::lognormal);
  spec.min = 1e-3, spec.max = 100;
  const auto wide = summary_of([&](double u) { return size_quantile(spec, u); });
  EXPECT_NEAR(wide.mean, spec.mean, 1e-9);
  EXPECT_NEAR(wide.sd, spec.sd, 1e-8);
  EXPECT_EQ(wide.min, spec.min);
  EXPECT_EQ(wide.max, spec.max);
  spec.sd = 0;
  EXPECT_EQ(size_quantile(spec, 0.9), spec.mean);
  EXPECT_EQ(size_quantile(spec_of(SizeDistribution::fixed), 0.9), spec.mean);
}

}  // namespace floe_sizes_test
}  // namespace nilas::field
