#pragma once
/// The impulses on floes that broke, as a first guess for their pieces. docs/theory/fracture-breaking.md
#include <cstdint>
#include <map>
#include <vector>

#include "contact/detect/broad/contact_point.h"
#include "contact/solved_problem.h"
#include "core/base/state.h"
#include "core/bodies/bodies.h"
#include "fracture/model/fracture_event.h"

namespace nilas::fracture {

class BrokenContacts {
 public:
  /// Forgets what was noted, and notes the impulses on floes that broke. `last` has the contacts of the substep that
  /// ended with the breaks.
  void note(const contact::SolvedProblem& last, const std::vector<FractureEvent>& broken);

  /// Adds the noted impulses to the guess [N s], which has 3 entries per contact in the contacts' frames C, points
  /// first. Each impulse goes to the nearest point within two thicknesses of the ice. The point is between a piece of
  /// the floe and the same other body, or a piece of it, and the impulse presses on it. Points that are equally near
  /// share it evenly. An impulse that finds no point is dropped. `bodies` are at the poses of the points, with the
  /// velocities that brought them there.
  void add_to(const bodies::Bodies& bodies, const std::vector<detect::ContactPoint>& points, const std::vector<Mat3>& C,
              VecX& guess) const;

  void forget() { *this = {}; }

  void save(StateWriter out) const;
  void restore(const StateReader& in);

 private:
  /// An impulse between two bodies, of which at least one broke.
  struct Load {
    std::int64_t a = 0, b = 0;    ///< Ids of the bodies.
    Vec3 p = Vec3::Zero();        ///< Place in G [m].
    Vec3 impulse = Vec3::Zero();  ///< Impulse on b in G [N s].
  };
  struct Taker;

  std::int64_t broken_or_self(std::int64_t id) const;
  std::vector<Taker> takers(const bodies::Bodies& bodies, const std::vector<detect::ContactPoint>& points) const;

  double h_ = 0;                                  ///< Length of the substep in which the impulses acted [s].
  std::map<std::int64_t, std::int64_t> floe_of_;  ///< Id of the broken floe by that of its piece.
  std::vector<Load> loads_;
};

}  // namespace nilas::fracture
