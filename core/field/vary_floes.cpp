#include "core/field/vary_floes.h"

#include <algorithm>
#include <numeric>

#include "core/base/error.h"
#include "core/base/random.h"
#include "core/geometry/mass_properties.h"

namespace nilas::field {

namespace {

/// The order in which the properties are numbered.
std::vector<std::size_t> sorted_order(const std::vector<PropertySpread>& spreads) {
  std::vector<std::size_t> order(spreads.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::sort(order.begin(), order.end(),
            [&](std::size_t a, std::size_t b) { return spreads[a].property < spreads[b].property; });
  for (std::size_t k = 1; k < order.size(); ++k)
    if (spreads[order[k]].property == spreads[order[k - 1]].property)
      throw InputError("variation of floes: found two spreads of " + name_of(spreads[order[k]].property) +
                       ", allowed one");
  return order;
}

std::string stream_name(FloeProperty property, const std::string& rest) { return name_of(property) + " " + rest; }

}  // namespace

FloeVariation::FloeVariation(std::vector<PropertySpread> spreads, const MatX& correlation, std::uint64_t seed)
    : seed_(seed) {
  const auto n = static_cast<Eigen::Index>(spreads.size());
  NILAS_DEMAND(correlation.rows() == n && correlation.cols() == n);
  const std::vector<std::size_t> order = sorted_order(spreads);
  MatX sorted(n, n);
  for (Eigen::Index i = 0; i < n; ++i) {
    for (Eigen::Index j = 0; j < n; ++j) {
      const auto a = order[i], b = order[j];
      sorted(i, j) = correlation(static_cast<Eigen::Index>(a), static_cast<Eigen::Index>(b));
      if (sorted(i, j) != 0 && spreads[a].correlation_length != spreads[b].correlation_length)
        throw InputError("variation of floes: correlated properties must have one correlation length");
    }
    spreads_.push_back(spreads[order[i]]);
  }
  const Eigen::LLT<MatX> cholesky(sorted);
  if (cholesky.info() != Eigen::Success)
    throw InputError("variation of floes: the correlations are not those of a positive definite matrix");
  lower_ = cholesky.matrixL();
  std::vector<std::shared_ptr<const GaussianField>> fields(spreads_.size());
  for (std::size_t k = 0; k < spreads_.size(); ++k)
    if (const double length = spreads_[k].correlation_length; length > 0)
      fields[k] = std::make_shared<const GaussianField>(
          length, RandomStream(seed, stream_name(spreads_[k].property, "texture")));
  for (std::size_t k = 0; k < spreads_.size(); ++k) planes_.push_back(fields[k] ? plane(k, fields) : nullptr);
}

std::shared_ptr<const PropertyPlane> FloeVariation::plane(
    std::size_t row, const std::vector<std::shared_ptr<const GaussianField>>& fields) const {
  PropertyPlane plane{spreads_[row].distribution, {}, {}};
  for (std::size_t k = 0; k <= row; ++k) {
    const double weight = lower_(static_cast<Eigen::Index>(row), static_cast<Eigen::Index>(k));
    if (weight == 0) continue;
    plane.fields.push_back(fields[k]);
    plane.weights.push_back(weight);
  }
  return std::make_shared<const PropertyPlane>(std::move(plane));
}

double FloeVariation::score(std::size_t row, const std::string& name) const {
  double z = 0;
  for (std::size_t k = 0; k <= row; ++k) {
    const double weight = lower_(static_cast<Eigen::Index>(row), static_cast<Eigen::Index>(k));
    if (weight != 0) z += weight * RandomStream(seed_, stream_name(spreads_[k].property, "of " + name)).normal();
  }
  return z;
}

std::vector<TexturedProperty> FloeVariation::draw(FieldFloe& floe, const std::string& name,
                                                  const FloeValues& means) const {
  std::vector<TexturedProperty> textures;
  for (std::size_t k = 0; k < spreads_.size(); ++k) {
    double& value = value_of(floe, spreads_[k].property);
    if (value > 0) continue;
    const double mean = means[static_cast<std::size_t>(spreads_[k].property)];
    if (!planes_[k]) {
      value = mean * spreads_[k].distribution.at_score(score(k, name));
      continue;
    }
    const Vec2 centre = geometry::polygon_moments(floe.outline).centroid;
    std::vector<Vec2> outline = floe.outline;
    for (Vec2& x : outline) x -= centre;
    const FloeTexture texture(planes_[k], mean, centre);
    value = texture.mean_over(outline);
    textures.push_back({spreads_[k].property, texture});
  }
  return textures;
}

}  // namespace nilas::field
