#pragma once
/// Damage of ice by loads below its strength, summed at the places where they act. docs/theory/fracture-breaking.md
#include <cstdint>
#include <map>
#include <vector>

#include "core/base/math.h"
#include "core/base/state.h"

namespace nilas::fracture {

struct DamageRule {
  double exponent = 13.5;  ///< m: N = S^-m loads of the share S of the strength break the ice [-].
  double endurance = 0.6;  ///< Loads of a smaller share do no harm [-].
};

/// The damage D of the loaded places of all floes. A load lasts from where its share S of the strength rises to the
/// endurance until it falls below. It counts once, with its largest S: it adds S^m to D at its place, a linear sum as
/// in Miner (1945). Ice of damage D bears 1 - D of its strength, at least a thousandth.
class IceDamage {
 public:
  /// Throws ContractError unless the exponent is positive and 0 < endurance <= 1.
  explicit IceDamage(const DamageRule& rule);

  double endurance() const { return rule_.endurance; }
  /// The largest D within `reach` [m] of a place in the frame of the floe with this id, 0 where nothing was loaded.
  double at(std::int64_t floe, const Vec2& place, double reach) const;
  /// Notes that the ice bears a load of this share of its strength in this step. The load belongs to the nearest place
  /// within `reach` [m] that was loaded before, else to a new one.
  void load(std::int64_t floe, const Vec2& place, double reach, double share);
  /// Ends the loads that this step did not note, or noted below the endurance.
  void end_step();

  /// Gives a piece of the floe the damage within `radius` [m] of its centre. Its frame is moved by `place` [m].
  void hand_on(std::int64_t floe, std::int64_t piece, const Vec2& place, double radius);
  void forget(std::int64_t floe) { marks_.erase(floe); }

  void save(StateWriter out) const;
  /// Throws InputError for an incomplete state.
  void restore(const StateReader& in);

 private:
  struct Mark {
    Vec2 place = Vec2::Zero();  ///< [m]
    double damage = 0;
    double peak = 0;  ///< Largest share S of the present load; 0 without one.
    bool is_loaded = false;
  };

  DamageRule rule_;
  std::map<std::int64_t, std::vector<Mark>> marks_;  ///< The loaded places by the id of the floe.
};

}  // namespace nilas::fracture
