#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <complex>
#include <string>
#include <vector>

#include "tests/support/csv_table.h"

namespace oes_sphere_test {

using namespace nilas;

/// Linear interpolation in a column over the rising frequencies.
double at(const test::Table& table, const std::string& column, double w) {
  const auto& x = table["frequency_rad_s"];
  const auto& y = table[column];
  const auto above = static_cast<std::size_t>(std::upper_bound(x.begin(), x.end(), w) - x.begin());
  const double share = (w - x[above - 1]) / (x[above] - x[above - 1]);
  return (1 - share) * y[above - 1] + share * y[above];
}

/// The heave of the sphere in the ten regular waves of the task, in the frequency domain: |X| / |C - w^2 (m + A) + i w
/// (B + damper)| with C = pi R^2 rho g. Of 30 waves, with and without damper, 22 are within the spread of the five
/// programs. The others are at most 0.11 % outside: the longest wave without damper is below, seven with a damper are
/// above. Nowhere does it differ by more than 1.1 % from InWave with HOTINT.
TEST(OesSphere, RegularWavesAreWithinTheSpreadOfThePrograms) {
  const std::string folder = std::string(NILAS_SOURCE_DIR) + "/tests/data/hydro/oes-sphere/";
  const test::Table heave(folder + "heave.csv"), published(folder + "responses.csv");
  constexpr double k_mass = 261.8e3, k_radius = 5, k_weight = 9810, k_margin = 1.1e-3;
  constexpr double k_pi = 3.14159265358979323846;
  const std::vector<std::string> programs{"inwave_hotint", "inwave_linear", "marin_nonlinear", "nrel_nonlinear",
                                          "proteusds_linear"};
  const auto& periods = published["period_s"];
  int inside = 0;
  ASSERT_EQ(periods.size(), 30u);
  for (std::size_t row = 0; row < periods.size(); ++row) {
    const double w = 2 * k_pi / periods[row];
    const std::complex<double> force(at(heave, "excitation_re_N_m", w), at(heave, "excitation_im_N_m", w));
    const std::complex<double> stiffness(
        k_pi * k_radius * k_radius * k_weight - w * w * (k_mass + at(heave, "added_mass_kg", w)),
        w * (at(heave, "damping_Ns_m", w) + published["damper_Ns_m"][row]));
    const double response = std::abs(force / stiffness);
    std::vector<double> others;
    for (const std::string& program : programs) others.push_back(published[program][row]);
    const auto [low, high] = std::minmax_element(others.begin(), others.end());
    inside += response >= *low && response <= *high ? 1 : 0;
    EXPECT_GT(response, *low * (1 - k_margin)) << row;
    EXPECT_LT(response, *high * (1 + k_margin)) << row;
    EXPECT_NEAR(response / published["inwave_hotint"][row], 1, 0.011) << row;
  }
  EXPECT_EQ(inside, 22);
}

/// In the wave of 11 s the response is 1.0071 by linear theory, and all five programs lie above: the lowest by 0.07 %.
/// This does not rest on the excitation of the file: Haskind's relation gives it by the damping alone, in deep water
/// |X|^2 = 2 rho g^3 B / w^3. That wave has w^2 R/g = 0.17. Added mass and damping of the file, over the displaced
/// mass, agree with Hulme (1982) at 0.2 and 0.3.
TEST(OesSphere, TheLongestWaveIsBelowAllProgramsByTheoryAsWell) {
  const std::string folder = std::string(NILAS_SOURCE_DIR) + "/tests/data/hydro/oes-sphere/";
  const test::Table heave(folder + "heave.csv"), published(folder + "responses.csv");
  constexpr double k_pi = 3.14159265358979323846, k_density = 1000, k_gravity = 9.81, k_radius = 5, k_mass = 261.8e3;
  const double displaced = 2.0 / 3 * k_pi * k_density * std::pow(k_radius, 3);
  struct HulmesRow {
    double number, added_mass, damping;
  };
  for (const HulmesRow& row : {HulmesRow{0.2, 0.7938, 0.2793}, HulmesRow{0.3, 0.7157, 0.3254}}) {
    const double w = std::sqrt(row.number * k_gravity / k_radius);
    EXPECT_NEAR(at(heave, "added_mass_kg", w) / displaced, row.added_mass, 5e-4);
    EXPECT_NEAR(at(heave, "damping_Ns_m", w) / displaced / w, row.damping, 5e-4);
  }
  constexpr double k_period = 11;
  const double w = 2 * k_pi / k_period, damping = at(heave, "damping_Ns_m", w);
  const double force = std::sqrt(2 * k_density * std::pow(k_gravity, 3) * damping / std::pow(w, 3));
  const double stiffness = k_pi * k_radius * k_radius * k_density * k_gravity;
  const double response = force / std::hypot(stiffness - w * w * (k_mass + at(heave, "added_mass_kg", w)), w * damping);
  EXPECT_NEAR(response, 1.0071, 2e-4);
  for (std::size_t row = 0; row < published["period_s"].size(); ++row) {
    if (published["period_s"][row] != k_period || published["damper_Ns_m"][row] != 0) continue;
    for (const char* const program :
         {"inwave_hotint", "inwave_linear", "marin_nonlinear", "nrel_nonlinear", "proteusds_linear"})
      EXPECT_GT(published[program][row], response + 4e-4) << program;
  }
}

}  // namespace oes_sphere_test
