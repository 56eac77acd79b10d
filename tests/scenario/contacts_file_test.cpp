/// Tests of contacts.h5: its forces sum to those of vessel.csv, and it survives a kill and a full disk.
#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <nlohmann/json.hpp>

#include "core/hdf5/hdf5_file.h"
#include "tests/scenario/vessel_rows.h"
#include "tests/support/started_program.h"

namespace contacts_file_test {

using namespace nilas_test;
using Eigen::Matrix3d;
using Eigen::Vector3d;

/// A ship in packed ice. `vessel`: the support of the ship; `friction`: attributes of hull and ice besides static and
/// kinetic.
std::string ice_scene(const std::string& vessel, const std::string& friction = "", const std::string& solver = "auto") {
  return R"(<scene version="1" name="ice">
  <time step="0.01" end="2"/>
  <contact law="coulomb" integrator="semi-implicit-euler" solver=")" +
         solver + R"(" tolerance="1e-5">
    <friction between="ice ice" static="0.3" kinetic="0.3"/>
    <friction between="hull ice" static="0.1" kinetic="0.1" )" +
         friction + R"(/>
  </contact>
  <water density="1005"/>
  <hydro><buoyancy/><drag form="1" skin="0.005"/></hydro>
  <tank length="9" width="3" depth="1" wall_thickness="0.2" floor="true"/>
  <vessel name="ship" position="0.1 0" )" +
         vessel + R"(</vessel>
  <ice thickness="0.05">
    <field kind="packed" region="3 -1.5 6 1.5" concentration="0.7"><size distribution="lognormal" mean="0.4" sd="0.1" min="0.2" max="0.6"/></field>
  </ice>
</scene>
)";
}

const std::string k_hull =
    R"(<hull generate="icebreaker" length="3" beam="0.8" draught="0.2" depth="0.4" triangles="600"/><mass draught="0.2"/>)";
const std::string k_towed = ">" + k_hull + R"(<carriage speed="0.5" ramp="0.1" free="heave roll"/>)";
const std::string k_free = R"(velocity="0.6 0 0" heading_deg="4">)" + k_hull;

Vector3d in_row(const std::vector<double>& x, const std::vector<double>& y, const std::vector<double>& z,
                std::size_t i) {
  return {x[i], y[i], z[i]};
}

/// Columns x, y, z of a vector.
struct Vectors {
  Vectors(const nilas::hdf5::Hdf5Reader& file, const std::string& start, const std::string& unit)
      : x(file.exact_numbers("contacts/" + start + "x" + unit)),
        y(file.exact_numbers("contacts/" + start + "y" + unit)),
        z(file.exact_numbers("contacts/" + start + "z" + unit)) {}
  Vector3d operator[](std::size_t i) const { return in_row(x, y, z, i); }
  std::vector<double> x, y, z;
};

/// Compares with vessel.csv. With semi-implicit Euler the contacts of a row are found at the pose of the row before.
void expect_sums_of_vessel_csv(const fs::path& run, bool with_couples) {
  const Table vessel(run / "vessel.csv");
  const nilas::hdf5::Hdf5Reader file(run / "contacts.h5");
  const auto cog = nlohmann::json::parse(read_text(run / "summary.json"))["vessel"]["cog_m"].get<std::vector<double>>();
  const Vectors p(file, "", "_m"), p_V(file, "hull_", "_m"), f(file, "f", "_N"), impulse(file, "impulse_", "_Ns");
  ASSERT_EQ(file.has("contacts/couple_x_Nm"), with_couples);
  std::optional<Vectors> couple;
  if (with_couples) couple.emplace(file, "couple_", "_Nm");
  const auto index = file.wide_integers("steps"), step = file.wide_integers("contacts/step");
  const auto time = file.exact_numbers("contacts/time_s");
  ASSERT_EQ(index.size(), 2 * vessel.rows());
  std::size_t rows = 0;
  for (std::size_t k = 1; k < vessel.rows(); ++k) {
    const Vector3d com = vector_in_row(vessel, "", "_m", k - 1);
    const Matrix3d R = attitude(vessel, k - 1);
    Vector3d force = Vector3d::Zero(), moment = Vector3d::Zero();
    for (auto i = static_cast<std::size_t>(index[2 * k]); i < static_cast<std::size_t>(index[2 * k + 1]); ++i, ++rows) {
      ASSERT_EQ(step[i], static_cast<std::int64_t>(k + 1));
      ASSERT_NEAR(time[i], vessel["time_s"][k], 1e-11);
      EXPECT_LT((impulse[i] - 0.01 * f[i]).norm(), 1e-15 + 1e-12 * impulse[i].norm());
      EXPECT_LT((R * (p_V[i] - Vector3d(cog[0], cog[1], cog[2])) + com - p[i]).norm(), 1e-9);
      force += f[i];
      moment += (p[i] - com).cross(f[i]);
      if (couple) moment += (*couple)[i];
    }
    EXPECT_LT((force - vector_in_row(vessel, "contact_f", "_N", k)).norm(), 1e-9 * (1 + force.norm())) << "row " << k;
    EXPECT_LT((moment - vector_in_row(vessel, "contact_m", "_Nm", k)).norm(), 1e-8 * (1 + moment.norm()))
        << "row " << k;
  }
  EXPECT_GT(rows, 200u) << "too few contacts to tell anything";
}

TEST(ContactsFile, SumsToTheLoadsOfVesselCsv) {
  const ScratchFolder folder;
  folder.write("towed.xml", ice_scene(k_towed));
  folder.write("free.xml", ice_scene(k_free));
  folder.write("rolling.xml", ice_scene(k_towed, "rolling='0.02' spinning='0.01'", "nsgs"));
  for (const std::string scene : {"towed", "free", "rolling"}) {
    SCOPED_TRACE(scene);
    const auto result = run_nilas("run " + scene + ".xml --quiet --out " + scene, folder.path());
    ASSERT_EQ(result.exit_code, 0) << result.err;
    expect_sums_of_vessel_csv(folder / scene, scene == "rolling");
  }
  const nilas::hdf5::Hdf5Reader file(folder / "towed/contacts.h5");
  const auto status = file.wide_integers("contacts/status");
  for (const int kind : {0, 2}) EXPECT_GT(std::count(status.begin(), status.end(), kind), 0) << kind;
  const Vectors n(file, "n", ""), f(file, "f", "_N");
  for (std::size_t i = 0; i < status.size(); ++i) EXPECT_GE(n[i].dot(f[i]), 0) << "the ice pushes the hull away";
}

/// A floe breaks at two piers: body indices change while the loads must stay with their structures.
TEST(ContactsFile, SumsToTheLoadsOfStructuresCsvAlsoAfterABreak) {
  const ScratchFolder folder;
  folder.write("piers.xml", R"(<scene version="1" name="piers">
  <time step="0.01" end="1.6"/>
  <contact tolerance="1e-6"><friction between="* ice" static="0.1" kinetic="0.1"/></contact>
  <water density="1025"><current velocity="0.5 0 0"/></water>
  <hydro><buoyancy/><drag form="1" skin="0.005"/></hydro>
  <body name="west" shape="cylinder" radius="0.5" height="6" position="0 0.3 0" fixed="true"/>
  <body name="east" shape="cylinder" radius="0.5" height="6" position="0.5 -2 0" fixed="true"/>
  <ice thickness="0.05"><floe outline="-3.6 -3 -0.6 -3 -0.6 1 -3.6 1" velocity="0.5 0 0" breakable="true"/></ice>
  <fracture flexural_strength="1e3" fracture_toughness="1e3"><bending model="nevel"/></fracture>
</scene>)");
  const auto result = run_nilas("run piers.xml --quiet --out run", folder.path());
  ASSERT_EQ(result.exit_code, 0) << result.err;
  ASSERT_GT(Table(folder / "run/events.csv").rows(), 0u);
  const double broke = Table(folder / "run/events.csv")["time_s"][0];
  const Table loads(folder / "run/structures.csv");
  const nilas::hdf5::Hdf5Reader file(folder / "run/contacts.h5");
  const auto index = file.wide_integers("steps"), body = file.wide_integers("contacts/body");
  const auto fx = file.exact_numbers("contacts/fx_N");
  ASSERT_EQ(index.size(), 2 * loads.rows());
  // The later body of the scene has the larger index.
  const std::int64_t east = *std::max_element(body.begin(), body.end());
  double pressed = 0;
  for (std::size_t k = 0; k < loads.rows(); ++k) {
    double on_west = 0, on_east = 0;
    for (auto i = static_cast<std::size_t>(index[2 * k]); i < static_cast<std::size_t>(index[2 * k + 1]); ++i)
      (body[i] == east ? on_east : on_west) += fx[i];
    EXPECT_NEAR(loads["west_contact_fx_N"][k], on_west, 1e-9 * std::abs(on_west)) << "row " << k;
    EXPECT_NEAR(loads["east_contact_fx_N"][k], on_east, 1e-9 * std::abs(on_east)) << "row " << k;
    if (loads["time_s"][k] > broke) pressed += on_west + on_east;
  }
  EXPECT_GT(pressed, 0) << "the ice goes on pressing after the break";
}

TEST(ContactsFile, IsWrittenWhereTheSceneAsksForIt) {
  const ScratchFolder folder;
  folder.write("towed.xml", ice_scene(k_towed));
  folder.write("stack.xml", R"(<scene version="1" name="stack"><time step="0.01" end="0.2"/>
  <contact law="coulomb" solver="auto" tolerance="1e-9"/>
  <body name="ground" shape="plane" fixed="true"/>
  <body name="low" shape="box" size="1 1 1" mass="2" position="0 0 0.5"/>
  <body name="high" shape="box" size="1 1 1" mass="3" position="0 0 1.5"/></scene>)");
  const auto run = [&](const std::string& arguments) {
    const auto result = run_nilas("run " + arguments + " --quiet", folder.path());
    ASSERT_EQ(result.exit_code, 0) << result.err;
  };
  run("towed.xml --until 0.1 --set output/@contacts=none --out none");
  EXPECT_FALSE(fs::exists(folder / "none/contacts.h5"));
  run("stack.xml --out hull");
  EXPECT_FALSE(fs::exists(folder / "hull/contacts.h5")) << "there is no hull";
  run("stack.xml --set output/@contacts=all --out all");
  const nilas::hdf5::Hdf5Reader file(folder / "all/contacts.h5");
  EXPECT_FALSE(file.has("contacts/hull_x_m"));
  const auto index = file.wide_integers("steps"), body = file.wide_integers("contacts/body");
  const auto status = file.wide_integers("contacts/status");
  const auto fz = file.exact_numbers("contacts/fz_N");
  double on_low = 0, on_high = 0;
  for (auto i = static_cast<std::size_t>(index[index.size() - 2]); i < body.size(); ++i) {
    (body[i] == 3 ? on_high : on_low) += fz[i];
    EXPECT_NE(status[i], 0) << "what bears weight is closed";
  }
  EXPECT_NEAR(on_high, 3 * 9.81, 1e-6);
  EXPECT_NEAR(on_low, 5 * 9.81, 1e-6);
}

/// The run is killed at arbitrary moments: the file holds complete steps, all but those of the last second.
TEST(ContactsFile, AKilledRunLeavesItsSteps) {
  const ScratchFolder folder;
  folder.write("towed.xml", ice_scene(k_towed));
  ASSERT_EQ(run_nilas("run towed.xml --quiet --out whole", folder.path()).exit_code, 0);
  const nilas::hdf5::Hdf5Reader whole(folder / "whole/contacts.h5");
  const auto whole_index = whole.wide_integers("steps");
  const auto whole_f = whole.exact_numbers("contacts/fx_N");
  for (const std::size_t rows : {30u, 110u, 170u}) {
    const std::string out = "cut" + std::to_string(rows);
    Started run("run towed.xml --quiet --out " + out, folder.path());
    ASSERT_TRUE(run.reaches(folder / (out + "/steps.csv"), rows));
    run.stop(SIGKILL);
    const nilas::hdf5::Hdf5Reader cut(folder / (out + "/contacts.h5"));
    const auto index = cut.wide_integers("steps");
    ASSERT_LE(index.size(), whole_index.size());
    EXPECT_TRUE(std::equal(index.begin(), index.end(), whole_index.begin()));
    const auto f = cut.first_numbers("contacts/fx_N", index.empty() ? 0 : static_cast<std::size_t>(index.back()));
    EXPECT_TRUE(std::equal(f.begin(), f.end(), whole_f.begin()));
  }
}

TEST(ContactsFile, AFullDiskEndsTheRun) {
  const ScratchFolder folder;
  folder.write("towed.xml", ice_scene(k_towed));
  // 40 kB hold the beginning of the file and less than a second of data.
  const auto result = run_nilas("--version >/dev/null; ulimit -f 40; '" NILAS_PROGRAM
                                "' run towed.xml --quiet --until 20 --set output/@trajectory_every=0 "
                                "--set contact/@tolerance=1e-3 --out run",
                                folder.path());
  EXPECT_EQ(result.exit_code, 4) << result.err;
  EXPECT_NE(result.err.find("cannot write: File too large"), std::string::npos) << result.err;
}

}  // namespace contacts_file_test
