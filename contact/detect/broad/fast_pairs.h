#pragma once
/// Finds pairs of bodies that move so far against each other in a step that they could pass through each other.
#include <vector>

#include "core/base/math.h"
#include "core/bodies/bodies.h"

namespace nilas::detect {

/// The motion that a search for fast pairs judges.
struct FastMotion {
  const std::vector<Vec3>& v;  ///< velocities of the centres of mass over the step [m/s]
  const std::vector<Vec3>& w;  ///< angular velocities [rad/s]
  double h = 0;                ///< length of the step [s]
};

/// Two bodies, a < b, that move fast against each other.
struct FastPair {
  int a = 0, b = 0;
  double width = 0;  ///< the smaller of the two widths [m]
  double way = 0;    ///< bound on the path of any point of one body against the other [m]
};

/// Returns the smallest width of each body [m]; infinite for a half space.
std::vector<double> smallest_widths(const bodies::Bodies& bodies);

/// Returns false when no pair can be fast, at the cost of one pass over the bodies.
bool any_fast(const bodies::Bodies& bodies, const FastMotion& motion, const std::vector<double>& widths, double share);
/// Returns whether a point of body b may move more than `share` of the smaller of both `widths` [m] against body a.
bool is_fast(const bodies::Bodies& bodies, const FastMotion& motion, const std::vector<double>& widths, double share,
             int a, int b);
/// Returns all fast pairs whose bounding balls meet along their paths, in rising order.
std::vector<FastPair> fast_pairs(const bodies::Bodies& bodies, const FastMotion& motion,
                                 const std::vector<double>& widths, double share);

}  // namespace nilas::detect
