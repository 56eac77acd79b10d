#include "core/output/run/run_inputs.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "core/base/error.h"
#include "core/output/run/claim_folder.h"
#include "core/scene/read/input_files.h"
#include "tests/core/output/sample_run.h"
#include "tests/support/file_text.h"
#include "tests/support/refusal.h"
#include "tests/support/size_limit.h"

namespace nilas::output {
namespace run_inputs_test {

namespace fs = std::filesystem;
using test::read_text;
using test::ScratchFolder;

class RunInputs : public ::testing::Test {
 protected:
  scene::InputFile input(const std::string& source, const std::string& copy, const std::string& text) const {
    const fs::path file = scratch.write(source, text);
    return {file.string(), "inputs/" + copy, scene::file_sha256(file)};
  }
  std::vector<scene::InputFile> ship() const {
    return {input("hulls/ship/fluid.stl", "ship/fluid.stl", "fluid"),
            input("hulls/ship/part-0001.stl", "ship/part-0001.stl", "one"), input("way.csv", "way.csv", "way")};
  }
  std::vector<std::string> files() const {
    std::vector<std::string> found;
    for (const auto& entry : fs::recursive_directory_iterator(run))
      if (!entry.is_directory()) found.push_back(fs::relative(entry.path(), run).string());
    std::sort(found.begin(), found.end());
    return found;
  }

  ScratchFolder scratch;
  const fs::path run = scratch / "run";
};

using Names = std::vector<std::string>;

TEST_F(RunInputs, AreCopiedAndListedAsSha256sumReadsThem) {
  const auto inputs = ship();
  copy_inputs(run, inputs);
  EXPECT_EQ(files(), (Names{"inputs/nilas-inputs.sha256", "inputs/ship/fluid.stl", "inputs/ship/part-0001.stl",
                            "inputs/way.csv"}));
  EXPECT_EQ(read_text(run / "inputs/ship/part-0001.stl"), "one");
  EXPECT_EQ(read_text(run / "inputs/nilas-inputs.sha256"), inputs[0].sha256 + "  ship/fluid.stl\n" + inputs[1].sha256 +
                                                               "  ship/part-0001.stl\n" + inputs[2].sha256 +
                                                               "  way.csv\n");
  copy_inputs(scratch / "none", {});
  EXPECT_FALSE(fs::exists(scratch / "none"));
}

TEST_F(RunInputs, OfAHullOfHundredsOfParts) {
  std::vector<scene::InputFile> inputs;
  for (int k = 1; k <= 600; ++k) {
    const std::string part = "part-" + std::to_string(k) + ".stl";
    inputs.push_back(input("ship/" + part, "ship/" + part, "part " + std::to_string(k)));
  }
  copy_inputs(run, inputs);
  EXPECT_EQ(files().size(), 601u);
  remove_inputs(run, {});
  EXPECT_EQ(files(), Names{});
  EXPECT_FALSE(fs::exists(run / "inputs"));
}

TEST_F(RunInputs, ThatHaveChangedOrAreGoneLeaveNoCopies) {
  auto inputs = ship();
  scratch.write("way.csv", "another way");
  EXPECT_THROW(copy_inputs(run, inputs), InputError);
  EXPECT_FALSE(fs::exists(run / "inputs"));
  fs::remove(scratch / "way.csv");
  test::expect_refusal<FileError>([&] { copy_inputs(run, inputs); }, {"way.csv"});
  EXPECT_FALSE(fs::exists(run / "inputs"));
}

TEST_F(RunInputs, OnAFullDiskLeaveNoCopies) {
  auto inputs = ship();
  inputs.push_back(input("large", "large", std::string(5000, 'x')));
  const test::SizeLimit full(4000);
  test::expect_refusal<FileError>([&] { copy_inputs(run, inputs); }, {"inputs/large"});
  EXPECT_FALSE(fs::exists(run / "inputs"));
}

TEST_F(RunInputs, ForceRemovesTheCopiesAndNothingElse) {
  copy_inputs(run, ship());
  scratch.write("run/scene.xml", "of the run");
  scratch.write("run/inputs/ship/fluid.stl.part", "half");
  scratch.write("run/inputs/ship/sketch.png", "mine");
  scratch.write("run/inputs/notes.txt", "mine");
  EXPECT_THROW(claim_folder(run, false), InputError);
  claim_folder(run, true);
  EXPECT_EQ(files(), (Names{"inputs/notes.txt", "inputs/ship/sketch.png"}));
}

TEST_F(RunInputs, AListThatPointsElsewhereRemovesNothingThere) {
  scratch.write("run/scene.xml", "of the run");
  scratch.write("run/mine.txt", "mine");
  scratch.write("deep/a/b.stl", "mine");
  scratch.write("real/fluid.stl", "mine");
  fs::create_directories(run / "inputs");
  fs::create_directory_symlink(scratch / "real", run / "inputs/ship");
  const std::string sum(64, '0');
  scratch.write("run/inputs/nilas-inputs.sha256", sum + "  ../mine.txt\n" + sum + "  ..\n" + sum + "  " +
                                                      (scratch / "deep/a/b.stl").string() + "\n" + sum +
                                                      "  a/../../mine.txt\n" + sum + "  ship/fluid.stl\nshort\n");
  claim_folder(run, true);
  for (const char* file : {"run/mine.txt", "deep/a/b.stl", "real/fluid.stl", "run/inputs/ship"})
    EXPECT_TRUE(fs::exists(scratch / file)) << file;
}

/// Somebody's downloads: no run made them, whatever their names.
TEST_F(RunInputs, FilesOfAFolderThatHeldNoRunStay) {
  const std::string sum(64, '0');
  scratch.write("run/inputs/a.txt", "mine");
  for (const char* list : {"SHA256SUMS", "nilas-inputs.sha256"}) {
    scratch.write(std::string("run/inputs/") + list, sum + "  a.txt\n");
    EXPECT_THROW(claim_folder(run, false), InputError) << list;
    EXPECT_TRUE(fs::exists(run / "inputs/a.txt"));
    fs::remove(run / "inputs" / list);
  }
  scratch.write("run/inputs/SHA256SUMS", sum + "  a.txt\n");
  claim_folder(run, true);
  EXPECT_TRUE(fs::exists(run / "inputs/a.txt"));
}

TEST_F(RunInputs, ALinkedFolderOfInputsIsNotEntered) {
  copy_inputs(scratch / "other", ship());
  scratch.write("run/scene.xml", "of the run");
  fs::create_directory_symlink(scratch / "other/inputs", run / "inputs");
  claim_folder(run, true);
  EXPECT_TRUE(fs::exists(scratch / "other/inputs/ship/fluid.stl"));
}

/// A run of the folder's own scene, into the folder.
TEST_F(RunInputs, ThatTheNewRunReadsStay) {
  copy_inputs(run, ship());
  scratch.write("run/scene.xml", "of the run");
  const std::string fluid = scene::file_sha256(run / "inputs/ship/fluid.stl");
  const std::vector<scene::InputFile> own{{(run / "inputs/ship/fluid.stl").string(), "inputs/ship/fluid.stl", fluid}};
  { const RunLock lock = claim_run_folder(run, true, own); }
  copy_inputs(run, own);
  EXPECT_EQ(files(), (Names{"inputs/nilas-inputs.sha256", "inputs/ship/fluid.stl", "nilas.log"}));
  EXPECT_EQ(read_text(run / "inputs/nilas-inputs.sha256"), fluid + "  ship/fluid.stl\n");
}

TEST_F(RunInputs, ACopyNeverReplacesWhatTheRunReadsNorAForeignFile) {
  copy_inputs(run, ship());
  scratch.write("run/scene.xml", "of the run");
  scratch.write("run/inputs/field.json", "mine");
  const auto before = files();
  const scene::InputFile read{(run / "inputs/way.csv").string(), "inputs/way-2.csv",
                              scene::file_sha256(run / "inputs/way.csv")};
  EXPECT_THROW((void)claim_run_folder(run, true, {input("new/way.csv", "way.csv", "new"), read}), InputError);
  EXPECT_THROW((void)claim_run_folder(run, true, {input("new/field.json", "field.json", "new")}), InputError);
  EXPECT_EQ(files(), before) << "a refusal must not touch anything";
  EXPECT_NO_THROW((void)claim_run_folder(run, true, {input("new/way.csv", "way.csv", "new")}));
}

/// Killed while it copied.
TEST_F(RunInputs, AFolderThatHoldsCopiesAloneIsFree) {
  copy_inputs(run, ship());
  scratch.write("run/inputs/way.csv.part", "half");
  scratch.write("run/nilas.log", "");
  EXPECT_NO_THROW((void)claim_run_folder(run, false));
  EXPECT_EQ(files(), Names{"nilas.log"});
  copy_inputs(run, ship());
  scratch.write("run/inputs/notes.txt", "mine");
  EXPECT_THROW((void)claim_run_folder(run, false), InputError);
}

}  // namespace run_inputs_test
}  // namespace nilas::output
