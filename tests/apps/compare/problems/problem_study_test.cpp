/// Tests of `nilas compare --problems` from the user's side: output, faults, and resuming.
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <set>

#include "apps/compare/problems/problem_study_run.h"
#include "apps/compare/problems/problem_study_table.h"
#include "contact/fclib/fclib_io.h"
#include "core/base/error.h"
#include "tests/support/mentions.h"
#include "tests/support/problems/cone_problems.h"
#include "tests/support/program.h"
#include "tests/support/size_limit.h"
#include "tests/support/started_program.h"

namespace problem_study_test {

using namespace nilas;
using namespace nilas::compare;
using namespace nilas_test;

/// Three small problems and one that sweeps do not solve.
void write_problems(const ScratchFolder& folder) {
  const fs::path problems = folder.path() / "problems";
  fs::create_directories(problems);
  contact::write_fclib(problems / "particle.hdf5", test::particle(Law::coulomb, 2, 0.5, Vec3(-1, 3, 0)), nullptr);
  contact::write_fclib(problems / "two.hdf5", nilas::contact::reduce(test::box_stack({1, 2}, 0.4)), nullptr);
  contact::write_fclib(problems / "heap.hdf5", test::random_heap(3, 8, 16, 0.4), nullptr);
  contact::write_fclib(problems / "heavy.hdf5", test::box_stack(test::growing_masses(8, 1e8), 0.5), nullptr);
}

std::string study(const std::string& more) { return "compare --problems problems --jobs 2 --out out " + more; }

std::vector<StudyRow> rows_of(const ScratchFolder& folder) {
  return read_study(folder.path() / "out" / "compare.csv").rows;
}

const StudyRow& find(const std::vector<StudyRow>& rows, const std::string& problem, const std::string& solver) {
  for (const auto& row : rows)
    if (row.problem.name == problem && row.solver == solver) return row;
  throw std::runtime_error("no row of " + problem + " by " + solver);
}

TEST(ProblemStudy, JudgesByTheYardstickAndListsFailuresByCause) {
  const ScratchFolder folder;
  write_problems(folder);
  folder.write("problems/broken.hdf5", "no problem");
  const auto run = run_nilas(study("--solvers newton,pgs,enumerate --tolerance 1e-8 --budget 5"), folder.path());
  ASSERT_EQ(run.exit_code, 0) << run.err;
  const auto rows = rows_of(folder);
  EXPECT_EQ(rows.size(), 4 * 3 + 1U);
  for (const auto& row : rows)
    if (row.solved()) {
      EXPECT_LE(row.residuals.law_map_m_s, 1e-8);
      EXPECT_GT(row.seconds, 0);
    }
  EXPECT_TRUE(find(rows, "heavy", "newton").solved());
  EXPECT_GT(find(rows, "heavy", "newton").problem.mass_ratio, 1e4);
  EXPECT_EQ(find(rows, "heavy", "pgs").outcome, RunOutcome::stalled);
  EXPECT_EQ(find(rows, "heavy", "enumerate").outcome, RunOutcome::not_applicable);
  EXPECT_EQ(find(rows, "particle", "enumerate").sliding, 1);
  EXPECT_EQ(find(rows, "broken", "").outcome, RunOutcome::unreadable);
  const std::string page = read_text(folder.path() / "out/compare.html");
  for (const char* word :
       {"newton solved all 4 problems", "stalled", "broken", "<svg", "How the solvers were compared"})
    EXPECT_TRUE(mentions(page, word)) << word;
  const auto json = nlohmann::json::parse(read_text(folder.path() / "out/compare.json"));
  EXPECT_EQ(json["status"], "done");
  EXPECT_EQ(json["rows"].size(), rows.size());
  EXPECT_EQ(json["profiles"][0]["solvers"][0]["solver"], "pgs");
  for (const char* file : {"performance-coulomb-1e-8.svg", "performance-coulomb-1e-8.png", "work-precision.csv"})
    EXPECT_TRUE(fs::exists(folder.path() / "out" / file)) << file;
  for (const auto& entry : fs::directory_iterator(folder.path() / "out"))
    EXPECT_NE(entry.path().filename().string()[0], '.') << entry.path();
  const auto again = run_nilas(study("--solvers newton"), folder.path());
  EXPECT_EQ(again.exit_code, 2) << "the folder is not empty";
}

/// The rows without measured times.
std::vector<std::string> timeless(std::vector<StudyRow> rows) {
  std::vector<std::string> lines;
  for (auto& row : rows) {
    row.seconds = row.wall = row.cpu = 0;
    lines.push_back(study_line(row));
  }
  return lines;
}

TEST(ProblemStudy, GivesTheSameTableButForTimes) {
  const ScratchFolder folder;
  write_problems(folder);
  const std::string flags = "--solvers newton,auto --tolerance 1e-4,1e-8 --budget 60 --quiet --force";
  ASSERT_EQ(run_nilas(study(flags), folder.path()).exit_code, 0);
  const auto first = timeless(rows_of(folder));
  EXPECT_EQ(first.size(), 16U);
  ASSERT_EQ(run_nilas(study(flags), folder.path()).exit_code, 0);
  EXPECT_EQ(timeless(rows_of(folder)), first);
}

TEST(ProblemStudy, GoesOnAfterAKillWithoutDoingARunTwice) {
  const ScratchFolder folder;
  write_problems(folder);
  const fs::path table = folder.path() / "out/compare.csv";
  std::vector<StudyRow> before;
  {
    Started killed(study("--solvers newton,auto,pgs --tolerance 1e-2,1e-4,1e-6,1e-8 --budget 30"), folder.path());
    ASSERT_TRUE(killed.reaches(table, 9));
    killed.stop(SIGKILL);
    before = rows_of(folder);
  }
  EXPECT_FALSE(read_text(folder.path() / "out/compare.html").empty());
  std::ofstream(table, std::ios::app) << "heavy,global,32,48,1e8,new";  // a row cut off
  const auto run = run_nilas("compare --resume out --budget 30 --jobs 2", folder.path());
  ASSERT_EQ(run.exit_code, 0) << run.err;
  const auto rows = rows_of(folder);
  EXPECT_EQ(rows.size(), 4 * 3 * 4U);
  std::set<std::string> lines;
  for (const auto& row : rows) lines.insert(study_line(row));
  EXPECT_EQ(lines.size(), rows.size());
  for (const auto& row : before) EXPECT_TRUE(lines.count(study_line(row))) << "not kept: " << study_line(row);
}

TEST(ProblemStudy, EndsInOrderWhenInterrupted) {
  const ScratchFolder folder;
  write_problems(folder);
  Started stopped(study("--solvers newton,pgs --budget 300"), folder.path());
  ASSERT_TRUE(stopped.reaches(folder.path() / "out/compare.csv", 4));
  EXPECT_EQ(stopped.stop(SIGTERM), 130);
  EXPECT_TRUE(mentions(read_text(folder.path() / "out/compare.html"), "interrupted"));
  EXPECT_GE(rows_of(folder).size(), 3U);
}

TEST(ProblemStudy, ABudgetOfTwoSecondsSaysWhatItLeftOut) {
  const ScratchFolder folder;
  write_problems(folder);
  const auto run = run_nilas(study("--budget 2"), folder.path());
  ASSERT_EQ(run.exit_code, 0) << run.err;
  EXPECT_TRUE(mentions(run.out, "the budget of 2 s has no time for")) << run.out;
  const std::string page = read_text(folder.path() / "out/compare.html");
  EXPECT_TRUE(mentions(page, "The budget had no time for"));
  EXPECT_GT(rows_of(folder).size(), 5U);
  EXPECT_FALSE(nlohmann::json::parse(read_text(folder.path() / "out/compare.json"))["dropped"].empty());
}

TEST(ProblemStudy, AFullDiskEndsWithFourAndWholeRows) {
  const ScratchFolder folder;
  write_problems(folder);
  ProgramResult run;
  {
    const test::SizeLimit limit(12 << 10);
    run = run_nilas(study("--solvers newton,auto,nsgs --budget 60 --quiet"), folder.path());
  }
  EXPECT_EQ(run.exit_code, 4) << run.err;
  EXPECT_TRUE(mentions(run.err, "cannot write")) << run.err;
  const auto stored = read_study(folder.path() / "out/compare.csv");
  EXPECT_GT(stored.rows.size(), 3U);
  EXPECT_EQ(static_cast<std::uintmax_t>(stored.bytes), fs::file_size(folder.path() / "out/compare.csv"));
  EXPECT_TRUE(mentions(read_text(folder.path() / "out/compare.html"), "</html>"));
}

TEST(ProblemStudy, WrongInputIsNamed) {
  const ScratchFolder folder;
  write_problems(folder);
  fs::create_directories(folder.path() / "empty");
  const auto unknown = run_nilas(study("--solvers newtn"), folder.path());
  EXPECT_EQ(unknown.exit_code, 2);
  EXPECT_TRUE(mentions(unknown.err, "newton")) << unknown.err;
  const auto empty = run_nilas("compare --problems empty --out out", folder.path());
  EXPECT_EQ(empty.exit_code, 2);
  EXPECT_TRUE(mentions(empty.err, "FCLIB")) << empty.err;
  EXPECT_EQ(run_nilas("compare --problems nowhere --out out", folder.path()).exit_code, 4);
  EXPECT_EQ(run_nilas("compare --resume nowhere", folder.path()).exit_code, 4);
  EXPECT_FALSE(fs::exists(folder.path() / "out"));
}

std::string printed(const std::string& claimed, double seconds, const std::string& map) {
  return "a library says hello\n{\n  \"problem\": \"p\", \"claimed\": \"" + claimed +
         "\", \"seconds\": " + std::to_string(seconds) + ", \"law_map_m_s\": " + map + "\n}\n";
}

TEST(ProblemStudy, EveryEndHasItsCause) {
  const StudyFile file;
  const StudyRun run{0, "newton", "coulomb", 1e-6};
  const auto outcome = [&](const ChildResult& ended, const std::string& out, const std::string& log = "") {
    return judge(file, run, 1, ended, out, log).outcome;
  };
  const ChildResult done{.exit_code = 0}, short_of_it{.exit_code = 3};
  EXPECT_EQ(outcome(short_of_it, printed("stalled", 0.1, "1e-7")), RunOutcome::solved) << "whatever it claims";
  EXPECT_EQ(outcome(done, printed("converged", 0.1, "1e-5")), RunOutcome::above_tolerance);
  EXPECT_EQ(outcome(done, printed("converged", 1.5, "1e-7")), RunOutcome::time_limit);
  EXPECT_EQ(outcome(short_of_it, printed("iteration_limit", 1, "1e-5")), RunOutcome::time_limit);
  EXPECT_EQ(outcome(short_of_it, printed("iteration_limit", 0.1, "1e-5")), RunOutcome::iteration_limit);
  EXPECT_EQ(outcome(short_of_it, printed("stalled", 0.1, "null")), RunOutcome::stalled);
  EXPECT_EQ(outcome(short_of_it, printed("numerical_error", 0.1, "null")), RunOutcome::numerical_error);
  EXPECT_EQ(outcome({.exit_code = 143, .timed_out = true}, ""), RunOutcome::time_limit);
  EXPECT_EQ(outcome({.exit_code = 139}, ""), RunOutcome::crashed);
  EXPECT_EQ(outcome({.exit_code = 3}, "", "internal error"), RunOutcome::crashed);
  EXPECT_EQ(outcome({.exit_code = 2}, "", "error: p: no problem"), RunOutcome::unreadable);
  EXPECT_THROW(outcome(done, "{\n  \"problem\": \"p\", \"cl"), FileError) << "a full disk";
}

}  // namespace problem_study_test
