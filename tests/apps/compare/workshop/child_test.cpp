/// Tests of child processes: how they end, what they cost, and that none is left behind.
#include "apps/compare/workshop/child.h"

#include <gtest/gtest.h>

#include <csignal>

#include "core/base/error.h"
#include "tests/support/program.h"

namespace child_test {

using namespace nilas;
using namespace nilas::compare;
using nilas_test::read_text;
using nilas_test::ScratchFolder;

ChildTask shell(const std::string& command, const ScratchFolder& folder, const std::string& name = "out.txt") {
  return {{"/bin/sh", "-c", command}, folder.path() / name, folder.path() / (name + ".log"), 0};
}

TEST(Child, TellsExitCodeAndWhatItSaid) {
  const ScratchFolder folder;
  const ChildResult result = run_child(shell("echo said; echo loud >&2; exit 7", folder));
  EXPECT_EQ(result.exit_code, 7);
  EXPECT_FALSE(result.timed_out);
  EXPECT_EQ(read_text(folder.path() / "out.txt"), "said\n");
  EXPECT_EQ(read_text(folder.path() / "out.txt.log"), "loud\n");
}

TEST(Child, ThatASignalEndsIsToldAsAShellTellsIt) {
  const ScratchFolder folder;
  EXPECT_EQ(run_child(shell("kill -SEGV $$", folder)).exit_code, 128 + SIGSEGV);
}

TEST(Child, IsEndedAtItsLimit) {
  const ScratchFolder folder;
  ChildTask task = shell("exec sleep 60", folder);
  task.limit_s = 0.2;
  const ChildResult result = run_child(task);
  EXPECT_TRUE(result.timed_out);
  EXPECT_EQ(result.exit_code, 128 + SIGTERM);
  EXPECT_GE(result.wall_s, 0.2);
}

TEST(Child, HearsThatItIsToEndHoweverEarly) {
  const ScratchFolder folder;
  // as the program that keeps children has it
  const auto before = std::signal(SIGTERM, [](int) {});
  for (int k = 0; k < 20; ++k) {
    ChildTask task = shell("exec sleep 60", folder);
    task.limit_s = 1e-9;
    EXPECT_LT(run_child(task).wall_s, 5);
  }
  std::signal(SIGTERM, before);
}

TEST(Child, CountsProcessorTimeAndNotTheTimeThatItWaits) {
  const ScratchFolder folder;
  EXPECT_LT(run_child(shell("exec sleep 0.5", folder)).cpu_s, 0.3);
  EXPECT_GT(run_child(shell("i=0; while [ $i -lt 100000 ]; do i=$((i+1)); done", folder)).cpu_s, 0.01);
}

TEST(Child, RunAsManyAtATimeAsAskedInTheirOrder) {
  const ScratchFolder folder;
  // Each prints the number of them that it sees.
  std::vector<ChildTask> tasks;
  for (int k = 0; k < 6; ++k) {
    const std::string name = std::to_string(k);
    tasks.push_back(
        shell("touch at-work-" + name + "; ls | grep -c at-work; sleep 0.2; rm at-work-" + name, folder, "out" + name));
    tasks.back().command[2] = "cd '" + folder.path().string() + "' && " + tasks.back().command[2];
  }
  std::vector<std::size_t> begun, done;
  run_children(tasks, 2,
               {[&](std::size_t k, ChildTask&) {
                  if (k == 3) return false;
                  begun.push_back(k);
                  return true;
                },
                [&](std::size_t k, const ChildResult& r) {
                  EXPECT_EQ(r.exit_code, 0);
                  done.push_back(k);
                },
                {}});
  EXPECT_EQ(begun, (std::vector<std::size_t>{0, 1, 2, 4, 5}));
  EXPECT_EQ(done.size(), 5U);
  for (const std::size_t k : begun) EXPECT_LE(std::stoi(read_text(folder.path() / ("out" + std::to_string(k)))), 2);
}

TEST(Child, EndsWhenAllIsToStop) {
  const ScratchFolder folder;
  int asked = 0;
  const ChildResult result = run_child(shell("exec sleep 60", folder), [&] { return ++asked > 20; });
  EXPECT_TRUE(result.stopped);
  EXPECT_FALSE(result.timed_out);
  EXPECT_EQ(result.exit_code, 128 + SIGTERM);
}

TEST(Child, IsKilledByAThrowOfItsKeeper) {
  const ScratchFolder folder;
  const std::string other = (folder.path() / "b").string();
  std::vector<ChildTask> tasks{shell("while [ ! -s '" + other + "' ]; do sleep 0.01; done", folder, "a"),
                               shell("echo $$; exec sleep 60", folder, "b")};
  EXPECT_THROW(run_children(tasks, 2, {{}, [](std::size_t, const ChildResult&) { throw InputError("enough"); }, {}}),
               InputError);
  const std::string process = read_text(folder.path() / "b");
  EXPECT_NE(::kill(std::stoi(process), 0), 0);
}

TEST(Child, ThatCannotWriteIsAFileError) {
  ChildTask task{{"/bin/true"}, "/no/such/folder/out.txt", "", 0};
  EXPECT_THROW(run_child(task), FileError);
}

TEST(Child, OfAProgramThatIsNotThereEndsAsInAShell) {
  const ScratchFolder folder;
  EXPECT_EQ(run_child({{"/no/such/program"}, folder.path() / "out", folder.path() / "log", 0}).exit_code, 127);
}

}  // namespace child_test
