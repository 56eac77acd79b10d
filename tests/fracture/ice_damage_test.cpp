#include "fracture/ice_damage.h"

#include <gtest/gtest.h>

#include <cmath>

#include "core/base/error.h"

namespace nilas::fracture {
namespace ice_damage_test {

const Vec2 k_place(3, 1);

/// Loads up to `peak` and down again, in steps.
void load_once(IceDamage& damage, double peak, const Vec2& place = k_place, std::int64_t floe = 7) {
  for (const double share : {0.3 * peak, 0.8 * peak, peak, 0.9 * peak, 0.1 * peak, 0.0}) {
    damage.load(floe, place, 0.5, share);
    damage.end_step();
  }
}

TEST(IceDamage, EveryLoadCountsOnceByItsPeak) {
  IceDamage damage({4, 0.5});
  for (int k = 1; k <= 3; ++k) {
    load_once(damage, 0.6);
    EXPECT_NEAR(damage.at(7, k_place, 0.5), k * std::pow(0.6, 4), 1e-15);
  }
  load_once(damage, 0.7);
  EXPECT_NEAR(damage.at(7, k_place, 0.5), 3 * std::pow(0.6, 4) + std::pow(0.7, 4), 1e-15);
  load_once(damage, 0.499);
  EXPECT_NEAR(damage.at(7, k_place, 0.5), 3 * std::pow(0.6, 4) + std::pow(0.7, 4), 1e-15) << "below the endurance";
  EXPECT_EQ(damage.at(8, k_place, 0.5), 0);
}

/// However finely the steps resolve it.
TEST(IceDamage, ALoadThatStaysIsOne) {
  IceDamage damage({4, 0.5});
  for (int k = 0; k < 1000; ++k) {
    damage.load(7, k_place, 0.5, 0.6 + 0.05 * std::sin(0.1 * k));
    damage.end_step();
    EXPECT_EQ(damage.at(7, k_place, 0.5), 0);
  }
  damage.end_step();
  EXPECT_NEAR(damage.at(7, k_place, 0.5), std::pow(0.65, 4), 1e-4);
}

TEST(IceDamage, StaysWhereItIs) {
  IceDamage damage({4, 0.5});
  load_once(damage, 0.6);
  load_once(damage, 0.8, k_place + Vec2(0.4, 0));  // within reach: the same place
  load_once(damage, 0.9, k_place + Vec2(0, 2));
  const double first = std::pow(0.6, 4) + std::pow(0.8, 4);
  EXPECT_NEAR(damage.at(7, k_place, 0.1), first, 1e-15);
  EXPECT_EQ(damage.at(7, k_place + Vec2(0, 1), 0.5), 0);
  EXPECT_NEAR(damage.at(7, k_place + Vec2(0, 1), 1.5), std::pow(0.9, 4), 1e-15) << "the worst within reach";
  EXPECT_NEAR(damage.at(7, k_place + Vec2(0, 2), 0.5), std::pow(0.9, 4), 1e-15);
}

TEST(IceDamage, PiecesInheritWhatLiesInThem) {
  IceDamage damage({4, 0.5});
  load_once(damage, 0.6);
  damage.load(7, k_place, 0.5, 0.8);
  damage.end_step();
  damage.hand_on(7, 9, {2, 1}, 1.5);
  damage.hand_on(7, 10, {-5, 1}, 2);
  damage.forget(7);
  EXPECT_EQ(damage.at(7, k_place, 0.5), 0);
  EXPECT_EQ(damage.at(10, {0, 0}, 100), 0);
  EXPECT_NEAR(damage.at(9, {1, 0}, 0.1), std::pow(0.6, 4), 1e-15);
  damage.end_step();
  EXPECT_NEAR(damage.at(9, {1, 0}, 0.1), std::pow(0.6, 4) + std::pow(0.8, 4), 1e-15) << "the load that ended by it";
}

TEST(IceDamage, LeavesAThousandthAtLeast) {
  IceDamage damage({1, 0.5});
  for (int k = 0; k < 5; ++k) load_once(damage, 0.9);
  EXPECT_EQ(damage.at(7, k_place, 0.5), 0.999);
  EXPECT_THROW(IceDamage({0, 0.5}), ContractError);
  EXPECT_THROW(IceDamage({4, 1.1}), ContractError);
}

TEST(IceDamage, GoesOnFromItsState) {
  IceDamage damage({4, 0.5}), other({4, 0.5});
  load_once(damage, 0.6);
  damage.load(7, k_place, 0.5, 0.8);
  damage.end_step();
  State state;
  damage.save(StateWriter(state));
  other.restore(StateReader(state));
  for (IceDamage* one : {&damage, &other}) {
    one->load(7, k_place, 0.5, 0.7);
    one->end_step();
    one->end_step();
  }
  EXPECT_EQ(other.at(7, k_place, 0.5), damage.at(7, k_place, 0.5));
  EXPECT_NEAR(other.at(7, k_place, 0.5), std::pow(0.6, 4) + std::pow(0.8, 4), 1e-15);
}

}  // namespace ice_damage_test
}  // namespace nilas::fracture
