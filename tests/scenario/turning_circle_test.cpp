/// The shipped turning circle of KVLCC2, through the whole program.
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "tests/support/program.h"

namespace turning_circle_test {

using namespace nilas_test;

/// Advance 2.974 L and tactical diameter 3.001 L by an independent integration of the same coefficients; within 2 %.
/// The terminal states the limits of the IMO beside them, and the vessel of 3.2e8 kg keeps its accounts.
TEST(TurningCircle, IsThatOfTheCoefficients) {
  const ScratchFolder folder;
  const auto result =
      run_nilas("run '" + shipped_scene("turning-circle.xml").string() + "' --out run --until 400", folder.path());
  ASSERT_EQ(result.exit_code, 0) << result.err;
  const auto summary = nlohmann::json::parse(read_text(folder.path() / "run/summary.json"));
  const auto& figures = summary.at("figures").at("manoeuvre");
  EXPECT_NEAR(figures.at("advance_m").get<double>() / 320, 2.974, 0.02 * 2.974);
  EXPECT_NEAR(figures.at("tactical_diameter_m").get<double>() / 320, 3.001, 0.02 * 3.001);
  EXPECT_NE(result.out.find("IMO at most 4.5 L"), std::string::npos) << result.out;
  const Table steps(folder.path() / "run" / "steps.csv");
  const std::size_t last = steps.rows() - 1;
  EXPECT_LE(std::abs(steps["imbalance_J"][last]), 1e-10 * steps["kinetic_J"][0]);
  EXPECT_NEAR(steps["rudder_deg"][last], 35, 1e-9);
}

}  // namespace turning_circle_test
