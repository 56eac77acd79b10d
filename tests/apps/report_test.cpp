/// Pictures of where ice met the hull.
#include <gtest/gtest.h>

#include <iterator>
#include <regex>

#include "apps/report/floe_outlines.h"
#include "tests/apps/small_scenes.h"
#include "tests/support/program.h"

namespace report_test {

using namespace nilas_test;

TEST(Report, DrawsTheContactsOfAWindowWithItsMeanForce) {
  const ScratchFolder folder;
  folder.write("ship.xml", k_ship);
  ASSERT_EQ(run_nilas("run ship.xml --quiet --out run", folder.path()).exit_code, 0);
  const auto result = run_nilas("report run --contacts 0.5,0.8 --window 0.1 --out pictures", folder.path());
  ASSERT_EQ(result.exit_code, 0) << result.err;
  EXPECT_EQ(read_text(folder / "pictures/contacts.png").substr(1, 3), "PNG");
  const std::string svg = read_text(folder / "pictures/contacts.svg");
  for (const char* said : {"port side", "starboard side", "t = 0.5 ± 0.1 s", "t = 0.8 ± 0.1 s", "N]", "astern",
                           "edge of hull or body", "waterline", "edge of ice"})
    EXPECT_NE(svg.find(said), std::string::npos) << said;

  const Table vessel(folder / "run/vessel.csv");
  double sum = 0;
  for (std::size_t k = 0; k < vessel.rows(); ++k)
    if (vessel["time_s"][k] > 0.695 && vessel["time_s"][k] < 0.905) sum -= vessel["contact_fx_N"][k];
  ASSERT_GT(sum, 0) << "resistance is positive astern";
  std::smatch found;
  ASSERT_TRUE(std::regex_search(
      result.out, found,
      std::regex(R"(t = 0\.8 \+- 0\.1 s: (\d+) contacts in (\d+) steps\n  mean load (\S+) N astern, )")))
      << result.out;
  EXPECT_GT(std::stoi(found[1]), 10);
  EXPECT_EQ(std::stoi(found[2]), 21);
  EXPECT_NEAR(std::stod(found[3]), sum / 21, 1e-3 * sum / 21);
}

/// A ship that breaks a sheet 20 mm thick.
TEST(Report, DrawsThePiecesOfBrokenFloes) {
  const ScratchFolder folder;
  folder.write("level.xml", R"(<scene version="1" name="sheet">
  <time step="0.01" end="1.4"/>
  <contact solver="nsgs" tolerance="1e-3" max_iterations="200" stabilisation="split-impulse" erp="0.3">
    <friction between="ice ice" static="0.3" kinetic="0.3"/>
    <friction between="hull ice" static="0.1" kinetic="0.1"/>
  </contact>
  <water density="1005"/>
  <hydro><buoyancy/><drag form="1" skin="0.005"/></hydro>
  <vessel name="ship" position="0 0">
    <hull generate="icebreaker" length="3" beam="0.8" draught="0.2" depth="0.4" triangles="600"/>
    <mass draught="0.2"/>
    <carriage speed="0.5" ramp="0.1"/>
  </vessel>
  <ice thickness="0.02"><floe name="sheet" fixed="true" breakable="true" outline="3.1 -2 6 -2 6 2 3.1 2"/></ice>
  <fracture flexural_strength="4e4" compressive_strength="1e5">
    <crushing model="explicit"/><bending model="nevel"/>
  </fracture>
</scene>
)");
  const auto run = run_nilas("run level.xml --quiet --out run", folder.path());
  ASSERT_EQ(run.exit_code, 0) << run.err;
  const Table events(folder / "run/events.csv");
  ASSERT_GT(events.rows(), 0u);
  const double broke = events["time_s"][0];
  ASSERT_LT(broke, 1.3);
  const auto area = [](const nilas::report::IceFrame& frame) {
    double sum = 0;
    for (const auto& outline : frame.outlines)
      for (std::size_t k = 0; k < outline.size(); ++k) {
        const nilas::Vec3 &a = outline[k], &b = outline[(k + 1) % outline.size()];
        sum += 0.5 * (a.x() * b.y() - a.y() * b.x());
      }
    return sum;
  };
  const auto before = nilas::report::ice_near(folder / "run", broke - 0.1),
             after = nilas::report::ice_near(folder / "run", 1.4);
  ASSERT_TRUE(before && after);
  EXPECT_EQ(before->outlines.size(), 1u);
  EXPECT_NEAR(area(*before), 2.9 * 4, 1e-4);
  EXPECT_NEAR(after->t, 1.4, 1e-9);
  EXPECT_GT(after->outlines.size(), 2u);
  EXPECT_NEAR(area(*after), 2.9 * 4, 0.05) << "pieces turn down under the bow";
  const auto result = run_nilas("report run --contacts 1.4", folder.path());
  ASSERT_EQ(result.exit_code, 0) << result.err;
  const std::string svg = read_text(folder / "run/contacts.svg");
  const std::regex filled("rgb\\(219, 234, 245\\)");
  EXPECT_GE(std::distance(std::sregex_iterator(svg.begin(), svg.end(), filled), std::sregex_iterator()),
            static_cast<std::ptrdiff_t>(after->outlines.size()));
}

/// Two piers, and a floe that drifts against one of them.
TEST(Report, DrawsFixedBodiesOfARunWithoutAVessel) {
  const ScratchFolder folder;
  folder.write("piers.xml", R"(<scene version="1" name="piers">
  <time step="0.01" end="1"/>
  <contact tolerance="1e-6"><friction between="* ice" static="0.1" kinetic="0.1"/></contact>
  <water density="1025"><current velocity="0.5 0 0"/></water>
  <hydro><buoyancy/><drag form="1" skin="0.005"/></hydro>
  <body name="west" shape="cylinder" radius="0.5" height="6" position="0 0 0" fixed="true"/>
  <body name="east" shape="cylinder" radius="0.5" height="6" position="9 0 0" fixed="true"/>
  <ice thickness="0.2"><floe outline="-3.6 -1 -0.6 -1 -0.6 1 -3.6 1" velocity="0.5 0 0"/></ice>
</scene>
)");
  const auto run = run_nilas("run piers.xml --quiet --out run", folder.path());
  ASSERT_EQ(run.exit_code, 0) << run.err;
  const auto result = run_nilas("report run --contacts 0.3 --window 0.2", folder.path());
  ASSERT_EQ(result.exit_code, 0) << result.err;
  EXPECT_NE(result.out.find("along, "), std::string::npos) << result.out;
  const std::string svg = read_text(folder / "run/contacts.svg");
  for (const char* said : {"Contacts on west, east, scene piers", "seen from -x", "seen from -y", "along,"})
    EXPECT_NE(svg.find(said), std::string::npos) << said;

  const Table loads(folder / "run/structures.csv");
  double sum = 0, count = 0;
  for (std::size_t k = 0; k < loads.rows(); ++k)
    if (loads["time_s"][k] > 0.095 && loads["time_s"][k] < 0.505) {
      sum += loads["west_ice_resistance_N"][k];
      ++count;
    }
  ASSERT_GT(sum, 0);
  std::smatch found;
  ASSERT_TRUE(std::regex_search(result.out, found, std::regex(R"(mean load (\S+) (k?N) along, )"))) << result.out;
  EXPECT_NEAR(std::stod(found[1]) * (found[2] == "kN" ? 1e3 : 1), sum / count, 1e-3 * sum / count);

  EXPECT_EQ(run_nilas("report run --contacts 0.3 --body east --out east", folder.path()).exit_code, 0);
  EXPECT_NE(read_text(folder / "east/contacts.svg").find("Contacts on east, scene piers"), std::string::npos);
  const auto unknown = run_nilas("report run --contacts 0.3 --body north", folder.path());
  EXPECT_EQ(unknown.exit_code, 2);
  EXPECT_NE(unknown.err.find("found 'north'; allowed: west, east"), std::string::npos) << unknown.err;
}

TEST(Report, SaysWhatIsMissing) {
  const ScratchFolder folder;
  folder.write("ship.xml", k_ship);
  folder.write("box.xml", R"(<scene version="1"><time end="0.1"/><body shape="box"/></scene>)");
  ASSERT_EQ(run_nilas("run ship.xml --quiet --until 0.1 --out run", folder.path()).exit_code, 0);
  ASSERT_EQ(
      run_nilas("run ship.xml --quiet --until 0.1 --set output/@contacts=none --out none", folder.path()).exit_code, 0);
  ASSERT_EQ(run_nilas("run box.xml --quiet --out box", folder.path()).exit_code, 0);
  const auto refused = [&](const std::string& arguments, int code, const std::string& said) {
    const auto result = run_nilas("report " + arguments, folder.path());
    EXPECT_EQ(result.exit_code, code) << arguments << ": " << result.err;
    EXPECT_NE(result.err.find(said), std::string::npos) << arguments << ": " << result.err;
  };
  refused("run --contacts 3", 2, "the run has 0 to 0.1 s");
  refused("run --window 0.1", 2, "--contacts");
  refused("run --contacts 0.05 --window=-1", 2, "--window");
  refused("none --contacts 0.05", 2, "<output contacts=\"hull\">");
  refused("box --contacts 0.05", 2, "neither a vessel nor a body");
  refused("nowhere --contacts 0.05", 4, "nowhere: there is no such run folder");
  folder.write("run/contacts.h5", "no HDF5");
  refused("run --contacts 0.05", 2, "is no HDF5 file");
}

}  // namespace report_test
