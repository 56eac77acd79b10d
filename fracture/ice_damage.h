#pragma once
/// Damage of ice by loads below its strength, summed where they act. docs/theory/fracture-breaking.md
#include <cstdint>
#include <map>
#include <vector>

#include "core/base/math.h"
#include "core/base/state.h"

namespace nilas {

struct DamageRule {
  double exponent = 13.5;  ///< m of N = S^-m loads of a share S of the strength that break [-]
  double endurance = 0.6;  ///< shares below it do no harm [-]
};

/// A load counts once, with its largest share S, from where it rises to the endurance until it falls below: then it
/// adds S^m to the damage D of its place [Miner 1945]. Ice of damage D bears 1 - D of its strength, a thousandth at
/// least.
class IceDamage {
 public:
  /// Throws ContractError unless the exponent is positive and the endurance within 0 to 1.
  explicit IceDamage(const DamageRule& rule);

  double endurance() const { return rule_.endurance; }
  /// D at a place in the frame of a floe, named by its id: the largest within `reach` [m], 0 where nothing was loaded.
  double at(std::int64_t floe, const Vec2& place, double reach) const;
  /// A share of the strength that is borne in this step. It belongs to the nearest place within `reach` [m] that was
  /// loaded before.
  void load(std::int64_t floe, const Vec2& place, double reach, double share);
  /// Loads that this step does not name, or named below the endurance, have ended.
  void end_step();

  /// A piece of the floe, its frame moved by `place` [m], has the damage within `radius` [m] of its centre.
  void hand_on(std::int64_t floe, std::int64_t piece, const Vec2& place, double radius);
  void forget(std::int64_t floe) { marks_.erase(floe); }

  void save(StateWriter out) const;
  /// Throws InputError for a state that is not whole.
  void restore(const StateReader& in);

 private:
  struct Mark {
    Vec2 place = Vec2::Zero();  ///< [m]
    double damage = 0;
    double peak = 0;  ///< of the load that has not ended, 0 without one
    bool is_loaded = false;
  };

  DamageRule rule_;
  std::map<std::int64_t, std::vector<Mark>> marks_;  ///< by floe
};

}  // namespace nilas
