#pragma once
/// Where the bodies of a run were at its samples.
#include <cstdint>
#include <filesystem>
#include <map>
#include <vector>

#include "core/base/math.h"

namespace nilas {

struct SampledBody {
  Vec3 p, v, w;  ///< centre of mass [m], its velocity [m/s], angular velocity in G [rad/s]
  Quat q;
};

/// States of all bodies at one time, by id.
struct Sample {
  double t = 0;  ///< [s]
  std::map<std::int64_t, SampledBody> bodies;
};

using Motion = std::vector<Sample>;

/// Reads bodies.csv. Throws FileError where it cannot be read.
Motion read_motion(const std::filesystem::path& bodies_csv);

/// How far two motions are apart.
struct Distance {
  double t = 0;              ///< of the sample [s]
  double largest = 0;        ///< over bodies, between centres of mass [m]
  double rms = 0;            ///< [m]
  Vec3 axes = Vec3::Zero();  ///< largest per axis [m]
  double turn = 0;           ///< largest angle between attitudes [rad]
  bool same_bodies = true;   ///< the ids are the same; otherwise it is of those in both
};

/// One per sample of `a` that `b` has too. Times may differ by less than half the distance between samples: what is
/// left is bridged with b's velocities.
std::vector<Distance> distances(const Motion& a, const Motion& b);

/// Longest path of any body between the first sample and a later one [m].
double longest_path(const Motion& motion);

}  // namespace nilas
