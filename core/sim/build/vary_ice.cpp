#include <fmt/format.h>

#include <limits>

#include "core/base/error.h"
#include "core/sim/world/ice_plan.h"

namespace nilas::sim {

namespace {

/// Lower bound of a floe's thickness, density or strength [share of the mean]: values near 0 are not those of ice.
constexpr double k_least_share = 0.05;
/// Upper bound of the density of ice that floats [share of the water's density].
constexpr double k_greatest_density = 0.999;

/// Upper bound of the property [share of the mean].
double highest_share(const scene::VaryScene& vary, const scene::Scene& scene, double water_density) {
  if (vary.property != FloeProperty::density || water_density <= 0) return std::numeric_limits<double>::infinity();
  const double allowed = k_greatest_density * water_density;
  if (scene.ice->density >= allowed)
    throw InputError(
        fmt::format("{}:{}: <ice><vary>: density varies about {:g} kg/m^3; allowed: below {:g}, {:g} of "
                    "the water's, where there is buoyancy",
                    scene.file.string(), vary.line, scene.ice->density, allowed, k_greatest_density));
  return allowed / scene.ice->density;
}

field::PropertySpread spread_of(const scene::VaryScene& vary, const scene::Scene& scene, double water_density) {
  const field::CutDistribution distribution(vary.distribution, vary.cov, k_least_share,
                                            highest_share(vary, scene, water_density));
  return {vary.property, distribution, vary.correlation_length};
}

}  // namespace

field::FloeVariation floe_variation(const scene::Scene& scene) {
  const bool floats = scene.water && scene.hydro && scene.hydro->buoyancy;
  const double water_density = floats ? scene.water->density : 0;
  const auto& vary = scene.ice->vary;
  std::vector<field::PropertySpread> spreads;
  const auto n = static_cast<Eigen::Index>(vary.size());
  MatX correlation = MatX::Identity(n, n);
  for (Eigen::Index i = 0; i < n; ++i) {
    const scene::VaryScene& one = vary[i];
    spreads.push_back(spread_of(one, scene, water_density));
    for (const auto& [partner, value] : one.correlations)
      for (Eigen::Index j = 0; j < n; ++j)
        if (vary[j].property == partner) correlation(i, j) = correlation(j, i) = value;
  }
  return field::FloeVariation(std::move(spreads), correlation, scene.seed);
}

}  // namespace nilas::sim
