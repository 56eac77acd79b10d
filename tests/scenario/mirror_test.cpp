/// A mirror-symmetric scene must move symmetrically; rounding grows in it, so the bound widens with time.
#include <gtest/gtest.h>

#include <cmath>
#include <map>

#include "tests/support/program.h"

namespace {

using namespace nilas_test;

TEST(Mirror, PairsOfFloesStayImages) {
  const ScratchFolder folder;
  const auto result =
      run_nilas("run '" + shipped_scene("mirror-25.xml").string() + "' --quiet --out run --until 5", folder.path());
  ASSERT_EQ(result.exit_code, 0) << result.err;
  const Table bodies(folder.path() / "run/bodies.csv");
  std::map<std::string, std::map<double, std::size_t>> rows;
  for (std::size_t i = 0; i < bodies.rows(); ++i) rows[bodies.text("name")[i]][bodies["time_s"][i]] = i;
  const auto yaw = [&](std::size_t i) {
    const double w = bodies["qw"][i], x = bodies["qx"][i], y = bodies["qy"][i], z = bodies["qz"][i];
    return std::atan2(2 * (x * y + w * z), w * w + x * x - y * y - z * z);
  };
  std::map<double, double> worst;  // by time
  double moved = 0;
  for (int k = 1; k <= 25; ++k)
    for (const auto& [t, p] : rows.at("port " + std::to_string(k))) {
      const std::size_t s = rows.at("starboard " + std::to_string(k)).at(t);
      worst[t] = std::max({worst[t], std::abs(bodies["y_m"][p] + bodies["y_m"][s]),
                           std::abs(bodies["x_m"][p] - bodies["x_m"][s]), std::abs(yaw(p) + yaw(s))});
      moved = std::max(moved, std::abs(bodies["vx_m_s"][p]));
    }
  EXPECT_GT(moved, 0.05) << "no floe was pushed, so nothing was tested";
  for (const auto& [t, error] : worst) {
    const double bound = t <= 1.0 + 1e-9 ? 1e-12 : t <= 2.0 + 1e-9 ? 1e-4 : 0.01;
    EXPECT_LE(error, bound) << "t " << t;
  }
}

}  // namespace
