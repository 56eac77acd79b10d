/// Radiation in whole runs: the decay of the heaving sphere, accounts, and bits after a checkpoint.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <complex>
#include <fstream>
#include <iterator>
#include <sstream>
#include <string>
#include <vector>

#include "tests/core/sim/scene_rig.h"
#include "tests/core/sim/stl_text.h"

namespace radiation_test {

using namespace nilas;
using test::SceneRig;

/// A sphere of plane trapezoids between circles of latitude, of which one lies in z = 0. It is enlarged so that its
/// lower half has this volume [m^3].
std::string sphere_stl(double half_volume) {
  constexpr int k_rings = 32, k_sides = 64;
  std::vector<Vec3> vertices{{0, 0, -1}};
  for (int ring = 1; ring < k_rings; ++ring)
    for (int side = 0; side < k_sides; ++side) {
      const double polar = k_pi * ring / k_rings, around = 2 * k_pi * side / k_sides;
      vertices.emplace_back(std::sin(polar) * std::cos(around), std::sin(polar) * std::sin(around), -std::cos(polar));
    }
  vertices.emplace_back(0, 0, 1);
  const int top = static_cast<int>(vertices.size()) - 1;
  const auto index = [](int ring, int side) { return 1 + (ring - 1) * k_sides + side % k_sides; };
  std::vector<std::vector<int>> faces;
  for (int side = 0; side < k_sides; ++side) {
    faces.push_back({0, index(1, side + 1), index(1, side)});
    for (int ring = 1; ring + 1 < k_rings; ++ring)
      faces.push_back({index(ring, side), index(ring, side + 1), index(ring + 1, side + 1), index(ring + 1, side)});
    faces.push_back({top, index(k_rings - 1, side), index(k_rings - 1, side + 1)});
  }
  // The volume is a sixth of the sum of the triple products of all triangles.
  double volume = 0;
  for (const auto& face : faces)
    for (std::size_t k = 2; k < face.size(); ++k)
      volume += vertices[face[0]].dot(vertices[face[k - 1]].cross(vertices[face[k]])) / 6;
  for (Vec3& p : vertices) p *= std::cbrt(2 * half_volume / volume);
  return test::stl(vertices, faces);
}

/// The sphere of IEA OES Task 10, released `lift` [m] above its rest. Its mesh displaces what that of the database
/// does.
SceneRig sphere(const std::string& radiation, const std::string& more = "", int threads = 1, double step = 0.01,
                const std::string& in_water = "", double lift = 1) {
  return SceneRig("<time step='" + test::text(step) + "' end='1000'/>" + more + "<water density='1000'>" + in_water +
                      "</water><hydro><buoyancy/><added_mass vessel='database'/><database file='" + NILAS_SOURCE_DIR +
                      "/tests/data/hydro/hydrochrono/sphere.h5' origin='0 0 0'/>" + radiation +
                      "</hydro><vessel name='sphere' hull='sphere.stl' position='0 0 " + test::text(lift) +
                      "'><mass value='261800' "
                      "cog='0 0 -2' inertia='1.69e6 1.69e6 2.6e6 0 0 0'/></vessel>",
                  threads, {{"sphere.stl", sphere_stl(261.724)}});
}

struct Extreme {
  double t = 0, z = 0;
};

std::vector<Extreme> extremes(SceneRig& rig, std::size_t count) {
  std::vector<Extreme> found;
  std::array<double, 3> last{1, 1, 1};
  double t = 0;
  while (found.size() < count && t < 20) {
    const sim::StepRecord record = rig.balanced_step(1e-9, 1e-6);
    test::expect_energy_kept(record, 1e-9);
    last = {last[1], last[2], rig.bodies().p_GB[0].z() + 2};
    if ((last[1] - last[0]) * (last[2] - last[1]) < 0) found.push_back({t, last[1]});
    t = record.t;
  }
  return found;
}

/// Ranges of six published computations: times [s] and heights [m] of the first five extremes.
constexpr std::array<std::array<double, 4>, 5> k_published{{{2.21, 2.23, -0.8921, -0.8679},
                                                            {4.37, 4.45, 0.6313, 0.6508},
                                                            {6.52, 6.63, -0.4956, -0.4661},
                                                            {8.66, 8.81, 0.3410, 0.3704},
                                                            {10.81, 11.00, -0.2777, -0.2597}}};

/// `wider`: share by which the heights may leave the ranges.
void expect_published(const std::vector<Extreme>& found, std::size_t count, double wider, const std::string& what) {
  ASSERT_GE(found.size(), count);
  for (std::size_t k = 0; k < count; ++k) {
    const auto& [first, last, low, high] = k_published[k];
    // A step of the run is 0.01 s, as the times of the table are.
    EXPECT_GE(found[k].t, first - 0.01) << what << k;
    EXPECT_LE(found[k].t, last + 0.01) << what << k;
    EXPECT_GE(found[k].z, low - wider * std::abs(low)) << what << k;
    EXPECT_LE(found[k].z, high + wider * std::abs(high)) << what << k;
  }
}

/// With the hydrostatics of the database, which are linear, the first four extremes lie in the ranges, but for the last
/// digit of the table, and the fifth is 0.4 % outside. Those of the mesh are not linear, which lowers the amplitudes by
/// 0.2 % in each half period.
TEST(Radiation, LetsTheSphereDecayAsInPublishedComputations) {
  for (const std::string model : {"state-space", "convolution"}) {
    SceneRig linear = sphere("<restoring/><radiation model='" + model + "'/>");
    const std::vector<Extreme> found = extremes(linear, 5);
    expect_published(found, 4, 1e-4, model + ", linear, ");
    expect_published(found, 5, 0.01, model + ", linear, ");
    SceneRig exact = sphere("<radiation model='" + model + "'/>");
    expect_published(extremes(exact, 3), 3, 0.01, model + ", mesh, ");
  }
}

/// Heave per metre of wave: the amplitude at the wave's frequency over the last four of 30 periods.
double heave_response(double period, double height) {
  const int per_period = 200, before = 26 * per_period, during = 4 * per_period;
  SceneRig rig = sphere("<restoring/><radiation/><wave_loads vessel='database' floes='none'/>",
                        "<contact integrator='moreau'/>", 1, period / per_period,
                        "<waves height='" + test::text(height) + "' period='" + test::text(period) + "' ramp='" +
                            test::text(5 * period) + "'/>",
                        0);
  std::complex<double> sum = 0;
  for (int k = 1; k <= before + during; ++k) {
    rig.simulation.step();
    const std::complex<double> turn = std::exp(std::complex<double>(0, -2 * k_pi * k / per_period));
    if (k > before) sum += (rig.bodies().p_GB[0].z() + 2) * turn;
  }
  return 2 * std::abs(sum) / during / (0.5 * height);
}

/// Regular waves 1 to 10, free of any damper. The waves are so low that the sphere, which nothing holds, stays where it
/// is: in waves of 0.1 m it gets under way in the ramp and meets others than those of the table. Nine responses are
/// within the spread of five published computations as it is. In waves of 11 s it is 1.0067, and all five are above:
/// the lowest by 0.11 %. Linear theory of deep water has 1.0071 there, as oes_sphere_test.cpp shows by Haskind's
/// relation.
TEST(Radiation, LetsTheSphereFollowRegularWavesAsInPublishedComputations) {
  constexpr double k_height = 1e-3, k_longest = 11, k_beyond = 1.1e-3;
  std::ifstream table(std::string(NILAS_SOURCE_DIR) + "/tests/data/hydro/oes-sphere/responses.csv");
  std::string line;
  std::getline(table, line);
  int rows = 0;
  while (std::getline(table, line)) {
    std::replace(line.begin(), line.end(), ',', ' ');
    std::istringstream in(line);
    double steepness = 0, period = 0, damper = 0;
    in >> steepness >> period >> damper;
    const std::vector<double> published{std::istream_iterator<double>(in), {}};
    if (damper != 0 || steepness > 0.01) continue;
    ASSERT_EQ(published.size(), 5);
    ++rows;
    const double heave = heave_response(period, k_height);
    const auto [least, most] = std::minmax_element(published.begin(), published.end());
    EXPECT_GE(heave, (period == k_longest ? 1 - k_beyond : 1) * *least) << period << " s";
    EXPECT_LE(heave, *most) << period << " s";
  }
  EXPECT_EQ(rows, 10);
}

/// Without radiation it keeps its energy: the first minimum is as deep as the release was high.
TEST(Radiation, IsWhatDampsTheSphere) {
  SceneRig rig = sphere("");
  const std::vector<Extreme> found = extremes(rig, 1);
  ASSERT_EQ(found.size(), 1);
  EXPECT_LT(found[0].z, -0.99);
}

TEST(Radiation, ContinuesWithTheSameBits) {
  for (const std::string model : {"state-space", "convolution"}) {
    SceneRig through = sphere("<radiation model='" + model + "'/>"),
             part = sphere("<radiation model='" + model + "'/>"),
             resumed = sphere("<radiation model='" + model + "'/>", "", 2);
    for (int k = 0; k < 600; ++k) through.simulation.step();
    for (int k = 0; k < 300; ++k) part.simulation.step();
    State state;
    part.simulation.save(StateWriter(state));
    resumed.simulation.restore(StateReader(state));
    for (int k = 0; k < 300; ++k) resumed.simulation.step();
    EXPECT_EQ(through.bodies().p_GB[0], resumed.bodies().p_GB[0]);
    EXPECT_EQ(through.bodies().v_GB[0], resumed.bodies().v_GB[0]);
  }
}

/// Linear loads hold for small angles. A sphere that swings further gives one warning, also after a resume.
TEST(Radiation, WarnsOnceOfALargeTilt) {
  const auto swung = [](const std::string& rate) {
    return SceneRig(
        "<time step='0.01' end='1000'/><water density='1000'/><hydro><buoyancy/><restoring/><database file='" +
            std::string(NILAS_SOURCE_DIR) +
            "/tests/data/hydro/hydrochrono/sphere.h5' origin='0 0 0'/></hydro><vessel name='sphere' "
            "hull='sphere.stl' position='0 0 0' angular_velocity='" +
            rate + " 0 0'><mass value='261800' cog='0 0 -2' inertia='1.69e6 1.69e6 2.6e6 0 0 0'/></vessel>",
        1, {{"sphere.stl", sphere_stl(261.724)}});
  };
  const std::string kind = "tilt beyond the database";
  SceneRig gentle = swung("0.4"), wild = swung("1.2"), resumed = swung("1.2");
  double most = 0;
  for (int k = 0; k < 400; ++k) {
    gentle.simulation.step();
    wild.simulation.step();
    most = std::max(most, std::acos(std::min(1.0, gentle.bodies().R_GB[0](2, 2))));
  }
  EXPECT_GT(most, 10 * k_deg);
  EXPECT_LT(most, 20 * k_deg);
  EXPECT_EQ(gentle.warnings.counts().count(kind), 0u);
  ASSERT_EQ(wild.warnings.counts().count(kind), 1u);
  EXPECT_EQ(wild.warnings.counts().at(kind), 1);
  State state;
  wild.simulation.save(StateWriter(state));
  resumed.simulation.restore(StateReader(state));
  for (int k = 0; k < 400; ++k) resumed.simulation.step();
  EXPECT_EQ(resumed.warnings.counts().count(kind), 0u);
}

/// With semi-implicit Euler, loads are evaluated where the last step ended, to the last bit of its time.
TEST(Radiation, RunsWithSemiImplicitEuler) {
  for (const std::string model : {"state-space", "convolution"}) {
    SceneRig rig = sphere("<radiation model='" + model + "'/>", "<contact integrator='semi-implicit-euler'/>");
    for (int k = 0; k < 100; ++k) test::expect_energy_kept(rig.balanced_step(1e-9, 1e-6), 1e-9);
    EXPECT_LT(rig.bodies().p_GB[0].z(), -1.5);
  }
}

/// The log names model, order, error and passivity.
TEST(Radiation, SaysWhatItIs) {
  SceneRig rig = sphere("<radiation/>");
  std::string reason;
  for (const auto& [name, text] : rig.simulation.info().modules)
    if (name == "radiation") reason = text;
  EXPECT_NE(reason.find("state space of 8 + 8 + 5 poles"), std::string::npos) << reason;
  EXPECT_NE(reason.find("passive"), std::string::npos);
}

}  // namespace radiation_test
