#pragma once
/// Impulses on floes that broke, as a first guess of those on their pieces. docs/theory/fracture-breaking.md
#include <cstdint>
#include <map>
#include <vector>

#include "contact/detect/broad/contact_point.h"
#include "contact/solved_problem.h"
#include "core/base/state.h"
#include "core/bodies/bodies.h"
#include "fracture/model/fracture_event.h"

namespace nilas {

class BrokenContacts {
 public:
  /// Notes, in place of all that was noted, the impulses on floes that broke; `last`: contacts of the part of the step
  /// that ended with the breaks.
  void note(const SolvedProblem& last, const std::vector<FractureEvent>& broken);

  /// Adds what was noted to the guess (3 per contact, in the contacts' frames C; points first) [N s]. Each impulse goes
  /// to the nearest point, within two thicknesses of the ice, between a piece of its floe and the same other body or a
  /// piece of it, on which it presses; points equally near share it evenly. What finds none is left out. `bodies`: at
  /// the poses of the points, with the velocities that they came there with.
  void add_to(const Bodies& bodies, const std::vector<ContactPoint>& points, const std::vector<Mat3>& C,
              VecX& guess) const;

  void forget() { *this = {}; }

  void save(StateWriter out) const;
  void restore(const StateReader& in);

 private:
  /// Between two bodies, of which at least one broke.
  struct Load {
    std::int64_t a = 0, b = 0;    ///< ids
    Vec3 p = Vec3::Zero();        ///< in G [m]
    Vec3 impulse = Vec3::Zero();  ///< on b, in G [N s]
  };
  struct Taker;

  std::int64_t broken_or_self(std::int64_t id) const;
  std::vector<Taker> takers(const Bodies& bodies, const std::vector<ContactPoint>& points) const;

  double h_ = 0;                                  ///< of the part of the step that they acted in [s]
  std::map<std::int64_t, std::int64_t> floe_of_;  ///< by piece
  std::vector<Load> loads_;
};

}  // namespace nilas
