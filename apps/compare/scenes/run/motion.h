#pragma once
/// The positions and attitudes of the bodies of a run at its samples.
#include <cstdint>
#include <filesystem>
#include <map>
#include <vector>

#include "core/base/math.h"

namespace nilas::compare {

struct SampledBody {
  Vec3 p, v, w;  ///< centre of mass [m], its velocity [m/s], angular velocity in G [rad/s]
  Quat q;
};

/// States of all bodies at one time, by id.
struct Sample {
  double t = 0;  ///< [s]
  std::map<std::int64_t, SampledBody> bodies;
};

using SampledMotion = std::vector<Sample>;

/// Reads bodies.csv. Throws FileError where it cannot be read.
SampledMotion read_motion(const std::filesystem::path& bodies_csv);

/// The distance between two motions at one time.
struct Distance {
  double t = 0;              ///< time of the sample [s]
  double largest = 0;        ///< largest distance between centres of mass over the bodies [m]
  double rms = 0;            ///< root mean square distance over the bodies [m]
  Vec3 axes = Vec3::Zero();  ///< largest per axis [m]
  double turn = 0;           ///< largest angle between attitudes [rad]
  bool same_bodies = true;   ///< the ids are the same; otherwise only bodies in both count
};

/// The distances, one per sample of `a` that `b` has too. Times may differ by up to half the interval between samples;
/// the remainder is extrapolated with b's velocities.
std::vector<Distance> distances(const SampledMotion& a, const SampledMotion& b);

/// The longest straight distance of any body from its place in the first sample [m].
double longest_path(const SampledMotion& motion);

}  // namespace nilas::compare
