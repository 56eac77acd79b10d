/// A mirror-symmetric scene must move symmetrically. Rounding grows, so the bound widens with time, unless rounding is
/// the same on the two sides.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <set>
#include <utility>
#include <vector>

#include "tests/support/program.h"

namespace mirror_test {

using namespace nilas_test;

TEST(Mirror, PairsOfFloesStayImages) {
  const ScratchFolder folder;
  const auto result = run_nilas(
      "run '" + shipped_scene("mirror-25.xml").string() + "' --solver auto --quiet --out run --until 5", folder.path());
  ASSERT_EQ(result.exit_code, 0) << result.err;
  const Table bodies(folder.path() / "run/bodies.csv");
  std::map<std::string, std::map<double, std::size_t>> rows;
  for (std::size_t i = 0; i < bodies.rows(); ++i) rows[bodies.text("name")[i]][bodies["time_s"][i]] = i;
  const auto yaw = [&](std::size_t i) {
    const double w = bodies["qw"][i], x = bodies["qx"][i], y = bodies["qy"][i], z = bodies["qz"][i];
    return std::atan2(2 * (x * y + w * z), w * w + x * x - y * y - z * z);
  };
  std::map<double, double> worst;  // Largest asymmetry by time.
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

/// Compares every column of every row over the scene's whole length.
void expect_images_to_the_last_bit(const std::string& flags, bool every_step_converges) {
  const ScratchFolder folder;
  const auto result =
      run_nilas("run '" + shipped_scene("mirror-25.xml").string() + "' --quiet --out run " + flags, folder.path());
  ASSERT_EQ(result.exit_code, 0) << result.err;
  const Table bodies(folder.path() / "run/bodies.csv");
  const std::set<std::string> turned{"y_m", "qx", "qz", "vy_m_s", "wx_rad_s", "wz_rad_s"};
  const std::vector<std::string> columns{"x_m",    "y_m",    "z_m",    "qw",       "qx",       "qy",      "qz",
                                         "vx_m_s", "vy_m_s", "vz_m_s", "wx_rad_s", "wy_rad_s", "wz_rad_s"};
  std::map<std::pair<std::string, double>, std::size_t> rows;
  for (std::size_t i = 0; i < bodies.rows(); ++i) rows[{bodies.text("name")[i], bodies["time_s"][i]}] = i;
  double moved = 0, end = 0;
  for (const auto& [key, p] : rows) {
    const auto& [name, t] = key;
    if (name.rfind("port ", 0) != 0) continue;
    const std::size_t s = rows.at({"starboard " + name.substr(5), t});
    for (const auto& column : columns) {
      const double image = turned.count(column) > 0 ? -bodies[column][s] : bodies[column][s];
      EXPECT_EQ(bodies[column][p], image) << name << ' ' << column << " at " << t;
    }
    moved = std::max(moved, std::abs(bodies["vx_m_s"][p]));
    end = std::max(end, t);
  }
  EXPECT_GT(moved, 0.05) << "no floe was pushed, so nothing was tested";
  EXPECT_NEAR(end, 10, 1e-9);
  const Table steps(folder.path() / "run/steps.csv");
  EXPECT_EQ(steps.rows(), 1000u);
  for (const std::string& status : steps.text("status")) EXPECT_TRUE(!every_step_converges || status == "converged");
  const Table vessel(folder.path() / "run/vessel.csv");
  for (const char* load : {"contact", "hydro", "carriage"})
    for (const char* part : {"_fy_N", "_mx_Nm", "_mz_Nm"})
      for (const double x : vessel[load + std::string(part)]) EXPECT_EQ(x, 0) << load << part;
  const auto& ahead = vessel["contact_fx_N"];
  EXPECT_LT(*std::min_element(ahead.begin(), ahead.end()), -1);
}

TEST(Mirror, PairsOfFloesAreImagesToTheLastBitAsShipped) { expect_images_to_the_last_bit("", true); }

TEST(Mirror, OrderFreeSumsKeepPairsOfFloesImagesToTheLastBit) {
  expect_images_to_the_last_bit("--solver eg-order-free", false);
}

}  // namespace mirror_test
