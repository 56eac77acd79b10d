/// The FPSO of MSS in regular waves: the loads of the module move it as the response amplitudes of its own file say.
#include <gtest/gtest.h>

#include <cmath>
#include <complex>
#include <memory>

#include "core/bodies/bodies.h"
#include "core/geometry/shape.h"
#include "hydro/database/read_database.h"
#include "hydro/database/response.h"
#include "hydro/waves/wave_loads.h"

namespace fpso_test {

using namespace nilas;
using namespace nilas::hydro;

const Vec3 k_centre(0.788631, 0, -1);  // of mass, frame D [m]
constexpr double k_volume = 97960.9, k_density = 1025;

Database fpso() {
  DatabaseSettings settings;
  settings.length = 1;
  settings.density = k_density;
  settings.gravity = 9.81;
  settings.volume = k_volume;
  return read_database(std::string(NILAS_SOURCE_DIR) + "/tests/data/hydro/mss/fpso.1", settings);
}

/// The hull, held with the origin of D in still water at `place` and this yaw; only its pose matters here.
bodies::Bodies hull_at(const Vec2& place, double yaw) {
  bodies::BodySpec spec;
  spec.kind = bodies::BodyKind::vessel;
  spec.shape = std::make_shared<const geometry::Shape>(geometry::box_shape({200, 44, 20}));
  spec.mass = k_density * k_volume;
  spec.inertia_B = 1e11 * Mat3::Identity();
  spec.pose.q = Quat(Eigen::AngleAxisd(yaw, Vec3::UnitZ()));
  spec.pose.p = Vec3(place.x(), place.y(), 0) + spec.pose.q * k_centre;
  bodies::Bodies bodies;
  bodies.add(spec);
  return bodies;
}

/// The steady motion about the mean place per metre of amplitude, by stepping (M + A) x'' + B x' + C x = F(t) with the
/// matrices of the frequency and the loads of the module. The average acceleration method with 400 steps per period
/// shifts the phase by less than (2 pi / 400)^2 / 12. Forty periods let what is left of the start die away.
ComplexVec6 steady_motion(const std::shared_ptr<const Database>& database, std::size_t frequency, double heading) {
  constexpr int k_periods = 40, k_steps = 400;
  constexpr double k_yaw = 0.3, k_amplitude = 0.5;
  const Vec2 place(30, -20);
  const double w = database->frequency[frequency], h = 2 * k_pi / w / k_steps;
  WaveTrain train;
  train.height = 2 * k_amplitude;
  train.period = 2 * k_pi / w;
  train.heading = heading + k_yaw;
  // The phase of the file is that of the wave over the origin of D.
  train.phase = w * w / 9.81 * place.dot(wave_direction(train.heading));
  const auto field = std::make_shared<const WaveField>(std::vector{train}, 9.81, 0.0, 0.0, 1);
  const bodies::Bodies bodies = hull_at(place, k_yaw);
  Water water;
  water.density = k_density;
  water.gravity = 9.81;
  const auto module = make_wave_loads(
      water, field, {DatabaseWaveLoads{database, -k_centre, 0, WaveDrift::none}, false, false}, bodies, 1);
  const auto load_at = [&](double t) {
    bodies::Wrenches out(1);
    module->add_forces(bodies, t, out);
    const Mat3 to_D = bodies.R_GB[0].transpose();
    Vec6 load;
    load << to_D * out[0].force, to_D * out[0].torque + k_centre.cross(to_D * out[0].force);
    return load;
  };
  const Mat6 mass = rigid_mass(k_density * k_volume, k_centre, {16.3, 54, 54}) + database->added_mass[frequency];
  const Mat6 &damping = database->damping[frequency], &stiffness = *database->restoring;
  const Eigen::PartialPivLU<Mat6> step(mass + 0.5 * h * damping + 0.25 * h * h * stiffness);
  Vec6 x = Vec6::Zero(), v = x, a = mass.partialPivLu().solve(load_at(0));
  ComplexVec6 motion = ComplexVec6::Zero();
  for (int i = 1; i <= k_periods * k_steps; ++i) {
    const double t = i * h;
    const Vec6 v_known = v + 0.5 * h * a, x_known = x + h * v + 0.25 * h * h * a;
    a = step.solve(load_at(t) - damping * v_known - stiffness * x_known);
    v = v_known + 0.5 * h * a;
    x = x_known + 0.25 * h * h * a;
    if (i > (k_periods - 1) * k_steps) motion += 2.0 / k_steps / k_amplitude * std::polar(1.0, -w * t) * x;
  }
  return motion;
}

/// Heave and pitch of the time-domain motion against the file's own response (.4): within 1 % of the largest amplitude
/// over the headings, phase included, in waves from ahead, the quarter and the beam, at periods from 7 to 20 s. The
/// hull stands away from the origin and is turned.
TEST(Fpso, MovesInRegularWavesAsItsResponseAmplitudesSay) {
  const auto database = std::make_shared<const Database>(fpso());
  ASSERT_FALSE(database->motion.empty());
  int cases = 0;
  for (std::size_t k = 0; k < database->frequency.size(); k += 5) {
    const double period = 2 * k_pi / database->frequency[k];
    if (period < 7 || period > 20) continue;
    for (std::size_t j = 0; j < database->heading.size(); j += 6) {
      const ComplexVec6 motion = steady_motion(database, k, database->heading[j]);
      for (const int mode : {2, 4}) {
        double largest = 0;
        for (const ComplexVec6& of_file : database->motion[k]) largest = std::max(largest, std::abs(of_file[mode]));
        EXPECT_LT(std::abs(motion[mode] - database->motion[k][j][mode]), 0.01 * largest)
            << "period " << period << " s, heading " << database->heading[j] / k_deg << " deg, mode " << mode + 1;
        ++cases;
      }
    }
  }
  EXPECT_GT(cases, 10);
}

}  // namespace fpso_test
