#pragma once
/// Pairs of bodies that move so far against each other in a step that they could pass through each other.
#include <vector>

#include "core/base/math.h"
#include "core/bodies/bodies.h"

namespace nilas {

/// What a search for fast pairs is asked about.
struct FastMotion {
  const std::vector<Vec3>& v;  ///< of the centres of mass over the step [m/s]
  const std::vector<Vec3>& w;  ///< [rad/s]
  double h = 0;                ///< [s]
};

/// Two bodies, a < b.
struct FastPair {
  int a = 0, b = 0;
  double width = 0;  ///< the smaller of both [m]
  double way = 0;    ///< bound on the way of any point of the one against the other [m]
};

/// Smallest width of each body's parts; infinite for a half space [m].
std::vector<double> smallest_widths(const Bodies& bodies);

/// False when no pair can be fast, at the cost of one pass over the bodies.
bool any_fast(const Bodies& bodies, const FastMotion& motion, const std::vector<double>& widths, double share);
/// Whether a point of body b may go more than `share` of the smaller of both `widths` [m] against body a.
bool is_fast(const Bodies& bodies, const FastMotion& motion, const std::vector<double>& widths, double share, int a,
             int b);
/// All fast pairs whose balls meet on their ways, in rising order.
std::vector<FastPair> fast_pairs(const Bodies& bodies, const FastMotion& motion, const std::vector<double>& widths,
                                 double share);

}  // namespace nilas
