/// `nilas study`: its options are known without Python, and reach the Python package as they were given.
#include <gtest/gtest.h>

#include <cstdlib>

#include "tests/support/mentions.h"
#include "tests/support/program.h"

namespace study_command_test {

using namespace nilas_test;
using nilas::test::mentions;

/// The interpreter that `nilas study` starts, as long as this lives.
struct Interpreter {
  explicit Interpreter(const fs::path& file) { ::setenv("NILAS_PYTHON", file.c_str(), 1); }
  Interpreter(const Interpreter&) = delete;
  Interpreter& operator=(const Interpreter&) = delete;
  ~Interpreter() { ::unsetenv("NILAS_PYTHON"); }
};

/// A program in the place of the interpreter, which prints its words.
fs::path words_printer(const ScratchFolder& folder) {
  folder.write("words", "#!/bin/sh\nprintf '%s\\n' \"$@\"\n");
  fs::permissions(folder.path() / "words", fs::perms::owner_all);
  return folder.path() / "words";
}

TEST(StudyCommand, HelpManualAndCompletionNeedNoPython) {
  const ScratchFolder folder;
  const Interpreter none("/nonexistent/python3");
  for (const char* page : {"study --help", "schema --man", "schema --completion"}) {
    const auto result = run_nilas(page, folder.path());
    ASSERT_EQ(result.exit_code, 0) << page;
    // A manual page writes its hyphens as \-.
    const bool is_manual = std::string(page) == "schema --man";
    EXPECT_TRUE(mentions(result.out, is_manual ? "\\-\\-retry\\-failed" : "--retry-failed")) << page;
    EXPECT_FALSE(mentions(result.out, is_manual ? "\\-\\-gather" : "--gather")) << page << " shows what is for jobs";
  }
  const auto study = run_nilas("study s.yaml", folder.path());
  EXPECT_EQ(study.exit_code, 4);
  EXPECT_TRUE(mentions(study.err, "/nonexistent/python3 cannot be started")) << study.err;
}

TEST(StudyCommand, OptionsReachThePackageAsTheyWereGiven) {
  const ScratchFolder folder;
  const Interpreter printer(words_printer(folder));
  const auto words = [&](const std::string& given) { return run_nilas("study " + given, folder.path()).out; };
  EXPECT_EQ(words("s.yaml"), "-m\nnilas.study\n--\ns.yaml\n");
  EXPECT_EQ(words("--collect -j 3 'my study.yaml' --out=runs/a --no-page"),
            "-m\nnilas.study\n--jobs=3\n--out=runs/a\n--collect\n--no-page\n--\nmy study.yaml\n");
  EXPECT_EQ(words("s.yaml --part 7 --gather --judge"), "-m\nnilas.study\n--part=7\n--gather\n--judge\n--\ns.yaml\n");
}

TEST(StudyCommand, WrongOptionsAreRefusedWithTheNearestName) {
  const ScratchFolder folder;
  const Interpreter printer(words_printer(folder));
  const auto misspelt = run_nilas("study s.yaml --retry-faild", folder.path());
  EXPECT_EQ(misspelt.exit_code, 2);
  EXPECT_TRUE(mentions(misspelt.err, "the nearest is --retry-failed")) << misspelt.err;
  for (const char* count : {"0", "4097", "two"})
    EXPECT_EQ(run_nilas(std::string("study s.yaml --jobs ") + count, folder.path()).exit_code, 2) << count;
  EXPECT_EQ(run_nilas("study --status", folder.path()).exit_code, 2) << "there is no study file";
}

}  // namespace study_command_test
