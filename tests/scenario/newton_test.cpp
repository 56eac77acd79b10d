/// Checks Newton's law for the towed ship from vessel.csv and summary.json alone, as a spreadsheet could:
///   m (v_k+1 - v_k)/h = contact + hydro + carriage + weight
///   L_k+1 - L_k = h (sum of torques about the centre of mass),  L = R I R^T w with each row's own R
#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <cmath>
#include <nlohmann/json.hpp>

#include "tests/scenario/vessel_rows.h"
#include "tests/support/program.h"

namespace newton_test {

using namespace nilas_test;
using Eigen::Matrix3d;
using Eigen::Vector3d;

void verify_newton(const fs::path& run, double h) {
  const Table t(run / "vessel.csv");
  const auto summary = nlohmann::json::parse(read_text(run / "summary.json"));
  const double m = summary["vessel"]["mass_kg"];
  const auto i = summary["vessel"]["inertia_kg_m2"].get<std::vector<double>>();
  Matrix3d I;
  I << i[0], i[3], i[4], i[3], i[1], i[5], i[4], i[5], i[2];
  double worst_force = 0, worst_torque = 0;
  for (std::size_t k = 1; k < t.rows(); ++k) {
    const Vector3d contact = vector_in_row(t, "contact_f", "_N", k), hydro = vector_in_row(t, "hydro_f", "_N", k),
                   carriage = vector_in_row(t, "carriage_f", "_N", k), weight(0, 0, -9.81 * m);
    const Vector3d momentum = m / h * (vector_in_row(t, "v", "_m_s", k) - vector_in_row(t, "v", "_m_s", k - 1));
    const double scale = std::max({contact.norm(), hydro.norm(), carriage.norm(), weight.norm(), momentum.norm()});
    worst_force = std::max(worst_force, (contact + hydro + carriage + weight - momentum).norm() / scale);

    const auto L = [&](std::size_t row) -> Vector3d {
      const Matrix3d R = attitude(t, row);
      return R * I * R.transpose() * vector_in_row(t, "w", "_rad_s", row);
    };
    const Vector3d contact_m = vector_in_row(t, "contact_m", "_Nm", k), hydro_m = vector_in_row(t, "hydro_m", "_Nm", k),
                   hull_m = vector_in_row(t, "hull_m", "_Nm", k), spin = (L(k) - L(k - 1)) / h;
    const double scale_m = std::max({contact_m.norm(), hydro_m.norm(), hull_m.norm(), spin.norm()});
    worst_torque = std::max(worst_torque, (contact_m + hydro_m + hull_m - spin).norm() / scale_m);
    // The columns hold the same force, and its moment moved from the joint to the centre of mass.
    EXPECT_NEAR((carriage - vector_in_row(t, "hull_f", "_N", k)).norm(), 0, 1e-9 * (1 + carriage.norm()));
  }
  EXPECT_LE(worst_force, 1e-6);
  EXPECT_LE(worst_torque, 1e-6);
}

/// Cases: theta 1/2, 1 and one value between; cells on a ramp, and free axes that turn.
TEST(Newton, Moreau) {
  for (const std::string theta : {"0.5", "1", "0.7"}) {
    const ScratchFolder folder;
    const std::string options = " --quiet --out run --set contact/@integrator=moreau --set contact/@theta=" + theta;
    const auto towed =
        run_nilas("run '" + shipped_scene("towing.xml").string() + "' --until 3" + options, folder.path());
    ASSERT_EQ(towed.exit_code, 0) << towed.err;
    verify_newton(folder.path() / "run", 0.01);
    const auto oblique = run_nilas("run '" + shipped_scene("oblique-towing.xml").string() +
                                       "' --until 2 --force --set 'vessel/carriage/@free=heave roll pitch'" + options,
                                   folder.path());
    ASSERT_EQ(oblique.exit_code, 0) << oblique.err;
    verify_newton(folder.path() / "run", 0.01);
  }
}

TEST(Newton, TowingScene) {
  const ScratchFolder folder;
  const auto result =
      run_nilas("run '" + shipped_scene("towing.xml").string() + "' --quiet --out run --until 5", folder.path());
  ASSERT_EQ(result.exit_code, 0) << result.err;
  verify_newton(folder.path() / "run", 0.01);
}

TEST(Newton, ObliqueTowingScene) {
  const ScratchFolder folder;
  const auto result = run_nilas(
      "run '" + shipped_scene("oblique-towing.xml").string() + "' --quiet --out run --until 4", folder.path());
  ASSERT_EQ(result.exit_code, 0) << result.err;
  verify_newton(folder.path() / "run", 0.01);
}

}  // namespace newton_test
