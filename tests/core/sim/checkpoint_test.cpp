/// A simulation that goes on from a checkpoint gives the bits of one that never stopped; a checkpoint that is not whole
/// is refused.
#include "core/sim/checkpoint.h"

#include <gtest/gtest.h>

#include <bit>
#include <limits>

#include "core/base/error.h"
#include "core/hdf5/hdf5_file.h"
#include "core/scene/read/read_scene.h"
#include "core/sim/simulation.h"
#include "tests/core/sim/together/step_bits.h"
#include "tests/support/file_text.h"
#include "tests/support/refusal.h"
#include "tests/support/scratch_folder.h"

namespace checkpoint_test {

using namespace nilas;
using namespace nilas::sim;
namespace fs = std::filesystem;

const CheckpointOrigin k_origin{"nilas of the tests", "a build", "a fingerprint"};

using Bits = test::StepBits;

struct Case {
  const char* name;
  const char* scene;
};

void PrintTo(const Case& c, std::ostream* out) { *out << c.name; }

#define NILAS_WATER "<water density='1005'/><hydro><buoyancy/><drag form='1' skin='0.005'/></hydro>"
#define NILAS_FRICTION "<friction between='* *' static='0.3' kinetic='0.3'/>"
/// `crushing`: an element.
#define NILAS_BREAKING_ICE(crushing)                                                                               \
  "<contact law='coulomb' solver='nsgs' tolerance='1e-4' max_iterations='200' "                                    \
  "stabilisation='split-impulse'>" NILAS_FRICTION "</contact>" NILAS_WATER                                         \
  "<vessel name='ship' position='0.3 0'>" NILAS_HULL                                                               \
  "<mass draught='0.2'/><carriage speed='0.8' free='heave'/></vessel><ice thickness='0.02'>"                       \
  "<field kind='packed' region='3 -1.5 5.7 1.5' concentration='0.75' breakable='true'>"                            \
  "<size distribution='lognormal' mean='0.6' sd='0.1' min='0.4' max='0.8'/><shape kind='polygon' vertices='5 8'/>" \
  "</field><vary property='flexural_strength' mean='5e3' cov='0.2' correlation_length='0.3'/></ice>"               \
  "<fracture flexural_strength='5e3' compressive_strength='2e4' min_area='1e-3'>" crushing                         \
  "<bending/><splitting/></fracture>"

#define NILAS_PACKED                                                                                                \
  "<ice thickness='0.05'><field kind='packed' region='3 -1.5 5.7 1.5' concentration='0.75'>"                        \
  "<size distribution='lognormal' mean='0.35' sd='0.1' min='0.2' max='0.6'/><shape kind='polygon' vertices='5 8'/>" \
  "</field></ice>"
#define NILAS_HULL "<hull generate='icebreaker' length='3' beam='0.8' draught='0.2' depth='0.4' triangles='600'/>"

#define NILAS_PARTS                                                                                                 \
  "<part name='fin' joint='hinge' shape='box' size='0.5 0.1 0.3' mass='8' position='2.9 0.5 0.2' at='2.6 0.4 0.2' " \
  "rate_deg='60' stiffness='20' damping='0.5'/>"                                                                    \
  "<part name='ram' joint='slider' to='fin' axis='1 0 0' shape='sphere' radius='0.1' mass='2' "                     \
  "position='3.3 0.5 0.2' stiffness='200'/>"                                                                        \
  "<part name='bob' joint='ball' shape='cylinder' radius='0.1' height='0.3' mass='9' position='1.5 0 -0.3' "        \
  "at='1.5 0 -0.05'/>"

constexpr const char* k_towing =
    "<contact law='coulomb' solver='auto' tolerance='1e-5' stabilisation='split-impulse' erp='0.3'>" NILAS_FRICTION
    "</contact>" NILAS_WATER
    "<tank length='9' width='4' depth='1' wall_thickness='0.2' floor='true'/>"
    "<vessel name='ship' position='0.1 0'>" NILAS_HULL
    "<mass draught='0.2'/><carriage speed='0.8' ramp='0.05' free='heave'>"
    "<force_balance kind='six-cells' stiffness='1e6' damping='1e3'/></carriage></vessel>" NILAS_PACKED;

const std::vector<Case> k_cases{
    {"TowingOnSixCells", k_towing},
    {"FreeVessel", "<contact law='coulomb' solver='nsgs' tolerance='1e-6' stabilisation='projection'>" NILAS_FRICTION
                   "</contact>" NILAS_WATER
                   "<vessel name='ship' position='0.1 0' velocity='1 0 0' angular_velocity='0.02 0.05 0.1'>" NILAS_HULL
                   "<mass draught='0.2'/></vessel>" NILAS_PACKED},
    {"ElasticTowing",
     "<contact law='coulomb' solver='auto' tolerance='1e-4'><friction between='* *' kinetic='0.3' elastic='true'/>"
     "</contact>" NILAS_WATER "<vessel name='ship' position='0.1 0'>" NILAS_HULL
     "<mass draught='0.2'/><carriage speed='0.8' ramp='0.05' free='heave'/></vessel>" NILAS_PACKED},
    {"ElasticIceThatBreaks",
     "<contact law='coulomb' solver='nsgs' tolerance='1e-4'><friction between='ice ice' kinetic='0.3' elastic='true'/>"
     "<friction between='hull ice' kinetic='0.1'/></contact>" NILAS_WATER
     "<vessel name='ship' position='0.3 0'>" NILAS_HULL
     "<mass draught='0.2'/><carriage speed='0.8' free='heave'/></vessel><ice thickness='0.02'>"
     "<field kind='packed' region='3 -1.5 5.7 1.5' concentration='0.85' breakable='true'>"
     "<size distribution='lognormal' mean='0.6' sd='0.1' min='0.4' max='0.8'/><shape kind='polygon' vertices='5 8'/>"
     "</field></ice><fracture flexural_strength='5e3' compressive_strength='2e4' min_area='1e-3'>"
     "<crushing model='compliant'/><bending/><splitting/></fracture>"},
    {"ElasticPileOnASlope",
     "<contact law='coulomb' solver='nsgs' tolerance='1e-7'><friction between='* *' kinetic='0.3' elastic='true' "
     "stiffness='1e5'/>"
     "</contact><gravity value='2.5 0 -9.4'/><body name='ground' shape='plane' fixed='true'/>"
     "<body shape='box' size='0.4 0.3 0.2' mass='2' position='0 0 0.12' rotation_deg='10 3 5'/>"
     "<body shape='box' size='0.3 0.3 0.3' mass='1' position='0.05 0.02 0.45' rotation_deg='33 20 0'/>"
     "<body shape='sphere' radius='0.1' mass='1' position='-0.5 0 0.3' velocity='1 0 0'/>"
     "<body shape='cylinder' radius='0.1' height='0.2' mass='1' position='0.6 0 0.25' velocity='-1 0 -1'/>"},
    {"FclsContacts",
     "<contact law='coulomb' solver='nsgs' tolerance='1e-6' narrow_phase='fcl'>" NILAS_FRICTION "</contact>" NILAS_WATER
     "<vessel name='ship' position='0.1 0' velocity='1 0 0'>" NILAS_HULL "<mass draught='0.2'/></vessel>" NILAS_PACKED},
    {"FreeVesselWithParts",
     "<contact law='coulomb' solver='nsgs' tolerance='1e-6' stabilisation='projection'>" NILAS_FRICTION
     "</contact>" NILAS_WATER "<vessel name='ship' position='0.1 0 -0.2' velocity='1 0 0'>" NILAS_HULL
     "<mass value='300'/>" NILAS_PARTS "</vessel>" NILAS_PACKED},
    {"TowedVesselWithPartsUnderMoreau",
     "<contact law='coulomb' solver='nsgs' tolerance='1e-6' stabilisation='projection' "
     "integrator='moreau'>" NILAS_FRICTION "</contact>" NILAS_WATER
     "<vessel name='ship' position='0.1 0 -0.2'>" NILAS_HULL
     "<mass value='300'/><carriage speed='0.8' ramp='0.2' free='heave pitch'/>" NILAS_PARTS "</vessel>" NILAS_PACKED},
    {"FreeVesselOnRods",
     "<contact law='coulomb' solver='nsgs' tolerance='1e-6' integrator='moreau'>" NILAS_FRICTION
     "</contact>" NILAS_WATER "<vessel name='ship' position='0.1 0 -0.2'>" NILAS_HULL "<mass value='300'/>" NILAS_PARTS
     "<rod name='tie' at='0 0 0.3' to='-3 0 0.1'/><rod name='strut' on='bob' at='1.5 0 -0.3' to='1.5 -2 -1'/>"
     "</vessel>" NILAS_PACKED},
    {"TowedVesselOnCellsWithAPartOnARod",
     "<contact law='coulomb' solver='nsgs' tolerance='1e-6' integrator='moreau'>" NILAS_FRICTION
     "</contact>" NILAS_WATER "<vessel name='ship' position='0.1 0 -0.2'>" NILAS_HULL
     "<mass value='300'/><carriage speed='0.8' ramp='0.2'><force_balance kind='six-cells'/></carriage>" NILAS_PARTS
     "<rod name='strut' on='bob' at='1.5 0 -0.3' to='1.5 -20 -3'/></vessel>" NILAS_PACKED},
    {"CrushingBreakableIce",
     "<contact law='coulomb' solver='auto' tolerance='1e-6' stabilisation='projection'>" NILAS_FRICTION
     "</contact>" NILAS_WATER "<vessel name='ship' position='0.3 0'>" NILAS_HULL
     "<mass draught='0.2'/><carriage speed='0.8' free='heave'/></vessel><ice thickness='0.05'>"
     "<field kind='packed' region='3 -1.5 5.7 1.5' concentration='0.75' breakable='true'>"
     "<size distribution='lognormal' mean='0.35' sd='0.1' min='0.2' max='0.6'/><shape kind='polygon' vertices='5 8'/>"
     "</field><vary property='compressive_strength' cov='0.2' correlation_length='0.3'/></ice>"
     "<fracture compressive_strength='2e3'><crushing model='compliant'/></fracture>"},
    {"BreakingIce", NILAS_BREAKING_ICE("<crushing model='explicit'/>")},
    {"BreakingIceThatCrushesItself", NILAS_BREAKING_ICE("<crushing model='compliant' between_floes='true'/>")},
    {"PitchingOnACarriage",
     "<contact law='pyramid' solver='pgs' tolerance='0' max_iterations='30' "
     "stabilisation='split-impulse'>" NILAS_FRICTION "</contact>" NILAS_WATER
     "<vessel name='ship' position='0.1 0'>" NILAS_HULL
     "<mass draught='0.2'/><carriage speed='0.8' free='heave pitch roll'/></vessel>" NILAS_PACKED},
    {"StaticAboveKinetic",
     "<contact law='coulomb' solver='nsgs' tolerance='1e-9'><friction between='* *' static='0.6' "
     "kinetic='0.2'/></contact>"
     "<gravity value='4.5 0 -8.7'/><body name='ground' shape='plane' fixed='true'/>"
     "<body shape='box' size='0.4 0.3 0.2' mass='2' position='0 0 0.1'/>"
     "<body shape='box' size='0.4 0.3 0.2' mass='2' position='0.02 0 0.3' velocity='1 0 0'/>"
     "<body shape='box' size='0.4 0.3 0.2' mass='2' position='0.8 0 0.1' velocity='0.5 0.1 0'/>"
     "<body shape='cylinder' radius='0.2' height='0.5' mass='1' position='-1 0 0.25' velocity='0.6 0 0'/>"},
    {"BaumgarteWithAPileOfBoxes",
     "<contact law='coulomb' solver='nsgs' tolerance='1e-7' stabilisation='baumgarte' erp='0.2'>" NILAS_FRICTION
     "</contact><body name='ground' shape='plane' fixed='true'/>"
     "<body shape='box' size='0.4 0.3 0.2' mass='2' position='0 0 0.12' rotation_deg='10 3 5'/>"
     "<body shape='box' size='0.3 0.3 0.3' mass='1' position='0.05 0.02 0.45' rotation_deg='33 20 0'/>"
     "<body shape='box' size='0.5 0.2 0.1' mass='1.5' position='-0.1 0 0.75' rotation_deg='0 0 20'/>"},
    {"MoreauWithBouncingBodies",
     "<contact law='coulomb' solver='nsgs' tolerance='1e-10' stabilisation='projection' integrator='moreau'>"
     "<friction between='* *' static='0.4' kinetic='0.4' restitution='0.7'/></contact>"
     "<body name='ground' shape='plane' fixed='true'/>"
     "<body shape='sphere' radius='0.1' mass='1' position='0 0 0.3'/>"
     "<body shape='box' size='0.2 0.2 0.1' mass='1' position='0.05 0 0.5' angular_velocity='1 2 3'/>"
     "<body shape='box' size='0.2 0.2 0.1' mass='1' position='0.4 0 0.2' velocity='-1 0 0'/>"
     "<body shape='cylinder' radius='0.1' height='0.2' mass='1' position='-0.3 0 0.25' velocity='1 0 -1'/>"},
    {"MeshBodies",
     "<contact law='coulomb' solver='auto' tolerance='1e-8' stabilisation='projection'>" NILAS_FRICTION
     "</contact>" NILAS_WATER "<body name='shelf' shape='box' size='3 3 0.2' position='0 0 -0.1' fixed='true'/>"
     "<body shape='mesh' mesh='wedge.stl' density='1500' position='0 0 0.05'/>"
     "<body shape='mesh' mesh='wedge.stl' density='1500' position='0.1 0.05 0.5' velocity='0 0 -1' rotation_deg='20 40 "
     "60'/>"
     "<body shape='mesh' mesh='wedge.stl' density='500' position='-0.3 0.2 0.6' rotation_deg='80 10 30'/>"},
    {"OrderFreeGridWithoutWarmStart",
     "<contact law='coulomb' solver='eg-order-free' tolerance='1e-4' warm_start='false'>" NILAS_FRICTION
     "</contact>" NILAS_WATER
     "<ice thickness='0.05'><field kind='grid' region='0 -1 2 1' rows='4' columns='4' gap='0.002'/>"
     "<floe outline='-0.6 -0.3 -0.05 -0.2 -0.05 0.25 -0.6 0.2' velocity='1 0 0'/></ice>"}};

/// A tetrahedron of 0.3 m legs.
constexpr const char* k_wedge =
    "solid wedge\n"
    "facet normal 0 0 -1\nouter loop\nvertex 0 0 0\nvertex 0 0.3 0\nvertex 0.3 0 0\nendloop\nendfacet\n"
    "facet normal 0 -1 0\nouter loop\nvertex 0 0 0\nvertex 0.3 0 0\nvertex 0 0 0.3\nendloop\nendfacet\n"
    "facet normal -1 0 0\nouter loop\nvertex 0 0 0\nvertex 0 0 0.3\nvertex 0 0.3 0\nendloop\nendfacet\n"
    "facet normal 1 1 1\nouter loop\nvertex 0.3 0 0\nvertex 0 0.3 0\nvertex 0 0 0.3\nendloop\nendfacet\n"
    "endsolid wedge\n";

class GoingOn : public ::testing::TestWithParam<Case> {
 protected:
  GoingOn() {
    folder.write("wedge.stl", k_wedge);
    scene = scene::read_scene(folder.write(
        "scene.xml", std::string("<scene version='1'><time step='0.01' end='10'/>") + GetParam().scene + "</scene>"));
  }
  std::unique_ptr<Simulation> build(int threads = 1) { return std::make_unique<Simulation>(scene, threads, warnings); }

  test::ScratchFolder folder;
  scene::Scene scene;
  WarningCounts warnings{make_logger("off", "")};
};

/// Saved, written, read and restored again at several steps, and where ice has just broken: each goes on alike,
/// whatever its number of threads, and one that is saved again in between too.
TEST_P(GoingOn, GivesTheSameBits) {
  constexpr int k_steps = 80;
  const std::vector<int> saved_after{0, 1, 13, 40, 60};
  std::vector<Bits> expected;
  std::map<int, State> states;
  const auto whole = build();
  long contacts = 0, broken = 0;
  bool breaking = false;
  for (int k = 0;; ++k) {
    if (breaking || std::count(saved_after.begin(), saved_after.end(), k) > 0) whole->save(StateWriter(states[k]));
    if (k == k_steps) break;
    const StepRecord record = whole->step();
    contacts += record.contacts;
    breaking = broken == 0 && !record.broken.empty();
    broken += static_cast<long>(record.broken.size());
    expected.emplace_back(record);
  }
  EXPECT_GT(contacts, 30) << "nothing touches, so nothing is tested";
  const bool breaks = scene.fracture && scene.fracture->bending;
  EXPECT_GE(broken, breaks ? 5 : 0) << "nothing breaks, so nothing is tested";
  for (auto& [first, state] : states) {
    const fs::path file = folder / "checkpoint.h5";
    write_checkpoint(file, k_origin, state);
    auto rest = build(first == 60 ? 2 : 1);
    const State read = read_checkpoint(file, k_origin);
    rest->restore(StateReader(read));
    EXPECT_EQ(rest->steps(), first);
    for (int k = first; k < k_steps; ++k) {
      if (k == 50) {
        State again;
        rest->save(StateWriter(again));
        rest = build();
        rest->restore(StateReader(again));
      }
      ASSERT_EQ(Bits(rest->step()), expected[k]) << "saved after " << first << ", step " << k + 1;
    }
  }
}

TEST_P(GoingOn, SavesAllThatItRestores) {
  const auto one = build();
  for (int k = 0; k < 20; ++k) one->step();
  State state, again;
  one->save(StateWriter(state));
  const auto other = build();
  other->restore(StateReader(state));
  other->save(StateWriter(again));
  EXPECT_EQ(again.entries, state.entries);
}

INSTANTIATE_TEST_SUITE_P(All, GoingOn, ::testing::ValuesIn(k_cases),
                         [](const auto& instance) { return instance.param.name; });

/// A pair that no <friction> names is told once, also by a run that goes on.
TEST(Checkpoint, DoesNotWarnAgain) {
  const test::ScratchFolder folder;
  const scene::Scene scene = scene::read_scene(
      folder.write("scene.xml",
                   "<scene version='1'><contact><friction between='ice ice' static='0.3' kinetic='0.3'/></contact>"
                   "<body name='ground' shape='plane' fixed='true'/><body shape='box' position='0 0 0.5'/></scene>"));
  WarningCounts warnings{make_logger("off", "")}, of_the_rest{make_logger("off", "")};
  Simulation whole(scene, 1, warnings);
  whole.step();
  ASSERT_EQ(warnings.counts().size(), 1u);
  State state;
  StateWriter out(state);
  whole.save(out.group("simulation"));
  warnings.save(out.group("warnings"));
  Simulation rest(scene, 1, of_the_rest);
  const StateReader in(state);
  rest.restore(in.group("simulation"));
  rest.step();
  EXPECT_TRUE(of_the_rest.counts().empty());
  of_the_rest.restore(in.group("warnings"));
  EXPECT_EQ(of_the_rest.counts(), warnings.counts());
}

TEST(Checkpoint, RefusesTheStateOfAnotherScene) {
  const test::ScratchFolder folder;
  const auto scene = [&](const std::string& bodies) {
    return scene::read_scene(folder.write("scene.xml", "<scene version='1'>" + bodies + "</scene>"));
  };
  WarningCounts warnings{make_logger("off", "")};
  const std::string one = "<body shape='box' position='0 0 0'/>";
  Simulation simulation(scene(one), 1, warnings);
  State state;
  simulation.save(StateWriter(state));
  Simulation other(scene(one + "<body shape='box' position='0 0 5'/>"), 1, warnings);
  EXPECT_THROW(other.restore(StateReader(state)), InputError);
}

State sample_state() {
  State state;
  StateWriter out(state);
  const double tiny = std::numeric_limits<double>::denorm_min(), infinite = std::numeric_limits<double>::infinity();
  out.add("numbers", std::vector<double>{0.1, -0.0, tiny, infinite, std::bit_cast<double>(0x7ff8000000000123ULL)});
  out.add("none", std::vector<double>{});
  out.group("deep").group("er").add("keys", std::vector<std::uint64_t>{0, ~0ULL, 0x8000000000000000ULL});
  out.group("deep").add("kind", std::string("frictionless ice 'hull'"));
  out.group("deep").add("q", Quat(0.5, 0.1, 0.2, 0.3));
  out.group("deep").add("inertia", std::vector<Mat3>(100, Mat3::Constant(0.3)));
  return state;
}

/// NaN compares unequal, its bits do not.
std::vector<std::uint64_t> bits_of(const State& state, const std::string& name) {
  std::vector<std::uint64_t> bits;
  for (const double x : std::get<std::vector<double>>(state.entries.at(name)))
    bits.push_back(std::bit_cast<std::uint64_t>(x));
  return bits;
}

TEST(Checkpoint, KeepsEveryBit) {
  const test::ScratchFolder folder;
  const State state = sample_state();
  write_checkpoint(folder / "c.h5", k_origin, state);
  const State read = read_checkpoint(folder / "c.h5", k_origin);
  ASSERT_EQ(read.entries.size(), state.entries.size());
  for (const auto& [name, entry] : state.entries) {
    if (name == "numbers")
      EXPECT_EQ(bits_of(read, name), bits_of(state, name));
    else
      EXPECT_EQ(read.entries.at(name), entry) << name;
  }
  std::vector<std::uint64_t> keys;
  StateReader(read).group("deep").group("er").get("keys", keys);
  EXPECT_EQ(keys, (std::vector<std::uint64_t>{0, ~0ULL, 0x8000000000000000ULL}));
  EXPECT_FALSE(fs::exists(folder / "c.h5.part"));
}

TEST(Checkpoint, CutShortAnywhereIsRefused) {
  const test::ScratchFolder folder;
  write_checkpoint(folder / "c.h5", k_origin, sample_state());
  const std::string whole = test::read_text(folder / "c.h5");
  ASSERT_GT(whole.size(), 2000u);
  std::vector<std::size_t> lengths{0, 1, 7, 8, 100, 512, 1000, whole.size() / 2, whole.size() - 1};
  for (std::size_t length = 64; length < whole.size(); length += whole.size() / 40) lengths.push_back(length);
  for (const std::size_t length : lengths) {
    folder.write("cut.h5", whole.substr(0, length));
    EXPECT_THROW(read_checkpoint(folder / "cut.h5", k_origin), InputError) << length << " bytes of " << whole.size();
  }
}

/// A changed byte either breaks the file, or is none of the content (HDF5 leaves gaps); never another state.
TEST(Checkpoint, AChangedByteGivesNoOtherState) {
  const test::ScratchFolder folder;
  const State state = sample_state();
  write_checkpoint(folder / "c.h5", k_origin, state);
  const std::string whole = test::read_text(folder / "c.h5");
  int refused = 0;
  for (std::size_t place = 0; place < whole.size(); place += 97) {
    std::string changed = whole;
    changed[place] = static_cast<char>(changed[place] ^ 0x10);
    folder.write("changed.h5", changed);
    try {
      const State read = read_checkpoint(folder / "changed.h5", k_origin);
      EXPECT_EQ(bits_of(read, "numbers"), bits_of(state, "numbers")) << place;
      EXPECT_EQ(read.entries.at("deep/inertia"), state.entries.at("deep/inertia")) << place;
      EXPECT_EQ(read.entries.at("deep/er/keys"), state.entries.at("deep/er/keys")) << place;
    } catch (const InputError&) {
      ++refused;
    }
  }
  EXPECT_GT(refused, 70);
}

void expect_refusal(const fs::path& file, const CheckpointOrigin& origin, const std::string& word) {
  test::expect_refusal([&] { read_checkpoint(file, origin); }, {word, file.string()});
}

void write_with_version(const std::string& format, int version, const fs::path& path) {
  hdf5::Hdf5Writer file;
  file.add("format", format);
  file.add("version", std::vector<int>{version});
  file.save(path);
}

TEST(Checkpoint, OfAnotherVersionProgramOrSceneIsRefused) {
  const test::ScratchFolder folder;
  const fs::path file = folder / "c.h5";
  write_checkpoint(file, k_origin, sample_state());
  expect_refusal(file, {"nilas of tomorrow", k_origin.build, k_origin.scene}, "was written by nilas of the tests");
  expect_refusal(file, {k_origin.program, "another", k_origin.scene}, "another build of the same version");
  expect_refusal(file, {k_origin.program, k_origin.build, "another"}, "belongs to another scene");

  write_with_version("nilas checkpoint", k_checkpoint_version + 1, file);
  expect_refusal(file, k_origin, "version " + std::to_string(k_checkpoint_version + 1));
  write_with_version("something else", k_checkpoint_version, file);
  expect_refusal(file, k_origin, "is no checkpoint");
  folder.write("text.h5", "not at all");
  expect_refusal(folder / "text.h5", k_origin, "is no HDF5 file");
}

TEST(Checkpoint, ThatCannotBeOpenedIsAFileError) {
  const test::ScratchFolder folder;
  EXPECT_THROW(read_checkpoint(folder / "none.h5", k_origin), FileError);
  EXPECT_THROW(read_checkpoint(folder.path(), k_origin), FileError);
  EXPECT_THROW(write_checkpoint(folder / "none/c.h5", k_origin, sample_state()), FileError);
}

TEST(State, SaysWhatIsWrong) {
  const State state = sample_state();
  const StateReader in(state);
  double number = 0;
  std::vector<Vec3> vectors;
  std::vector<double> numbers;
  std::string text;
  EXPECT_THROW(in.get("number", number), InputError) << "missing";
  EXPECT_THROW(in.get("numbers", number), InputError) << "five in place of one";
  EXPECT_THROW(in.get("numbers", vectors), InputError) << "five are no vectors";
  EXPECT_THROW(in.get("numbers", numbers, 4), InputError);
  EXPECT_THROW(in.get("numbers", text), InputError) << "another kind";
  State twice;
  StateWriter out(twice);
  out.add("a", 1.0);
  EXPECT_THROW(out.add("a", 2.0), ContractError);
}

}  // namespace checkpoint_test
