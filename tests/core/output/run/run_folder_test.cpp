#include "core/output/run/run_folder.h"

#include <gtest/gtest.h>
#include <spdlog/sinks/ostream_sink.h>
#include <tinyxml2.h>

#include "core/base/error.h"
#include "core/output/run/run_summary.h"
#include "tests/core/output/sample_run.h"
#include "tests/support/file_text.h"
#include "tests/support/refusal.h"

namespace nilas::output {
namespace run_folder_test {

namespace fs = std::filesystem;
using test::full_record;
using test::full_run;
using test::lines_of;
using test::read_text;
using test::sample_bodies;
using test::ScratchFolder;

/// A run of `steps` equal steps into `folder`.
class SampleRun {
 public:
  explicit SampleRun(const fs::path& path) : folder(path, false) {
    scene.as_run = "<nilas version=\"1\"/>\n";
    scene.ice.emplace();
    scene.vessel.emplace();
    scene.water.emplace();
    record.ledger.works = {0, 0};
  }
  void begin() {
    folder.open(scene, info, warnings);
    folder.start(0, sim::Ledger{.works = {0, 0}}, bodies);
  }
  void steps(int count) {
    for (int k = 0; k < count; ++k) {
      record.step = ++done;
      record.t = static_cast<double>(done) * record.h;
      folder.record(record, {solved}, bodies);
    }
  }

  std::ostringstream log;
  WarningCounts warnings{
      std::make_shared<spdlog::logger>("test", std::make_shared<spdlog::sinks::ostream_sink_mt>(log))};
  sim::RunInfo info = full_run();
  scene::Scene scene;
  bodies::Bodies bodies = sample_bodies();
  sim::StepRecord record = full_record();
  contact::SolvedProblem solved;
  RunFolder folder;
  long done = 0;
};

TEST(RunFolder, HoldsEveryCompleteStepAtAnyMoment) {
  const ScratchFolder scratch;
  SampleRun run(scratch / "deep/run");
  run.begin();
  run.steps(25);
  const fs::path folder = run.folder.path();
  EXPECT_EQ(read_text(folder / "scene.xml"), "<nilas version=\"1\"/>\n");
  EXPECT_EQ(lines_of(folder / "vessel.csv").size(), 1u + 25);
  EXPECT_EQ(lines_of(folder / "steps.csv").size(), 1u + 25);
  EXPECT_EQ(lines_of(folder / "bodies.csv").size(), 1u + 4 * 3) << "snapshots at 0, 0.1 and 0.2 s";
  EXPECT_TRUE(fs::exists(folder / "trajectory/step-000020-ice.vtp"));
  EXPECT_FALSE(fs::exists(folder / "trajectory/step-000021-ice.vtp"));
  tinyxml2::XMLDocument list;
  EXPECT_EQ(list.LoadFile((folder / "trajectory.pvd").c_str()), tinyxml2::XML_SUCCESS);
  EXPECT_FALSE(fs::exists(folder / "summary.json"));
}

TEST(RunFolder, OpensOnlyWhatTheSceneAsksFor) {
  const ScratchFolder scratch;
  SampleRun run(scratch / "run");
  run.scene.output.trajectory_every = 0;
  run.info.has_vessel = run.info.has_carriage = run.info.has_cells = run.info.has_hydro = false;
  run.begin();
  run.steps(3);
  std::vector<std::string> names;
  for (const auto& entry : fs::directory_iterator(run.folder.path())) names.push_back(entry.path().filename());
  std::sort(names.begin(), names.end());
  EXPECT_EQ(names, (std::vector<std::string>{"nilas.log", "scene.xml", "steps.csv"}));
}

TEST(RunFolder, WritesBodiesByCountOrByWish) {
  const auto has_bodies_csv = [](int count, std::optional<bool> wish) {
    const ScratchFolder scratch;
    SampleRun run(scratch / "run");
    run.scene.output.bodies = wish;
    while (run.bodies.size() < count)
      test::add_body(run.bodies, "floe", bodies::BodyKind::floe, bodies::Motion::free, test::triangle_floe(), 1,
                     Vec3::Zero());
    run.info.bodies = run.bodies.size();
    run.begin();
    return fs::exists(run.folder.path() / "bodies.csv");
  };
  EXPECT_TRUE(has_bodies_csv(200, {}));
  EXPECT_FALSE(has_bodies_csv(201, {}));
  EXPECT_TRUE(has_bodies_csv(201, true));
  EXPECT_FALSE(has_bodies_csv(4, false));
}

TEST(RunFolder, SnapshotsFallOnTheStepNearestToTheirTime) {
  const ScratchFolder scratch;
  SampleRun run(scratch / "run");
  run.record.h = 0.03;
  run.begin();
  run.steps(10);
  std::vector<std::string> times;
  for (const auto& row : lines_of(run.folder.path() / "bodies.csv"))
    if (row.find(",hull,") != std::string::npos) times.push_back(row.substr(0, row.find(',')));
  ASSERT_EQ(times.size(), 4u);
  EXPECT_NEAR(std::stod(times[1]), 0.09, 1e-15);
  EXPECT_NEAR(std::stod(times[2]), 0.21, 1e-15);
  EXPECT_NEAR(std::stod(times[3]), 0.30, 1e-15);
}

TEST(RunFolder, WarnsOnceOfGimbalLock) {
  const ScratchFolder scratch;
  SampleRun run(scratch / "run");
  run.record.vessel->state.pose.q = Quat(Eigen::AngleAxisd(0.5 * k_pi, Vec3::UnitY()));
  run.begin();
  run.steps(3);
  EXPECT_EQ(run.warnings.counts().at("gimbal lock"), 3);
  EXPECT_NE(run.log.str().find("90 degrees"), std::string::npos);
}

TEST(RunFolder, SummaryTellsTheRun) {
  const ScratchFolder scratch;
  SampleRun run(scratch / "run");
  run.begin();
  run.steps(1);
  run.record.vessel->contact.force.x() = -3;
  run.steps(1);
  SummaryInput input;
  input.wall_s = 0.005;
  input.processor_s = 0.004;
  input.seed = 7;
  input.threads = 2;
  input.crushed_mass = 1.5;
  input.machine = "2 cores";
  input.versions = {{"eigen", "3.4.0"}};
  run.folder.finish(input, run.bodies);
  const auto summary = nlohmann::json::parse(read_text(run.folder.path() / "summary.json"));
  EXPECT_EQ(summary["status"], "done");
  EXPECT_EQ(summary["exit_code"], 0);
  EXPECT_EQ(summary["time_end_s"], 0.02);
  EXPECT_EQ(summary["steps"], 2);
  EXPECT_EQ(summary["wall_s"], 0.005);
  EXPECT_EQ(summary["processor_s"], 0.004);
  EXPECT_DOUBLE_EQ(summary["real_time_factor"], 4);
  EXPECT_EQ(summary["vessel"]["mass_kg"], 1500);
  EXPECT_EQ(summary["vessel"]["cog_m"], (std::vector<double>{2, 0, 0.25}));
  EXPECT_EQ(summary["vessel"]["inertia_kg_m2"], (std::vector<double>{10, 20, 30, -4, -5, -6}));
  EXPECT_EQ(summary["tare"]["carriage_fz_N"], 7);
  EXPECT_EQ(summary["tare"]["carriage_my_Nm"], -2);
  EXPECT_EQ(summary["tare"]["cell6_N"], -0.5);
  EXPECT_TRUE(summary["loads"].contains("cell6_tared_N"));
  EXPECT_FALSE(summary["loads"].contains("cell6_N"));
  EXPECT_EQ(summary["ice"]["floes"], 2);
  EXPECT_EQ(summary["ice"]["mass_kg"], 30);
  EXPECT_EQ(summary["ice"]["mass_end_kg"], 10) << "the fixed floe does not count";
  EXPECT_EQ(summary["ice"]["brash_kg"], 0);
  EXPECT_EQ(summary["ice"]["crushed_kg"], 1.5);
  EXPECT_EQ(summary["ice"]["concentration"], 0.8);
  EXPECT_EQ(summary["worst"]["law_map_m_s"]["value"], 1e-7);
  EXPECT_EQ(summary["worst"]["law_map_m_s"]["time_s"], 0.01);
  EXPECT_EQ(summary["worst"]["penetration_max_m"]["value"], 0.002);
  EXPECT_TRUE(summary["worst"].contains("imbalance_J"));
  EXPECT_EQ(summary["loads"].size(), 32u);
  EXPECT_EQ(summary["loads"]["contact_fx_N"]["mean"], -1);
  EXPECT_EQ(summary["loads"]["contact_fx_N"]["std"], 2);
  EXPECT_EQ(summary["loads"]["contact_fx_N"]["max"], 3);
  EXPECT_DOUBLE_EQ(summary["loads"]["contact_fx_N"]["p99"], 2.98);
  EXPECT_EQ(summary["modules"]["built"][1]["name"], "carriage");
  EXPECT_EQ(summary["modules"]["ms_per_step"]["solver"], 4);
  EXPECT_EQ(summary["not_built"], (std::vector<std::string>{"waves"}));
  const RunSummary read = read_run_summary(run.folder.path());
  EXPECT_EQ(read.status, "done");
  EXPECT_EQ(read.seed, 7U);
  EXPECT_EQ(read.steps, 2);
  EXPECT_EQ(read.loads.size(), 32u);
  EXPECT_DOUBLE_EQ(read.load("contact_fx_N")->p99, 2.98);
  EXPECT_EQ(read.residuals.law_map_m_s, 1e-7);
  EXPECT_EQ(read.penetration_max_m, 0.002);
  EXPECT_EQ(read.phase_ms[static_cast<std::size_t>(sim::Phase::solver)], 4);
  EXPECT_TRUE(read.window);
  EXPECT_EQ(summary["versions"]["eigen"], "3.4.0");
  for (const auto& [name, version] : summary["versions"].items()) EXPECT_NE(version, "") << name;
  EXPECT_EQ(summary["seed"], 7);
  EXPECT_EQ(summary["threads"], 2);
  EXPECT_EQ(summary["machine"], "2 cores");
}

/// 2048 steps fill four blocks of the statistics.
TEST(RunFolder, KeepsTheNumbersOfManyStepsInAFileAndNotInTheCheckpoint) {
  const ScratchFolder scratch;
  const sim::CheckpointOrigin origin{"test", "build", "sample"};
  SampleRun whole(scratch / "whole");
  std::vector<std::uintmax_t> checkpoints;
  const auto vary = [](SampleRun& run) {
    run.record.vessel->contact.force.x() = std::sin(0.1 * static_cast<double>(run.done));
  };
  const auto record = [&](SampleRun& run, int count) {
    for (int k = 0; k < count; ++k) {
      vary(run);
      run.steps(1);
    }
  };
  SampleRun rest(scratch / "elsewhere");
  for (SampleRun* run : {&whole, &rest}) {
    run->scene.output.trajectory_every = 0;
    run->scene.output.contacts = StoredContacts::none;
  }
  whole.begin();
  for (int k = 0; k < 4; ++k) {
    record(whole, StepSeries::k_block);
    whole.folder.write_checkpoint(origin, {});
    checkpoints.push_back(fs::file_size(whole.folder.checkpoint_file()));
  }
  EXPECT_EQ(checkpoints[3], checkpoints[1]);
  const auto block = StepSeries::k_block * sizeof(double) * RunStatistics::numbers_per_step(whole.info);
  EXPECT_EQ(fs::file_size(scratch / "whole/statistics.bin"), 4 * block);

  const State state = sim::read_checkpoint(whole.folder.checkpoint_file(), origin);
  fs::create_directory(scratch / "cut");
  for (const char* file : {"steps.csv", "vessel.csv", "statistics.bin", "nilas.log"})
    fs::copy_file(scratch.path() / "whole" / file, scratch.path() / "cut" / file);
  std::ofstream(scratch / "cut/statistics.bin", std::ios::app) << std::string(block + 9, 'x');
  RunFolder cut(scratch / "cut", RunLock(scratch / "cut"));
  cut.resume(rest.scene, rest.info, rest.warnings, StateReader(state).group("outputs"));
  rest.done = whole.done;
  record(whole, 700);
  for (int k = 0; k < 700; ++k) {
    vary(rest);
    rest.record.step = ++rest.done;
    rest.record.t = static_cast<double>(rest.done) * rest.record.h;
    cut.record(rest.record, {rest.solved}, rest.bodies);
  }
  EXPECT_EQ(read_text(scratch / "cut/statistics.bin"), read_text(scratch / "whole/statistics.bin"));
  const auto loads = whole.folder.finish({}, whole.bodies)["loads"];
  EXPECT_EQ(cut.finish({}, rest.bodies)["loads"], loads);
  EXPECT_TRUE(fs::exists(scratch / "whole/statistics.bin")) << "its checkpoint needs it";
  EXPECT_FALSE(fs::exists(scratch / "cut/statistics.bin")) << "it cannot be resumed";
}

/// Goes on in a folder that holds more than the checkpoint: half a row, frames of later steps.
TEST(RunFolder, GoesOnFromItsCheckpoint) {
  const ScratchFolder scratch;
  const sim::CheckpointOrigin origin{"test", "build", "sample"};
  const auto begin = [&](SampleRun& run) {
    run.begin();
    run.steps(25);
    run.folder.write_checkpoint(origin, {});
    run.steps(30);
  };
  SampleRun whole(scratch / "whole");
  begin(whole);
  {
    SampleRun cut(scratch / "cut");
    begin(cut);
  }
  std::ofstream(scratch / "cut/steps.csv", std::ios::app) << "0.5";
  std::ofstream(scratch / "cut/trajectory/step-000099.vtp") << "later";
  std::ofstream(scratch / "cut/trajectory/step-000099-forces.vtp") << "later";

  SampleRun rest(scratch / "elsewhere");
  RunFolder folder(scratch / "cut", RunLock(scratch / "cut"));
  const State state = sim::read_checkpoint(folder.checkpoint_file(), origin);
  folder.resume(rest.scene, rest.info, rest.warnings, StateReader(state).group("outputs"));
  EXPECT_EQ(lines_of(scratch / "cut/steps.csv").size(), 1u + 25);
  EXPECT_EQ(lines_of(scratch / "cut/bodies.csv").size(), 1u + 4 * 3);
  for (int k = 0; k < 30; ++k) {
    rest.record.step = 26 + k;
    rest.record.t = static_cast<double>(rest.record.step) * rest.record.h;
    folder.record(rest.record, {rest.solved}, rest.bodies);
  }
  EXPECT_EQ(folder.finish({}, rest.bodies)["loads"], whole.folder.finish({}, whole.bodies)["loads"]);
  for (const char* file : {"vessel.csv", "bodies.csv", "trajectory.pvd", "scene.xml"})
    EXPECT_EQ(read_text(scratch.path() / "cut" / file), read_text(scratch.path() / "whole" / file)) << file;
  EXPECT_EQ(lines_of(scratch / "cut/steps.csv").size(), 1u + 55);
  EXPECT_FALSE(fs::exists(scratch / "cut/trajectory/step-000099.vtp"));
  EXPECT_FALSE(fs::exists(scratch / "cut/trajectory/step-000099-forces.vtp"));
  EXPECT_TRUE(fs::exists(scratch / "cut/trajectory/water.vtp"));
  EXPECT_TRUE(fs::exists(scratch / "cut/trajectory/step-000050-ice.vtp"));
}

TEST(RunFolder, RefusesAFolderThatHoldsSomething) {
  const ScratchFolder scratch;
  std::ofstream(scratch / "notes.txt") << "mine";
  test::expect_refusal([&] { RunFolder folder(scratch.path(), false); }, {"--force"});
}

/// Stopped while it wrote its first file, a run has left nothing that another could spoil.
TEST(RunFolder, TakesAFolderThatARunLeftBeforeItsFirstStep) {
  const ScratchFolder folder;
  folder.write("run/nilas.log", "");
  folder.write("run/scene.xml.part", "");
  EXPECT_NO_THROW(RunFolder(folder.path() / "run", false));
  folder.write("other/scene.xml.part", "");
  folder.write("other/mine.part", "");
  EXPECT_THROW(RunFolder(folder.path() / "other", false), InputError);
}

TEST(RunFolder, ForceRemovesWhatARunWroteAndNothingElse) {
  const ScratchFolder scratch;
  {
    SampleRun run(scratch / "run");
    run.begin();
    run.steps(20);
    run.folder.finish({}, run.bodies);
  }
  const fs::path path = scratch / "run";
  fs::create_directory(path / "problems");
  for (const char* name : {"worst.hdf5", "worst-00000012.hdf5", "last.hdf5", "step-00000003.hdf5", "worst.hdf5.part"})
    std::ofstream(path / "problems" / name) << "of the run";
  const std::vector<std::string> foreign{"notes.txt",
                                         "vessel_old.csv",
                                         "problems/best.hdf5",
                                         "problems/step-3.hdf5",
                                         "trajectory/picture.png",
                                         "trajectory/step-000001-mine.vtp",
                                         "trajectory/step-1.vtp"};
  for (const auto& name : foreign) std::ofstream(path / name) << "mine";
  EXPECT_THROW(RunFolder(path, false), InputError);
  EXPECT_TRUE(fs::exists(path / "vessel.csv")) << "a refusal must not touch anything";
  const RunFolder folder(path, true);
  std::vector<std::string> left;
  for (const auto& entry : fs::recursive_directory_iterator(path))
    if (entry.is_regular_file()) left.push_back(fs::relative(entry.path(), path));
  std::sort(left.begin(), left.end());
  EXPECT_EQ(left, (std::vector<std::string>{"nilas.log", "notes.txt", "problems/best.hdf5", "problems/step-3.hdf5",
                                            "trajectory/picture.png", "trajectory/step-000001-mine.vtp",
                                            "trajectory/step-1.vtp", "vessel_old.csv"}));
}

TEST(RunFolder, HasOneWriterAtATime) {
  const ScratchFolder scratch;
  {
    SampleRun run(scratch / "run");
    run.begin();
    run.steps(3);
    for (const bool force : {true, false}) {
      const char* reason = force ? "another program is writing this run" : "is not empty";
      test::expect_refusal<std::runtime_error>([&] { RunFolder second(scratch / "run", force); }, {reason});
    }
    EXPECT_THROW(RunLock(scratch / "run"), FileError);
    run.steps(2);
    EXPECT_EQ(lines_of(scratch / "run/steps.csv").size(), 1u + 5) << "a refusal must not touch anything";
  }
  EXPECT_NO_THROW(RunFolder(scratch / "run", true));
}

TEST(RunFolder, APlaceThatCannotHoldAFolderIsAFileError) {
  const ScratchFolder scratch;
  std::ofstream(scratch / "file") << "mine";
  EXPECT_THROW(RunFolder(scratch / "file", false), FileError);
  EXPECT_THROW(RunFolder(scratch / "file/run", false), FileError);
  EXPECT_THROW(RunFolder(scratch / "file/run", true), FileError);
  EXPECT_EQ(read_text(scratch / "file"), "mine");
}

TEST(RunFolder, AFullDiskEndsTheRunWithTheFileNamed) {
  const ScratchFolder scratch;
  SampleRun run(scratch / "run");
  fs::create_symlink("/dev/full", run.folder.path() / "vessel.csv");
  test::expect_refusal<FileError>([&] { run.begin(); }, {"vessel.csv: cannot write: No space left"});
}

}  // namespace run_folder_test
}  // namespace nilas::output
