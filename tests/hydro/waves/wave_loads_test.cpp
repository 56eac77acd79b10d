#include "hydro/waves/wave_loads.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <complex>

#include "core/base/error.h"
#include "core/bodies/bodies.h"
#include "core/geometry/shape.h"
#include "hydro/database/wave_number.h"
#include "hydro/modules.h"
#include "hydro/waves/wave_surface.h"
#include "hydro/wet_body.h"
#include "tests/hydro/waves/synthetic_database.h"

namespace wave_loads_test {

using namespace nilas;
using namespace nilas::hydro;

Water sea() {
  Water water;
  water.density = 1000;
  water.gravity = 9.81;
  return water;
}

std::shared_ptr<const WaveField> regular_field(double height, double period, double heading = 0) {
  WaveTrain train;
  train.height = height;
  train.period = period;
  train.heading = heading;
  return std::make_shared<const WaveField>(std::vector{train}, sea().gravity, 0.0, 0.0, 1);
}

void add_box(bodies::Bodies& bodies, bodies::BodyKind kind, const Vec3& size, double density, const Vec3& p) {
  bodies::BodySpec spec;
  spec.kind = kind;
  spec.shape = std::make_shared<const geometry::Shape>(geometry::box_shape(size));
  spec.mass = density * size.prod();
  const Vec3 squares = size.cwiseProduct(size);
  constexpr double k_twelfth = 1.0 / 12;  // of a uniform box
  spec.inertia_B = k_twelfth * spec.mass *
                   Vec3(squares.y() + squares.z(), squares.x() + squares.z(), squares.x() + squares.y()).asDiagonal();
  spec.pose.p = p;
  bodies.add(spec);
}

bodies::Wrenches loads_of(bodies::ForceModule& module, const bodies::Bodies& bodies, double t) {
  bodies::Wrenches out(static_cast<std::size_t>(bodies.size()));
  module.add_forces(bodies, t, out);
  return out;
}

/// Without waves nothing is added, to the last bit.
TEST(WaveLoads, AddNothingWithoutWaves) {
  bodies::Bodies bodies;
  add_box(bodies, bodies::BodyKind::floe, {1, 1, 0.1}, 900, {0, 0, 0.01});
  bodies::Wrenches out{{Vec3(0.1, 0.2, 0.3), Vec3(0.4, 0.5, 0.6)}};
  const auto module = make_wave_loads(sea(), regular_field(0, 5), {{}, true, true}, bodies, 1);
  module->add_forces(bodies, 1, out);
  EXPECT_EQ(out[0].force, Vec3(0.1, 0.2, 0.3));
  EXPECT_EQ(out[0].torque, Vec3(0.4, 0.5, 0.6));
}

/// A floe of 1 m in a wave 156 m long and 0.2 m high follows the water: 0.1 cos(w t) in heave and the orbital motion
/// -0.1 sin(w t) forward, as buoyancy and Froude-Krylov pressure carry it. It starts on its orbit. Amplitude and
/// phase over the third wave, by projection on cosine and sine, agree within 1 %; pitch follows the slope within 3 % of
/// it, since its own oscillation is not damped.
TEST(WaveLoads, ASmallFloeFollowsALongWave) {
  constexpr double k_period = 10, k_step = 0.01, k_amplitude = 0.1;
  const double w = 2 * k_pi / k_period, number = w * w / sea().gravity;
  bodies::Bodies bodies;
  add_box(bodies, bodies::BodyKind::floe, {1, 1, 0.1}, 900, {0, 0, 0.1 * (0.5 - 0.9) + k_amplitude});
  const double rest = 0.1 * (0.5 - 0.9);
  bodies.v_GB[0] = {k_amplitude * w, 0, 0};
  const auto buoyancy = make_buoyancy(sea(), 1);
  const auto waves = make_wave_loads(sea(), regular_field(2 * k_amplitude, k_period), {{}, false, true}, bodies, 1);
  std::array<Vec2, 3> heave_surge_pitch{Vec2::Zero(), Vec2::Zero(), Vec2::Zero()};
  const int steps = static_cast<int>(std::lround(k_period / k_step));
  double drift = 0;
  for (int i = 0; i < 3 * steps; ++i) {
    const double t = i * k_step;
    bodies::Wrenches out = loads_of(*waves, bodies, t);
    buoyancy->add_forces(bodies, t, out);
    bodies.v_GB[0] += k_step * (out[0].force / bodies.mass[0] - Vec3(0, 0, sea().gravity));
    bodies.w_GB[0] += k_step * bodies.inertia_inverse_G(0) * out[0].torque;
    const Vec3 turn = k_step * bodies.w_GB[0];
    const Quat spin = Quat(Eigen::AngleAxisd(turn.norm(), turn.norm() > 0 ? Vec3(turn.normalized()) : Vec3::UnitX()));
    bodies.set_pose(0, bodies.p_GB[0] + k_step * bodies.v_GB[0], spin * bodies.q_GB[0]);
    if (i < 2 * steps) continue;
    const double now = t + k_step;
    const Vec2 phase(std::cos(w * now), std::sin(w * now));
    if (i == 2 * steps) drift = bodies.p_GB[0].x() + k_amplitude * phase.y();
    heave_surge_pitch[0] += 2.0 / steps * (bodies.p_GB[0].z() - rest) * phase;
    heave_surge_pitch[1] += 2.0 / steps * (bodies.p_GB[0].x() - drift) * phase;
    heave_surge_pitch[2] += 2.0 / steps * -bodies.R_GB[0](2, 0) * phase;
  }
  EXPECT_LT((heave_surge_pitch[0] - Vec2(k_amplitude, 0)).norm(), 0.01 * k_amplitude);
  EXPECT_LT((heave_surge_pitch[1] - Vec2(0, k_amplitude)).norm(), 0.01 * k_amplitude);
  // The surface's slope is a k sin(w t - k x), and bow down is positive.
  EXPECT_LT((heave_surge_pitch[2] - Vec2(0, -k_amplitude * number)).norm(), 0.03 * k_amplitude * number);
}

/// The water that moves with a floe is pushed as the water around it: A (a; r) in the axes of G, here of a floe that
/// has turned by 0.5 rad, with the accelerations of the wave at its centre of mass.
TEST(WaveLoads, PushTheAddedMassOfFloes) {
  bodies::Bodies bodies;
  add_box(bodies, bodies::BodyKind::floe, {1, 1, 0.1}, 900, {2, 0, -0.05});
  bodies.set_pose(0, bodies.p_GB[0], Quat(Eigen::AngleAxisd(0.5, Vec3::UnitZ())));
  const auto field = regular_field(0.2, 5, 0.3);
  const auto module = make_wave_loads(sea(), field, {{}, false, true}, bodies, 1);
  const Wrench before = loads_of(*module, bodies, 0.7)[0];
  Vec6 diagonal;
  diagonal << 10, 20, 300, 4, 5, 0;
  const Mat6 added = diagonal.asDiagonal();
  bodies.set_added_mass([&](bodies::BodyKind, const geometry::Shape&, double) { return added; }, Vec3::Zero());
  const Wrench after = loads_of(*module, bodies, 0.7)[0];
  const WaveColumn column(*field, {2, 0}, 0.7);
  const Mat3 R = bodies.R_GB[0];
  const Vec3 force = R * diagonal.head<3>().asDiagonal() * R.transpose() * column.acceleration(-0.05);
  const Vec3 torque = R * diagonal.tail<3>().asDiagonal() * R.transpose() * column.tilt_acceleration(-0.05);
  EXPECT_LT((after.force - before.force - force).norm(), 1e-10);
  EXPECT_LT((after.torque - before.torque - torque).norm(), 1e-10);
  EXPECT_GT(force.norm(), 1);
}

/// A hull on a spring and a damper, moved in heave by the excitation of a database: the steady motion is
/// a |X| / |C - w^2 m + i w b|, and so is its phase.
TEST(WaveLoads, AVesselOnASpringHasTheResponseOfTheFrequencyDomain) {
  constexpr double k_spring = 900, k_damper = 120, k_step = 0.002, k_amplitude = 0.4;
  const auto database = std::make_shared<const Database>(test::synthetic_database());
  const double w = 1.0, period = 2 * k_pi / w;
  bodies::Bodies bodies;
  add_box(bodies, bodies::BodyKind::vessel, {1, 1, 1}, 500, Vec3::Zero());
  const auto waves = make_wave_loads(sea(), regular_field(2 * k_amplitude, period),
                                     {{{database, Vec3::Zero(), 0, {}}}, false, false}, bodies, 1);
  const std::complex<double> exact = k_amplitude * database->excitation[1][0][2] /
                                     (k_spring - w * w * bodies.mass[0] + std::complex<double>(0, w * k_damper));
  std::complex<double> found = 0;
  const int steps = static_cast<int>(std::lround(period / k_step)), rows = 12;
  const double h = period / steps;
  double z = 0, v = 0;
  for (int i = 0; i < rows * steps; ++i) {
    const double force = loads_of(*waves, bodies, (i + 0.5) * h)[0].force.z();
    // The midpoint rule, whose error is of second order in the step.
    const double middle = z + 0.5 * h * v, slow = v + 0.5 * h * (force - k_spring * z - k_damper * v) / bodies.mass[0];
    v += h * (force - k_spring * middle - k_damper * slow) / bodies.mass[0];
    z += h * slow;
    if (i >= (rows - 1) * steps) found += 2.0 / steps * z * std::polar(1.0, -w * (i + 1) * h);
  }
  // What is left of the start after eleven periods is exp(-b t / 2m) = 2.5e-4.
  EXPECT_LT(std::abs(found - exact) / std::abs(exact), 1e-3);
}

/// The load acts at the origin of D, in axes turned with the yaw of the hull.
TEST(WaveLoads, ActsAtTheOriginOfTheDatabase) {
  const auto database = std::make_shared<const Database>(test::synthetic_database());
  bodies::Bodies bodies;
  add_box(bodies, bodies::BodyKind::vessel, {1, 1, 1}, 500, {3, 4, -0.5});
  const double yaw = 0.7, t = 0.3;
  bodies.set_pose(0, bodies.p_GB[0], Quat(Eigen::AngleAxisd(yaw, Vec3::UnitZ())));
  const Vec3 origin_B(2, 0.5, 0.5);
  const auto field = regular_field(0.4, 2 * k_pi, yaw + 0.2);
  const auto module = make_wave_loads(sea(), field, {{{database, origin_B, 0, {}}}, false, false}, bodies, 1);
  const Wrench load = loads_of(*module, bodies, t)[0];
  const Vec3 origin = bodies.p_GB[0] + bodies.R_GB[0] * origin_B;
  const Vec6 in_D = VesselExcitation(*database, *field, WaveDrift::none)
                        .load(*field, WaveColumn(*field, origin.head<2>(), t), yaw, t);
  const Mat3& R = bodies.R_GB[0];
  EXPECT_LT((load.force - R * in_D.head<3>()).norm(), 1e-12);
  EXPECT_LT((load.torque - R * in_D.tail<3>() - (origin - bodies.p_GB[0]).cross(load.force)).norm(), 1e-10);
}

/// A database whose excitation is the linear Froude-Krylov load on the hull has no diffraction left. With pressure on
/// the hull the load is then that of the pressure alone.
TEST(WaveLoads, CountsFroudeKrylovOnce) {
  bodies::Bodies bodies;
  add_box(bodies, bodies::BodyKind::vessel, {2, 1, 1}, 500, Vec3(1, 2, 0));
  bodies.set_pose(0, bodies.p_GB[0], Quat(Eigen::AngleAxisd(0.4, Vec3::UnitZ())));
  const auto field = regular_field(0.02, 2 * k_pi, 0.4);
  const double shortest = field->shortest_length();
  Database database = test::synthetic_database();
  const WaveSurface surface(water_surface(*bodies.shape[0]), shortest / 8);
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t k = 0; k < database.heading.size(); ++k)
      database.excitation[i][k] =
          surface.linear_load(Mat3::Identity(), Vec3::Zero(), sea(), wave_direction(database.heading[k]),
                              wave_number(database.frequency[i], sea().gravity, std::nullopt), k_deep_water);
  WaveLoadSettings settings{DatabaseWaveLoads{std::make_shared<const Database>(database), Vec3::Zero(), 0, {}}, true,
                            false};
  const Wrench both = loads_of(*make_wave_loads(sea(), field, settings, bodies, 1), bodies, 0.4)[0];
  settings.database.reset();
  const Wrench pressure = loads_of(*make_wave_loads(sea(), field, settings, bodies, 1), bodies, 0.4)[0];
  EXPECT_LT((both.force - pressure.force).norm(), 1e-9 * pressure.force.norm());
  EXPECT_LT((both.torque - pressure.torque).norm(), 1e-9 * pressure.torque.norm());
}

TEST(WaveLoads, RefusesAHullMeshTooCoarseForTheWaves) {
  bodies::Bodies bodies;
  add_box(bodies, bodies::BodyKind::vessel, {10, 1, 1}, 500, Vec3::Zero());
  try {
    make_wave_loads(sea(), regular_field(0.1, 3), {{}, true, false}, bodies, 1);
    FAIL() << "a wave 14 m long on an edge of 10 m was taken";
  } catch (const InputError& error) {
    EXPECT_NE(std::string(error.what()).find("found a wave 14.1 m long"), std::string::npos) << error.what();
  }
  EXPECT_NO_THROW(make_wave_loads(sea(), regular_field(0.1, 4), {{}, true, false}, bodies, 1));
}

/// Floes take their loads in parallel: the same bits for any number of threads.
TEST(WaveLoads, HaveTheSameBitsForAnyThreads) {
  bodies::Bodies bodies;
  for (int i = 0; i < 9; ++i)
    add_box(bodies, bodies::BodyKind::floe, {1 + 0.1 * i, 1, 0.1}, 900, {2.0 * i, 0.3 * i, -0.04 + 0.01 * i});
  WaveTrain train;
  train.kind = WaveKind::jonswap;
  train.height = 0.2;
  train.period = 3;
  train.shortest_period = 1;
  train.components = 12;
  train.spreading = 6;
  const auto field = std::make_shared<const WaveField>(std::vector{train}, 9.81, 0.0, 0.0, 1);
  const auto one = loads_of(*make_wave_loads(sea(), field, {{}, false, true}, bodies, 1), bodies, 2.1);
  for (const int threads : {2, 4}) {
    const auto more = loads_of(*make_wave_loads(sea(), field, {{}, false, true}, bodies, threads), bodies, 2.1);
    for (std::size_t b = 0; b < one.size(); ++b) {
      EXPECT_EQ(one[b].force, more[b].force);
      EXPECT_EQ(one[b].torque, more[b].torque);
      EXPECT_GT(one[b].force.norm(), 0);
    }
  }
}

/// The column holds the height of the surface at the hull, at the end of the substep.
TEST(WaveLoads, ReportTheElevationAtTheHull) {
  bodies::Bodies bodies;
  add_box(bodies, bodies::BodyKind::vessel, {1, 1, 1}, 500, {3, 4, 0});
  const auto field = regular_field(0.4, 4);
  const auto module = make_wave_loads(sea(), field, {{}, true, false}, bodies, 1);
  module->end_substep(bodies, 1.5, 0.1);
  std::vector<double> values;
  module->append_values(values);
  ASSERT_EQ(values.size(), module->columns().size());
  EXPECT_EQ(values[0], field->elevation({3, 4}, 1.5));
}

}  // namespace wave_loads_test
