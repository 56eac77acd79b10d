/// Tests of runs whose solver misses its tolerance, and of the contact problems that they write.
#include <gtest/gtest.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "tests/apps/small_scenes.h"
#include "tests/support/program.h"

namespace failure_test {

using namespace nilas_test;

std::vector<std::string> files_of(const fs::path& folder) {
  std::vector<std::string> names;
  if (fs::exists(folder))
    for (const auto& entry : fs::directory_iterator(folder)) names.push_back(entry.path().filename().string());
  std::sort(names.begin(), names.end());
  return names;
}

TEST(Failure, StopEndsWithCodeThreeAndLeavesTheProblem) {
  const ScratchFolder folder;
  folder.write("stack.xml", stack("tolerance='1e-12' on_failure='stop'"));
  const auto result = run_nilas("run stack.xml --out run --json", folder.path());
  EXPECT_EQ(result.exit_code, 3) << result.err;
  EXPECT_NE(result.err.find("law_map_m_s"), std::string::npos) << result.err;
  const auto summary = nlohmann::json::parse(read_text(folder.path() / "run/summary.json"));
  EXPECT_EQ(summary["status"], "failed");
  EXPECT_EQ(summary["exit_code"], 3);
  EXPECT_EQ(files_of(folder.path() / "run/problems"), std::vector<std::string>{"last.hdf5"});
  const auto solved = run_nilas("solve run/problems/last.hdf5 --solver auto --json", folder.path());
  EXPECT_EQ(solved.exit_code, 0) << solved.err;
  EXPECT_LE(nlohmann::json::parse(solved.out)["law_map_m_s"].get<double>(), 1e-8);
}

/// FCLIB has no row for spinning friction, which must not hide why the run failed.
TEST(Failure, AProblemThatCannotBeStoredHidesNoReason) {
  const ScratchFolder folder;
  folder.write("scene.xml",
               "<scene version='1'><time step='0.0019' end='0.0019'/><contact on_failure='stop'>"
               "<friction between='* *' kinetic='0' spinning='0.02'/></contact><body/><body size='0.04 0.1 0.05' "
               "position='-0.1 0 0' velocity='0.6 0 0'/><body/></scene>");
  const ProgramResult result = run_nilas("run scene.xml --out run", folder.path());
  EXPECT_EQ(result.exit_code, 3) << result.err;
  EXPECT_NE(result.err.find("the contact solver stopped with status"), std::string::npos) << result.err;
}

TEST(Failure, RecordGoesOnAndCounts) {
  const ScratchFolder folder;
  folder.write("stack.xml", stack("tolerance='1e-12' on_failure='record'"));
  const auto result = run_nilas("run stack.xml --out run --json --set output/@problems=failed", folder.path());
  ASSERT_EQ(result.exit_code, 0) << result.err;
  const auto summary = nlohmann::json::parse(result.out);
  const Table steps(folder.path() / "run/steps.csv");
  const auto status = steps.text("status");
  const auto short_steps = std::count_if(status.begin(), status.end(), [](auto& s) { return s != "converged"; });
  EXPECT_GT(short_steps, 0);
  EXPECT_EQ(summary["shortfalls"]["unconverged_steps"], short_steps);
  EXPECT_EQ(files_of(folder.path() / "run/problems").size(), static_cast<std::size_t>(short_steps));
  EXPECT_NE(result.err.find("iteration_limit"), std::string::npos) << result.err;
}

TEST(Failure, RetryClimbsToAutoAndConverges) {
  const ScratchFolder folder;
  folder.write("stack.xml", stack("tolerance='1e-12' on_failure='retry'"));
  const auto result = run_nilas(
      "run stack.xml --out run --json --set contact/@max_iterations=100 --set output/@problems=every "
      "--set contact/@tolerance=1e-9",
      folder.path());
  ASSERT_EQ(result.exit_code, 0) << result.err;
  EXPECT_EQ(nlohmann::json::parse(result.out)["shortfalls"]["unconverged_steps"], 0);
  EXPECT_EQ(files_of(folder.path() / "run/problems").size(), 10u);
}

TEST(Failure, WorstKeepsOneProblem) {
  const ScratchFolder folder;
  folder.write("stack.xml", stack("tolerance='1e-12' on_failure='record'"));
  const auto result = run_nilas("run stack.xml --out run --json --set output/@problems=worst", folder.path());
  ASSERT_EQ(result.exit_code, 0) << result.err;
  EXPECT_EQ(files_of(folder.path() / "run/problems"), std::vector<std::string>{"worst.hdf5"});
}

}  // namespace failure_test
