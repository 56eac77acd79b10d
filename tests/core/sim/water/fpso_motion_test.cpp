/// A whole run against a hydrodynamic database: added mass, radiation, excitation and hydrostatics of a ship of 200 m
/// in regular waves give the motions that the potential-flow program itself wrote to its file .4.
#include <gtest/gtest.h>

#include <cmath>
#include <complex>
#include <string>

#include "hydro/database/read_database.h"
#include "tests/core/sim/scene_rig.h"

namespace fpso_motion_test {

using namespace nilas;
using namespace nilas::sim;

const std::filesystem::path k_files = std::filesystem::path(NILAS_SOURCE_DIR) / "tests/data/hydro/mss/fpso.1";

/// The ship of the file: rho V of displacement, centre of mass at (0.788631, 0, -1) m, radii of gyration 16.3, 54 and
/// 54 m about the axes through the origin. The hull's mesh is a box with a bow; nothing of its water is used.
std::string ship_in_waves(double period, double heading_deg, const std::string& model, double step) {
  const double mass = 1025 * 97960.9;
  const Vec3 com(0.788631, 0, -1);
  const Mat3 at_origin = mass * Vec3(16.3 * 16.3, 54.0 * 54.0, 54.0 * 54.0).asDiagonal();
  const Mat3 inertia = at_origin - mass * (com.squaredNorm() * Mat3::Identity() - com * com.transpose());
  const auto number = [](double x) { return test::text(x); };
  return test::steps_of(step) +
         "<contact integrator='moreau'/><water density='1025'><waves kind='regular' height='0.02' period='" +
         number(period) + "' heading_deg='" + number(heading_deg) + "' ramp='" + number(5 * period) +
         "'/></water><hydro><buoyancy/><restoring/><added_mass floes='none' vessel='database'/><radiation model='" +
         model + "'/><wave_loads vessel='database' floes='none'/><database file='" + k_files.string() +
         "' length='1' density='1025' gravity='9.81' origin='100 0 12'/></hydro>"
         "<vessel name='fpso' position='-100 0 -12'><hull generate='wedge' length='200' beam='44' draught='12' "
         "depth='20' "
         "bow_length='20'/><mass value='" +
         number(mass) + "' cog='" + number(100 + com.x()) + " 0 11' inertia='" + number(inertia(0, 0)) + " " +
         number(inertia(1, 1)) + " " + number(inertia(2, 2)) + " 0 " + number(inertia(0, 2)) + " 0'/></vessel>";
}

/// The complex amplitude of heave of D's origin per metre of wave, over the last `periods` of a run.
std::complex<double> heave_response(double period, double heading_deg, const std::string& model) {
  const double step = period / 200, w = 2 * k_pi / period;
  test::SceneRig rig(ship_in_waves(period, heading_deg, model, step));
  const Vec3 from_com(-0.788631, 0, 1);
  std::complex<double> sum = 0;
  const int before = 200 * 40, during = 200 * 10;
  for (int k = 1; k <= before + during; ++k) {
    rig.simulation.step();
    if (k <= before) continue;
    const double z = rig.bodies().p_GB[0].z() + (rig.bodies().R_GB[0] * from_com).z();
    sum += z * std::exp(std::complex<double>(0, -w * k * step));
  }
  return 2.0 * sum / double(during) / 0.01;
}

class Fpso : public testing::TestWithParam<std::string> {};

TEST_P(Fpso, HeavesAsItsFileSays) {
  hydro::DatabaseSettings settings;
  settings.length = 1;
  settings.density = 1025;
  settings.gravity = 9.81;
  const hydro::Database database = hydro::read_database(k_files, settings);
  ASSERT_FALSE(database.motion.empty());
  for (const auto& [wanted, heading_deg] : {std::pair{9.49, 180.0}, {13.9, 90.0}, {20.5, 30.0}}) {
    std::size_t nearest = 0;
    for (std::size_t k = 0; k < database.frequency.size(); ++k)
      if (std::abs(2 * k_pi / database.frequency[k] - wanted) <
          std::abs(2 * k_pi / database.frequency[nearest] - wanted))
        nearest = k;
    std::size_t heading = 0;
    while (std::abs(database.heading[heading] - heading_deg * k_pi / 180) > 1e-6) ++heading;
    const double period = 2 * k_pi / database.frequency[nearest];
    const std::complex<double> of_file = database.motion[nearest][heading][2];
    const std::complex<double> of_run = heave_response(period, heading_deg, GetParam());
    EXPECT_NEAR(std::abs(of_run), std::abs(of_file), 0.01 * std::abs(of_file) + 1e-3) << period << " s";
    EXPECT_LT(std::abs(of_run - of_file), 0.02 * std::abs(of_file) + 2e-3) << period << " s " << of_run << of_file;
  }
}

INSTANTIATE_TEST_SUITE_P(Models, Fpso, testing::Values("convolution", "state-space"), [](const auto& model) {
  return model.param == "convolution" ? "convolution" : "state_space";
});

}  // namespace fpso_motion_test
