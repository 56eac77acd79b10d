#pragma once
/// Breaking of floes: the loads of a step, and the failure modes under them. docs/theory/fracture-breaking.md
#include <cstdint>
#include <map>
#include <optional>
#include <vector>

#include "contact/step_motion.h"
#include "core/base/state.h"
#include "core/bodies/bodies.h"
#include "core/bodies/ice_properties.h"
#include "fracture/failure.h"
#include "fracture/ice_damage.h"
#include "fracture/model/floe_pieces.h"

namespace nilas::fracture {

struct BreakingSettings {
  FailureSettings failure;
  std::optional<DamageRule> damage;  ///< Rule of damage. Without it loads below the strength leave no trace.
};

class Breaking {
 public:
  explicit Breaking(const BreakingSettings& settings);

  /// Notes the impulses of the vessel and of bodies on breakable floes in this substep. Those of floes and walls do not
  /// count.
  void note_loads(const bodies::Bodies& bodies, const bodies::IceProperties& ice, const contact::StepMotion& motion);

  /// Returns the floes that break under the impulses noted since the last call, as forces over `step` [s]. They are in
  /// the order of their ids. The worst load of a floe comes first among its failure modes.
  std::vector<FloeBreak> take_breaks(const bodies::Bodies& bodies, const bodies::IceProperties& ice, double step);

  /// Gives pieces the damage of their floes, which have left the bodies.
  void follow(const bodies::Bodies& bodies, const std::vector<NewPiece>& pieces);

  /// The largest damage D of the places of a floe; 0 without <damage>.
  double damage(std::int64_t floe) const;

  void save(StateWriter out) const;
  void restore(const StateReader& in);

 private:
  static IceAtContact ice_at(const bodies::Bodies& bodies, const bodies::IceProperties& ice, std::size_t b,
                             const Vec2& x, const LocalIce* around);
  std::vector<Failure> ways_under(const EdgeContact& contact, std::int64_t floe, const std::vector<Vec2>& outline,
                                  const IceAtContact& ice);

  FailureRules rules_;
  std::optional<IceDamage> damage_;
  std::map<std::int64_t, std::vector<PointLoad>>
      loads_;  ///< Loads by the id of the floe; the forces are impulses [N s].
};

}  // namespace nilas::fracture
