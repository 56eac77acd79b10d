/// Reading databases: the three forms, their scales and what is wrong with a file.
#include "hydro/database/read_database.h"

#include <gtest/gtest.h>

#include <fstream>
#include <limits>

#include "core/base/error.h"
#include "core/hdf5/hdf5_file.h"
#include "hydro/database/bemio.h"
#include "hydro/database/wamit.h"
#include "tests/hydro/database/data_files.h"
#include "tests/support/refusal.h"
#include "tests/support/scratch_folder.h"

namespace read_database_test {

using namespace nilas;
using namespace nilas::hydro;
using test::expect_refusal;

/// A database of one period and heading whose rows a test spoils.
struct SmallFiles {
  test::ScratchFolder folder;
  std::string radiation =
      " a heading\n"
      " -1 3 3 2.0\n"
      " 0 3 3 1.0\n"
      " 6.283185307179586 3 3 1.5 0.25\n";
  std::string excitation = " 6.283185307179586 0 3 5.0 53.13010235415598 3.0 4.0\n";
  std::string hydrostatics = " 3 3 7.0\n";

  std::filesystem::path write() const {
    folder.write("a.3", excitation);
    folder.write("a.hst", hydrostatics);
    return folder.write("a.1", radiation);
  }
  DatabaseSettings settings() const {
    DatabaseSettings settings;
    settings.length = 2;
    settings.density = 1000;
    settings.gravity = 10;
    return settings;
  }
  Database read() const { return read_database(write(), settings()); }
};

/// With w = 1, L = 2, rho = 1000 and g = 10: A33 = rho L^3 a = 8000 a, B33 = rho L^3 w b, X3 = rho g L^2 x = 40000 x,
/// C33 = rho g L^2 c. All files are found from any of them and from the stem.
TEST(Wamit, HasTheScalesOfItsManual) {
  const SmallFiles files;
  files.write();
  for (const char* name : {"a.1", "a.3", "a.hst", "a"}) {
    SCOPED_TRACE(name);
    const Database database = read_database(files.folder / name, files.settings());
    EXPECT_NEAR(database.frequency.at(0), 1, 1e-15);
    EXPECT_NEAR(database.added_mass.at(0)(2, 2), 12000, 1e-9);
    EXPECT_NEAR(database.damping.at(0)(2, 2), 2000, 1e-9);
    EXPECT_NEAR((*database.added_mass_zero)(2, 2), 16000, 1e-9);
    EXPECT_NEAR((*database.added_mass_infinite)(2, 2), 8000, 1e-9);
    EXPECT_LT(std::abs(database.excitation.at(0).at(0)[2] - std::complex<double>(120000, 160000)), 1e-6);
    EXPECT_NEAR((*database.restoring)(2, 2), 280000, 1e-9);
    EXPECT_FALSE(database.depth);
  }
}

/// Moments have one more length, and terms between two rotations two more.
TEST(Wamit, RotationsHaveMoreLengths) {
  SmallFiles files;
  files.radiation = " 6.283185307179586 3 5 1.0 0\n 6.283185307179586 5 5 1.0 0\n";
  files.excitation = " 6.283185307179586 0 5 1.0 0.0 1.0 0.0\n";
  files.hydrostatics = " 3 5 1.0\n 5 5 1.0\n";
  files.folder.write("a.4", " 6.283185307179586 0 5 1.0 0.0 1.0 0.0\n");
  files.folder.write("a.9", " 6.283185307179586 0 0 5 1.0 0.0 1.0 0.0\n 6.283185307179586 0 0 -5 1.0 0.0 1.0 0.0\n");
  const Database database = files.read();
  EXPECT_NEAR(database.added_mass[0](2, 4), 1000 * 16, 1e-9);
  EXPECT_NEAR(database.added_mass[0](4, 4), 1000 * 32, 1e-9);
  EXPECT_NEAR(database.excitation[0][0][4].real(), 1e4 * 8, 1e-9);
  EXPECT_NEAR((*database.restoring)(2, 4), 1e4 * 8, 1e-9);
  EXPECT_NEAR((*database.restoring)(4, 4), 1e4 * 16, 1e-9);
  EXPECT_NEAR(database.motion[0][0][4].real(), 0.5, 1e-15);
  EXPECT_NEAR(database.drift[0][0][4], 1e4 * 4, 1e-9);
}

TEST(Wamit, ReadsExponentsAsFortranWritesThem) {
  SmallFiles files;
  files.radiation = " 6.283185307179586D+00 3 3 1.5D+00 2.5-301\n";
  EXPECT_NEAR(files.read().added_mass[0](2, 2), 12000, 1e-9);
}

TEST(Wamit, NeedsLengthDensityAndGravity) {
  const SmallFiles files;
  const auto file = files.write();
  for (const char* name : {"length", "density", "gravity"}) {
    DatabaseSettings settings = files.settings();
    (name[0] == 'l' ? settings.length : name[0] == 'd' ? settings.density : settings.gravity).reset();
    expect_refusal([&] { read_database(file, settings); }, {"a.1: the " + std::string(name), "is missing", "ULEN"});
  }
}

/// The geometry file states ULEN and gravity, so a wrong one shows before anything is computed.
TEST(Wamit, RefusesALengthThatTheGeometryContradicts) {
  const SmallFiles files;
  files.folder.write("a.gdf", "title\n1.0 10.0 ULEN GRAV\n");
  expect_refusal([&] { files.read(); }, {"a.gdf", "length 1 m", "2 m was given"});
  files.folder.write("a.gdf", "title\n2.0 9.81 ULEN GRAV\n");
  expect_refusal([&] { files.read(); }, {"a.gdf", "gravity 9.81"});
}

TEST(Wamit, NamesFileAndLineOfWrongRows) {
  struct Case {
    std::string file, text;
    std::vector<std::string> words;
  };
  const std::vector<Case> cases{
      {".1", " 6 3 3 1.0 0.1\n 6 3 3 1.0 0.1\n", {"a.1:2", "repeats", "line 1"}},
      {".1", " 6 3 3 1.0\n", {"a.1:1", "has no damping"}},
      {".1", " 6 3 3 1.0 x\n", {"a.1:1", "heading"}},
      {".1", " 6 3 3 1.0 0.1\n 6 3 5 nan 0.1\n", {"a.1:2", "'nan'", "finite number"}},
      {".1", " 6 3 7 1.0 0.1\n", {"a.1:1", "mode 7", "one rigid body"}},
      {".1", " 6 3 3 1.0 0.1 0.2\n", {"a.1:1", "6 columns", "4 or 5"}},
      {".1", " 6 3 3 1.0 0.1\n 6 3 5 1.0 0.1\n 5 3 3 1.0 0.1\n", {"a.1:3", "no row for modes 3 5", "line 2"}},
      {".1", " -1 3 3 1.0\n", {"a.1", "no period above 0"}},
      {".3", " 5 0 3 1.0 0 1.0 0\n", {"a.3", "period 5", ".1 has not"}},
      {".3", " 6.283185307179586 0 3 5.0 53.13 4.0 3.0\n", {"a.3:1", "modulus 5", "do not fit"}},
      {".3", " 6.283185307179586 0 3 1 0 1 0\n 6.283185307179586 0 3 1 0 1 0\n", {"a.3:2", "repeats", "line 1"}},
      {".hst", " 3 3 1.0\n 3 3 2.0\n", {"a.hst:2", "repeats"}},
  };
  for (const Case& one : cases) {
    SCOPED_TRACE(one.text);
    SmallFiles files;
    (one.file == ".1" ? files.radiation : one.file == ".3" ? files.excitation : files.hydrostatics) = one.text;
    if (one.words[1] == "heading") {  // the first line is passed over as WAMIT's heading, and nothing is left
      expect_refusal([&] { files.read(); }, {"a.1"});
      continue;
    }
    expect_refusal([&] { files.read(); }, one.words);
  }
}

TEST(Wamit, NamesTheFileThatIsNotThere) {
  const test::ScratchFolder folder;
  folder.write("b.3", " 6 0 3 1.0 0 1.0 0\n");
  expect_refusal<FileError>([&] { read_database(folder / "b.3", SmallFiles().settings()); }, {"b.1", "no such"});
  expect_refusal<FileError>([&] { read_database(folder / "c", SmallFiles().settings()); }, {"no such"});
}

TEST(Database, SaysThatTheInfiniteAddedMassIsMissing) {
  SmallFiles files;
  EXPECT_NEAR(demand_infinite_added_mass(files.read())(2, 2), 8000, 1e-9);
  files.radiation = " 6.283185307179586 3 3 1.5 0.25\n";
  expect_refusal([&] { demand_infinite_added_mass(files.read()); }, {"a.1", "infinite frequency", "PER = 0"});
}

/// About the point 2 m below the still water a surging sphere needs a moment; about its centre it needs none.
TEST(Hemisphere, ModesAreMovedToTheOriginAtTheStillWater) {
  const Database moved = test::sphere();
  DatabaseSettings settings = test::sphere_settings();
  settings.reference.reset();
  const Database unmoved = read_database(test::k_hydro_data / "wec-sim/sphere.1", settings);
  for (std::size_t k = 0; k < moved.frequency.size(); ++k) {
    const double surge = moved.added_mass[k](0, 0);
    EXPECT_NEAR(unmoved.added_mass[k](0, 4), 2 * surge, 5e-3 * surge);
    EXPECT_LT(std::abs(moved.added_mass[k](0, 4)), 5e-3 * surge);
    EXPECT_LT(std::abs(moved.excitation[k][0][4]), 5e-3 * std::abs(moved.excitation[k][0][0]));
  }
}

/// The same sphere by WAMIT and by Capytaine, in both forms of NetCDF: a conjugated load would turn the phase of surge
/// by half a turn.
TEST(Capytaine, AgreesWithWamitOnTheSameSphere) {
  const Database wamit = test::sphere();
  DatabaseSettings settings;
  settings.reference = Vec3(0, 0, -2);
  for (const char* name : {"sphere_capytaine.nc", "sphere_capytaine_hdf5.nc"}) {
    SCOPED_TRACE(name);
    const Database database = read_database(test::k_hydro_data / "wec-sim" / name, settings);
    EXPECT_EQ(database.density, 1000);
    EXPECT_EQ(database.depth, 50);
    EXPECT_FALSE(database.added_mass_infinite);
    EXPECT_EQ(database.notes.size(), 1u);  // two frequencies without numbers
    int compared = 0;
    for (std::size_t k = 0; k < database.frequency.size(); ++k)
      for (std::size_t n = 0; n < wamit.frequency.size(); ++n) {
        if (std::abs(database.frequency[k] - wamit.frequency[n]) > 1e-4 || wamit.frequency[n] > 3) continue;
        ++compared;
        EXPECT_NEAR(database.added_mass[k](2, 2), wamit.added_mass[n](2, 2), 0.02 * wamit.added_mass[n](2, 2));
        EXPECT_NEAR(database.damping[k](2, 2), wamit.damping[n](2, 2), 0.02 * wamit.damping[n].maxCoeff());
        for (const int i : {0, 2}) {
          const auto x = wamit.excitation[n][0][i];
          EXPECT_LT(std::abs(database.excitation[k][0][i] - x), 0.03 * std::abs(x) + 2e3);
        }
      }
    EXPECT_GT(compared, 5);
    EXPECT_NEAR((*database.restoring)(2, 2), (*wamit.restoring)(2, 2), 1e-3 * (*wamit.restoring)(2, 2));
    EXPECT_NEAR((*database.mass)(0, 0), 261364, 1);
  }
}

TEST(Bemio, ReadsTheSphereOfHydroChrono) {
  const Database database = read_database(test::k_hydro_data / "hydrochrono/sphere.h5");
  EXPECT_EQ(database.frequency.size(), 240u);
  EXPECT_NEAR(*database.volume, 261.724, 1e-9);
  EXPECT_EQ(*database.centre_of_gravity, Vec3(0, 0, -2));
  EXPECT_NEAR((*database.added_mass_infinite)(2, 2), 130876.8, 0.1);
  const Database wamit = test::sphere();
  EXPECT_NEAR(database.damping[19](2, 2), 88539, 5);  // w = 1
  EXPECT_GT(database.excitation[19][0][0].imag(), 3e5);
}

/// A database is the same after it was written in another form, to the digits of that form.
TEST(Conversion, KeepsAllValues) {
  const test::ScratchFolder folder;
  Database original = test::fpso();
  original.centre_of_gravity = Vec3(0.788631, 0, -1);
  original.drift.assign(original.frequency.size(), std::vector<Vec6>(original.heading.size(), Vec6::Constant(3e4)));
  write_bemio(original, folder / "fpso.h5");
  write_wamit(original, folder / "fpso", {2, 1025, 9.81});
  DatabaseSettings settings = test::fpso_settings();
  const Database bemio = read_database(folder / "fpso.h5");
  settings.length = 2;
  const Database wamit = read_database(folder / "fpso", settings);
  for (const auto* other : {&bemio, &wamit}) {
    const double digits = other == &bemio ? 1e-12 : 2e-6;
    ASSERT_EQ(other->frequency.size(), original.frequency.size());
    ASSERT_EQ(other->heading.size(), original.heading.size());
    for (std::size_t k = 0; k < original.frequency.size(); ++k) {
      EXPECT_LT((other->added_mass[k] - original.added_mass[k]).norm(), digits * original.added_mass[k].norm());
      EXPECT_LT((other->damping[k] - original.damping[k]).norm(), 1e-12 + digits * original.damping[k].norm());
      for (std::size_t h = 0; h < original.heading.size(); ++h) {
        const auto& x = original.excitation[k][h];
        EXPECT_LT((other->excitation[k][h] - x).norm(), digits * x.norm());
        EXPECT_LT((other->drift[k][h] - original.drift[k][h]).norm(), digits * original.drift[k][h].norm());
      }
    }
    EXPECT_LT((*other->restoring - *original.restoring).norm(), digits * original.restoring->norm());
    EXPECT_LT((*other->added_mass_infinite - *original.added_mass_infinite).norm(),
              digits * original.added_mass_infinite->norm());
  }
  EXPECT_LT((wamit.motion[20][3] - original.motion[20][3]).norm(), 2e-6);
}

TEST(Bemio, NamesTheDatasetThatIsWrong) {
  const test::ScratchFolder folder;
  Database small = test::sphere();
  small.volume = 261;
  write_bemio(small, folder / "a.h5");
  {
    hdf5::Hdf5Writer file;
    file.add_group("simulation_parameters");
    file.add("simulation_parameters/rho", {1, 1}, {1000.0});
    file.save(folder / "b.h5");
  }
  expect_refusal([&] { read_database(folder / "b.h5"); }, {"b.h5: /simulation_parameters/g", "missing"});
  {
    hdf5::Hdf5Writer file;
    file.add("x", {1, 1}, {1.0});
    file.save(folder / "c.h5");
  }
  expect_refusal([&] { read_database(folder / "c.h5"); }, {"c.h5", "no hydrodynamic database", "added_mass"});
  folder.write("d.h5", "text");
  expect_refusal([&] { read_database(folder / "d.h5"); }, {"d.h5", "no HDF5 file"});
  DatabaseSettings settings;
  settings.density = 1025;
  expect_refusal([&] { read_database(folder / "a.h5", settings); }, {"density 1000", "1025"});
  DatabaseSettings scaled;
  scaled.length = 2;
  expect_refusal([&] { read_database(folder / "a.h5", scaled); }, {"length", "WAMIT"});
}

/// A file of the sphere states 200 m, but was computed in deep water; a depth that is given goes before it.
TEST(Database, AGivenDepthGoesBeforeThatOfTheFile) {
  DatabaseSettings settings;
  settings.depth = std::numeric_limits<double>::infinity();
  const Database database = read_database(test::k_hydro_data / "hydrochrono/sphere.h5", settings);
  EXPECT_FALSE(database.depth);
  ASSERT_EQ(database.notes.size(), 1u);
  EXPECT_NE(database.notes[0].find("states the depth 200 m"), std::string::npos);
}

}  // namespace read_database_test
