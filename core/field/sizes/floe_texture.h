#pragma once
/// Properties that vary from point to point inside a floe.
#include <memory>
#include <vector>

#include "core/base/math.h"
#include "core/field/sizes/cut_distribution.h"
#include "core/field/sizes/gaussian_field.h"

namespace nilas::field {

/// One property over the plane in which a field was laid out, as a share of its mean. It is the distribution's value at
/// a score: the weighted sum of unit Gaussian fields. The squares of the weights sum to 1.
struct PropertyPlane {
  CutDistribution distribution;
  std::vector<std::shared_ptr<const GaussianField>> fields;
  std::vector<double> weights;

  double at(const Vec2& x_G) const;
  /// Length below which the property hardly changes [m].
  double shortest_length() const;
};

/// The property inside one floe. Points are in the floe's frame B, with origin at the floe's centre of mass and the
/// axes that G had when the field was laid out: for a present point p_G, x_B = R_GB^T (p_G - p_GB).
class FloeTexture {
 public:
  /// `mean`: that of the property, in its unit. `origin`: that of B at the start, frame G [m].
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

}  // namespace nilas::field
