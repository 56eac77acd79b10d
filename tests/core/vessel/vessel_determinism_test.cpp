/// Same input, same bits: run twice, and in two threads at once.
#include <gtest/gtest.h>

#include <thread>

#include "core/base/hash.h"
#include "tests/core/vessel/example_vessel.h"

namespace nilas::vessel {
namespace vessel_determinism_test {

VesselModel model_of(int kind) {
  const std::array<bool, 6> free{false, false, true, true, true, false};
  if (kind == 0) return example::vessel();
  if (kind == 1) return example::carried(BalanceKind::rigid, free);
  if (kind == 2) return example::carried(BalanceKind::six_cells, free);
  constexpr int k_kinds = 3;
  VesselModel model = model_of(kind - k_kinds);
  model.theta = 0.5;
  return model;
}

std::uint64_t hash_of_run(int kind) {
  VesselSystem system(model_of(kind), 0);
  RandomStream random(8, "determinism");
  StateHash hash;
  for (int i = 0; i < 500; ++i) {
    const VesselBlock block =
        example::step(system, example::random_wrench(random, 100), 0.01, example::random_wrench(random, 1));
    hash.add_vector(block.f);
    hash.add_vector(system.coordinates());
    hash.add_vector(system.state().pose.q.coeffs());
    hash.add_vector(system.carriage_loads().about_joint.torque);
  }
  return hash.value();
}

class VesselDeterminism : public testing::TestWithParam<int> {};

TEST_P(VesselDeterminism, SameBitsTwiceAndInTwoThreads) {
  const std::uint64_t wanted = hash_of_run(GetParam());
  EXPECT_EQ(hash_of_run(GetParam()), wanted);
  for (int repeat = 0; repeat < 5; ++repeat) {
    std::uint64_t a = 0, b = 0;
    std::thread first([&] { a = hash_of_run(GetParam()); });
    std::thread second([&] { b = hash_of_run(GetParam()); });
    first.join();
    second.join();
    EXPECT_EQ(a, wanted);
    EXPECT_EQ(b, wanted);
  }
}

INSTANTIATE_TEST_SUITE_P(Kinds, VesselDeterminism, testing::Range(0, 6));

TEST(VesselSystemValue, MovesKeepTheState) {
  VesselSystem a(model_of(2), 0);
  example::run(a, {{10, 0, 0}, Vec3::Zero()}, 0.01, 10);
  const VecX coordinates = a.coordinates();
  VesselSystem b(std::move(a));
  EXPECT_EQ(b.coordinates(), coordinates);
  VesselSystem c(model_of(0), 0);
  c = std::move(b);
  EXPECT_EQ(c.coordinates(), coordinates);
  example::run(c, {}, 0.01, 1);
}

}  // namespace vessel_determinism_test
}  // namespace nilas::vessel
