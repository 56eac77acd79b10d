#pragma once
/// Breaking of floes under what presses on them: loads of a step, and the ways to break under them.
/// docs/theory/fracture.md
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

namespace nilas {

struct BreakingSettings {
  FailureSettings failure;
  std::optional<DamageRule> damage;  ///< none: loads below the strength leave no trace
};

class Breaking {
 public:
  explicit Breaking(const BreakingSettings& settings);

  /// Notes what the vessel and bodies (never floes or walls) press with on breakable floes in this part of a step.
  void note_loads(const Bodies& bodies, const IceProperties& ice, const StepMotion& motion);

  /// Floes that the loads noted since the last call break, their means taken over `step` [s], in the order of their
  /// ids. A floe loaded at several places breaks at the one that is worst.
  std::vector<FloeBreak> take_breaks(const Bodies& bodies, const IceProperties& ice, double step);

  /// Pieces, all of whose floes are gone, inherit what loads below the strength did to these.
  void follow(const Bodies& bodies, const std::vector<NewPiece>& pieces);

  /// Largest damage D of the places of a floe, 0 without <damage>.
  double damage(std::int64_t floe) const;

  void save(StateWriter out) const;
  void restore(const StateReader& in);

 private:
  static IceAtContact ice_at(const Bodies& bodies, const IceProperties& ice, std::size_t b, const Vec2& x,
                             const LocalIce* around);
  std::vector<Failure> ways_under(const EdgeContact& contact, std::int64_t floe, const std::vector<Vec2>& outline,
                                  const IceAtContact& ice);

  FailureRules rules_;
  std::optional<IceDamage> damage_;
  std::map<std::int64_t, std::vector<PointLoad>> loads_;  ///< by floe; forces as impulses [N s]
};

}  // namespace nilas
