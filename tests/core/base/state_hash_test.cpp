#include <gtest/gtest.h>

#include "core/base/hash.h"
#include "core/base/math.h"

namespace nilas {
namespace state_hash_test {

std::uint64_t hash_of(const Vec3& v) {
  StateHash hash;
  hash.add_vector(v);
  return hash.value();
}

TEST(StateHash, SameNumbersSameHash) { EXPECT_EQ(hash_of({0.1, -2, 1e300}), hash_of({0.1, -2, 1e300})); }

TEST(StateHash, TheLastBitTheOrderAndTheSignOfZeroCount) {
  const auto reference = hash_of({0.1, 2, 0});
  EXPECT_NE(hash_of({std::nextafter(0.1, 1), 2, 0}), reference);
  EXPECT_NE(hash_of({2, 0.1, 0}), reference);
  EXPECT_NE(hash_of({0.1, 2, -0.0}), reference);
}

TEST(StateHash, VectorsAreTheirNumbersInTurn) {
  StateHash single;
  for (const double x : {0.1, 2.0, 3.0}) single.add(x);
  EXPECT_EQ(single.value(), hash_of({0.1, 2, 3}));
}

}  // namespace state_hash_test
}  // namespace nilas
