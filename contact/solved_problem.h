#pragma once
/// A contact problem together with its solution and the bodies that it was about.
#include <array>
#include <cstdint>
#include <vector>

#include "contact/detect/broad/contact_point.h"
#include "contact/problem/problem.h"
#include "contact/problem/solution.h"
#include "core/base/math.h"

namespace nilas {

/// A body where it touched another; it may have broken since.
struct TouchingBody {
  std::int64_t id = 0;
  double inverse_mass = 0;  ///< 0 of a fixed one [1/kg]
};

/// A step's contact problem and what its solver made of it; of a step that was cut, the last part with contacts.
struct SolvedProblem {
  ContactProblem problem;
  ContactSolution solution;
  std::vector<ContactPoint> points;                   ///< where the contacts were found
  std::vector<std::array<TouchingBody, 2>> touching;  ///< per point, a and b
  std::vector<double> d;                              ///< per contact, as from `measure` [1/kg]
  std::vector<Vec3> impulses;                         ///< per point, on body b, in G [N s]
  std::vector<Vec3> couples;         ///< per point, on body b, in G [N m s]; empty without rolling friction
  Vec3 vessel_p = Vec3::Zero();      ///< its centre of mass where the contacts were found, in G [m]
  Mat3 vessel_R = Mat3::Identity();  ///< its attitude there
};

}  // namespace nilas
