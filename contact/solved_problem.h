#pragma once
/// A contact problem with its solution and the bodies it concerns.
#include <array>
#include <cstdint>
#include <vector>

#include "contact/detect/broad/contact_point.h"
#include "contact/problem/problem.h"
#include "contact/problem/solution.h"
#include "core/base/math.h"

namespace nilas::contact {

/// A body at the time of the contact; it may have broken since.
struct TouchingBody {
  std::int64_t id = 0;
  double inverse_mass = 0;  ///< 0 for a fixed body [1/kg]
};

/// A step's contact problem and its solution. For a step cut into substeps: those of the last substep with contacts.
struct SolvedProblem {
  ContactProblem problem;
  VecX guess;  ///< impulses that the solver began with, empty without a warm start [N s]
  ContactSolution solution;
  std::vector<detect::ContactPoint> points;           ///< the contact points, at the poses where they were found
  std::vector<std::array<TouchingBody, 2>> touching;  ///< bodies a and b of each point
  std::vector<double> d;                              ///< inverse mass scale of each contact, as from `measure` [1/kg]
  std::vector<Vec3> impulses;                         ///< impulses at the points, on body b, in G [N s]
  std::vector<Vec3> couples;         ///< couples at the points, on body b, in G [N m s]; empty without rolling friction
  Vec3 vessel_p = Vec3::Zero();      ///< the vessel's centre of mass when the contacts were found, in G [m]
  Mat3 vessel_R = Mat3::Identity();  ///< the vessel's attitude at that time
};

}  // namespace nilas::contact
