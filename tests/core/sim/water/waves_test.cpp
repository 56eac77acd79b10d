/// Floes in waves in whole runs: they follow long waves, no wave is no motion, and bits stay the same.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <complex>
#include <string>
#include <vector>

#include "core/base/error.h"
#include "tests/core/sim/scene_rig.h"

namespace waves_test {

using namespace nilas;
using test::SceneRig;

const std::string k_floe =
    "<ice density='900' thickness='0.2'><floe name='one' outline='-0.5 -0.5 0.5 -0.5 0.5 0.5 -0.5 0.5'/></ice>";

std::string scene_of(const std::string& waves, const std::string& hydro, double step = 0.01) {
  return "<time step='" + test::text(step) + "' end='1000'/><water density='1000'>" + waves + "</water><hydro>" +
         hydro + "</hydro>" + k_floe;
}

/// The amplitude of a motion over whole periods, as a complex number A: Re(A exp(i w t)).
class Amplitude {
 public:
  Amplitude(double frequency, int steps) : frequency_(frequency), steps_(steps) {}
  void add(double value, double t) { sum_ += 2.0 / steps_ * value * std::polar(1.0, -frequency_ * t); }
  std::complex<double> value() const { return sum_; }

 private:
  double frequency_;
  int steps_;
  std::complex<double> sum_ = 0;
};

/// A floe of 1 m in a wave 156 m long, with added mass and drag: heave and surge have the amplitude and the phase of
/// the water, a and -i a, within 1 %. The ramp lasts two periods, and the sixth one is measured.
TEST(Waves, ASmallFloeFollowsALongWave) {
  constexpr double k_period = 10, k_step = 0.01, k_amplitude = 0.1;
  SceneRig rig(
      scene_of("<waves height='0.2' period='10' ramp='20'/>", "<buoyancy/><drag/><added_mass/><wave_loads/>", k_step));
  const int steps = static_cast<int>(std::lround(k_period / k_step));
  const double w = 2 * k_pi / k_period, rest = 0.2 * (0.5 - 0.9);
  for (int i = 0; i < 5 * steps; ++i) rig.simulation.step();
  Amplitude heave(w, steps), surge(w, steps);
  const double start = rig.bodies().p_GB[0].x();
  std::vector<double> x;
  sim::StepRecord record;
  for (int i = 0; i < steps; ++i) {
    record = rig.simulation.step();
    heave.add(rig.bodies().p_GB[0].z() - rest, record.t);
    x.push_back(rig.bodies().p_GB[0].x() - start);
  }
  // The floe drifts slowly with the crests: the drift of the period is taken away as a straight line.
  const double drift = x.back();
  for (int i = 0; i < steps; ++i) surge.add(x[i] - drift * (i + 1) / steps, record.t + (i + 1 - steps) * k_step);
  EXPECT_LT(std::abs(heave.value() - k_amplitude), 0.01 * k_amplitude);
  EXPECT_LT(std::abs(surge.value() - std::complex<double>(0, -k_amplitude)), 0.01 * k_amplitude);
}

/// Waves of no height give the bits of a scene without waves.
TEST(Waves, WithoutHeightNothingMoves) {
  SceneRig still(scene_of("", "<buoyancy/><drag/><added_mass/>"));
  SceneRig flat(scene_of("<waves height='0' period='10'/>", "<buoyancy/><drag/><added_mass/><wave_loads/>"));
  for (int i = 0; i < 20; ++i) {
    EXPECT_EQ(still.simulation.step().state_hash, flat.simulation.step().state_hash);
    EXPECT_EQ(flat.bodies().p_GB[0], still.bodies().p_GB[0]);
  }
}

/// The energy account closes: what the waves do is the work of their module. Momenta balance to rounding.
TEST(Waves, TheirWorkIsBooked) {
  SceneRig rig(
      scene_of("<waves kind='jonswap' height='0.3' period='4'/>", "<buoyancy/><drag/><added_mass/><wave_loads/>"));
  const auto& names = rig.simulation.info().work_names;
  ASSERT_NE(std::find(names.begin(), names.end(), "wave_loads"), names.end());
  for (int i = 0; i < 100; ++i) test::expect_energy_kept(rig.balanced_step(1e-9, 1e-9), 1e-9);
}

/// One and two threads give the same bits.
TEST(Waves, ThreadsDoNotChangeBits) {
  const std::string scene = scene_of("<waves kind='jonswap' height='0.3' period='4' spreading='10'/>",
                                     "<buoyancy/><drag/><added_mass/><wave_loads/>");
  SceneRig one(scene, 1), two(scene, 2);
  for (int i = 0; i < 20; ++i) EXPECT_EQ(one.simulation.step().state_hash, two.simulation.step().state_hash);
}

/// The columns of a resumed run, of which the elevation of the waves is one, have the bits of a run without a break,
/// from the first row on.
TEST(Waves, AResumedRunHasTheSameRows) {
  const std::string scene = scene_of("<waves kind='jonswap' height='0.3' period='4' ramp='1'/>",
                                     "<buoyancy/><drag/><added_mass/><wave_loads/>");
  SceneRig through(scene), part(scene), resumed(scene);
  for (int i = 0; i < 20; ++i) {
    through.simulation.step();
    part.simulation.step();
  }
  State state;
  part.simulation.save(StateWriter(state));
  resumed.simulation.restore(StateReader(state));
  for (int i = 0; i < 5; ++i) {
    const sim::StepRecord a = through.simulation.step(), b = resumed.simulation.step();
    ASSERT_EQ(a.module_values.size(), 1u);
    EXPECT_NE(a.module_values[0], 0);
    EXPECT_EQ(a.module_values, b.module_values) << i;
    EXPECT_EQ(a.state_hash, b.state_hash) << i;
  }
}

/// The log says how the waves are made and how ice weakens them.
TEST(Waves, AreListed) {
  SceneRig rig(
      scene_of("<waves height='0.3' period='4' attenuation='exponential' attenuation_rate='1e-3' "
               "ice_edge='0 0'/>",
               "<buoyancy/><wave_loads/>"));
  std::string all;
  for (const auto& [name, reason] : rig.simulation.info().modules) all += name + ": " + reason + "\n";
  EXPECT_NE(all.find("waves: regular, height 0.3 m, period 4 s, heading 0 deg, deep water, attenuation exponential "
                     "0.001 1/m"),
            std::string::npos)
      << all;
  EXPECT_NE(all.find("wave_loads: <hydro><wave_loads>: vessel froude-krylov, diffraction none, floes froude-krylov"),
            std::string::npos)
      << all;
}

/// A wave that the hull's mesh does not resolve is refused with both lengths: the box hull has wet edges of 2.2 m.
TEST(Waves, AHullMeshTooCoarseIsRefused) {
  const std::string vessel = test::box_vessel("position='0 0 0'", "", 500);
  const auto build = [&](const std::string& period) {
    SceneRig rig("<water density='1000'><waves height='0.01' period='" + period +
                 "'/></water><hydro><buoyancy/><wave_loads/></hydro>" + vessel);
  };
  EXPECT_NO_THROW(build("2"));
  try {
    build("1");
    FAIL() << "a wave 1.6 m long on edges of 2.2 m was taken";
  } catch (const InputError& error) {
    EXPECT_NE(std::string(error.what()).find("scene.xml: <hydro><wave_loads>: Froude-Krylov loads on 'hull'"),
              std::string::npos)
        << error.what();
  }
}

}  // namespace waves_test
