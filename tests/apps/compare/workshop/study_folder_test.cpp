/// Tests of the files of a folder that a study may replace, and of those that it must leave alone.
#include "apps/compare/workshop/study_folder.h"

#include <gtest/gtest.h>

#include "core/base/error.h"
#include "tests/support/scratch_folder.h"

namespace study_folder_test {

using namespace nilas;
using namespace nilas::compare;
namespace fs = std::filesystem;

StudyFiles files() {
  return {{"study.json"}, [](const std::string& name) { return name == "study.json" || name == "runs"; }};
}

TEST(StudyFolder, TakesANewFolderAndLocksIt) {
  const test::ScratchFolder scratch;
  StudyFolder folder = StudyFolder::claim(scratch / "new", files(), false);
  EXPECT_TRUE(fs::is_directory(scratch / "new"));
  EXPECT_THROW(StudyFolder::claim(scratch / "new", files(), true), FileError) << "another study is at work";
  folder.abandon();
  EXPECT_FALSE(fs::exists(scratch / "new"));
}

TEST(StudyFolder, ReplacesAnEarlierStudyWhenForcedAndNothingElse) {
  const test::ScratchFolder scratch;
  scratch.write("a/study.json", "{}");
  scratch.write("a/runs/r/steps.csv", "");
  scratch.write("a/notes.txt", "mine");
  EXPECT_THROW(StudyFolder::claim(scratch / "a", files(), false), InputError);
  StudyFolder folder = StudyFolder::claim(scratch / "a", files(), true);
  EXPECT_FALSE(fs::exists(scratch / "a/study.json"));
  EXPECT_FALSE(fs::exists(scratch / "a/runs"));
  EXPECT_TRUE(fs::exists(scratch / "a/notes.txt"));
  folder.abandon();
  EXPECT_TRUE(fs::exists(scratch / "a/notes.txt")) << "the folder is not the study's alone";
  EXPECT_FALSE(fs::exists(scratch / "a/nilas.log"));
}

TEST(StudyFolder, LeavesAloneAFolderOfItsNamesThatNoStudyWrote) {
  const test::ScratchFolder scratch;
  scratch.write("a/runs/precious", "");
  EXPECT_THROW(StudyFolder::claim(scratch / "a", files(), true), InputError);
  EXPECT_TRUE(fs::exists(scratch / "a/runs/precious"));
}

TEST(StudyFolder, OpensOnlyAStudy) {
  const test::ScratchFolder scratch;
  EXPECT_THROW(StudyFolder::open(scratch / "nowhere", files()), FileError);
  EXPECT_THROW(StudyFolder::open(scratch.path(), files()), InputError);
  scratch.write("a/study.json", "{}");
  EXPECT_EQ(StudyFolder::open(scratch / "a", files()).path(), scratch / "a");
}

}  // namespace study_folder_test
