/// Pictures of where ice met the hull.
#include <gtest/gtest.h>

#include <regex>

#include "tests/support/program.h"

namespace {

using namespace nilas_test;

constexpr const char* k_ship_in_floes = R"(<scene version="1" name="two floes">
  <time step="0.01" end="1"/>
  <contact law="coulomb" solver="auto" tolerance="1e-6"><friction between="hull ice" static="0.1" kinetic="0.1"/></contact>
  <water density="1005"/>
  <hydro><buoyancy/><drag form="1" skin="0.005"/></hydro>
  <vessel name="ship" position="0 0">
    <hull generate="icebreaker" length="3" beam="0.8" draught="0.2" depth="0.4" triangles="600"/>
    <mass draught="0.2"/>
    <carriage speed="0.5" ramp="0.1"/>
  </vessel>
  <ice thickness="0.05">
    <floe name="port" outline="2.9 0.02 3.4 0.02 3.4 0.5 2.9 0.5"/>
    <floe name="starboard" outline="2.95 -0.6 3.4 -0.6 3.4 -0.02 2.95 -0.02"/>
  </ice>
</scene>
)";

TEST(Report, DrawsTheContactsOfAWindowWithItsMeanForce) {
  const ScratchFolder folder;
  folder.write("ship.xml", k_ship_in_floes);
  ASSERT_EQ(run_nilas("run ship.xml --quiet --out run", folder.path()).exit_code, 0);
  const auto result = run_nilas("report run --contacts 0.5,0.8 --window 0.1 --out pictures", folder.path());
  ASSERT_EQ(result.exit_code, 0) << result.err;
  EXPECT_EQ(read_text(folder / "pictures/contacts.png").substr(1, 3), "PNG");
  const std::string svg = read_text(folder / "pictures/contacts.svg");
  for (const char* said : {"port side", "starboard side", "t = 0.5 ± 0.1 s", "t = 0.8 ± 0.1 s", "[N]"})
    EXPECT_NE(svg.find(said), std::string::npos) << said;

  const Table vessel(folder / "run/vessel.csv");
  double sum = 0;
  for (std::size_t k = 0; k < vessel.rows(); ++k)
    if (vessel["time_s"][k] > 0.695 && vessel["time_s"][k] < 0.905) sum += vessel["contact_fx_N"][k];
  ASSERT_LT(sum, 0);
  std::smatch found;
  ASSERT_TRUE(std::regex_search(result.out, found,
                                std::regex(R"(t = 0\.8 \+- 0\.1 s: (\d+) contacts in (\d+) steps, mean force (\S+))")))
      << result.out;
  EXPECT_GT(std::stoi(found[1]), 10);
  EXPECT_EQ(std::stoi(found[2]), 21);
  EXPECT_NEAR(std::stod(found[3]), sum / 21, 1e-3);
}

TEST(Report, SaysWhatIsMissing) {
  const ScratchFolder folder;
  folder.write("ship.xml", k_ship_in_floes);
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
  refused("run", 2, "--contacts");
  refused("run --contacts 0.05 --window=-1", 2, "--window");
  refused("none --contacts 0.05", 4, "contacts.h5");
  refused("box --contacts 0.05", 2, "without a vessel");
  refused("nowhere --contacts 0.05", 4, "scene.xml");
  folder.write("run/contacts.h5", "no HDF5");
  refused("run --contacts 0.05", 2, "is no HDF5 file");
}

}  // namespace
