#pragma once
/// Draws the properties of floes.
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "core/field/sizes/floe_property.h"
#include "core/field/sizes/floe_texture.h"

namespace nilas::field {

/// The variation of one property over the floes.
struct PropertySpread {
  FloeProperty property;
  CutDistribution distribution;
  double correlation_length = 0;  ///< > 0: varies from point to point, also within floes [m]; 0: one value per floe
};

/// A property inside one floe.
struct TexturedProperty {
  FloeProperty property;
  FloeTexture texture;
};

/// Draws correlated properties by a Gaussian copula: scores z = L s, where L L^T is the correlation matrix and s are
/// independent standard normal, make the values mean * distribution.at_score(z). s of a property is, per floe, the
/// first number of the stream "<property> of <floe's name>"; with a correlation length it is the value of a
/// GaussianField of stream "<property> texture". A draw depends on seed, property, floe and the properties before it
/// in FloeProperty that it is correlated with, on nothing else.
class FloeVariation {
 public:
  /// Prepares the variation. `correlation`: that of the scores, one row per spread in their order, symmetric, ones on
  /// the diagonal. Correlated properties must have the same correlation length. Throws InputError where they do not,
  /// where a property occurs twice, or where the matrix is not positive definite.
  FloeVariation(std::vector<PropertySpread> spreads, const MatX& correlation, std::uint64_t seed);

  /// Draws the varying properties that `floe` leaves open (0). `means`: values of a floe that does not vary. A property
  /// that varies within the floe gets the mean over its area, and its texture is returned.
  std::vector<TexturedProperty> draw(FieldFloe& floe, const std::string& name, const FloeValues& means) const;

  const std::vector<PropertySpread>& spreads() const { return spreads_; }

 private:
  double score(std::size_t row, const std::string& name) const;
  std::shared_ptr<const PropertyPlane> plane(std::size_t row,
                                             const std::vector<std::shared_ptr<const GaussianField>>& fields) const;

  std::vector<PropertySpread> spreads_;  ///< sorted in the order of FloeProperty
  MatX lower_;                           ///< L
  std::uint64_t seed_;
  std::vector<std::shared_ptr<const PropertyPlane>> planes_;  ///< null: one value per floe
};

}  // namespace nilas::field
