#pragma once
/// Properties that vary from point to point inside a floe.
#include <memory>
#include <vector>

#include "core/base/math.h"
#include "core/field/sizes/cut_distribution.h"
#include "core/field/sizes/gaussian_field.h"

namespace nilas {

/// One property over the plane in which a field was laid out, as a share of its mean: the distribution at the score
/// that the weighted sum of unit Gaussian fields gives. The squares of the weights sum to 1.
struct PropertyPlane {
  CutDistribution distribution;
  std::vector<std::shared_ptr<const GaussianField>> fields;
  std::vector<double> weights;

  double at(const Vec2& x_G) const;
  /// Below it the property hardly changes [m].
  double shortest_length() const;
};

/// The part of such a plane that a floe carries with it. Its points are those of the floe's own frame B, whose origin
/// is the floe's centre of mass and whose axes were those of G when the field was laid out: for a point p_G now,
/// x_B = R_GB^T (p_G - p_GB).
class FloeTexture {
 public:
  /// mean: of the property, in its unit; origin: of B at the start, in G [m].
  FloeTexture(std::shared_ptr<const PropertyPlane> plane, double mean, const Vec2& origin)
      : plane_(std::move(plane)), mean_(mean), origin_(origin) {}

  /// The property in its unit at a point of B [m].
  double at(double x, double y) const { return mean_ * plane_->at(origin_ + Vec2(x, y)); }
  /// Its mean over the area of a simple counter-clockwise outline in B: cubature of degree five [Radon 1948] on
  /// triangles of at most 1.5 correlation lengths.
  double mean_over(const std::vector<Vec2>& outline) const;

 private:
  std::shared_ptr<const PropertyPlane> plane_;
  double mean_;
  Vec2 origin_;
};

}  // namespace nilas
