#include "core/output/file/output_file.h"

#include <gtest/gtest.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <csignal>

#include "core/base/error.h"
#include "core/output/file/flush.h"
#include "tests/core/output/sample_run.h"
#include "tests/support/file_text.h"
#include "tests/support/refusal.h"
#include "tests/support/size_limit.h"

namespace nilas::output {
namespace output_file_test {

using test::read_text;
using test::ScratchFolder;
using test::SizeLimit;

TEST(OutputFile, EveryPieceIsReadableAtOnce) {
  const ScratchFolder folder;
  OutputFile file(folder / "a.csv");
  EXPECT_EQ(read_text(folder / "a.csv"), "");
  file.append("one\n");
  EXPECT_EQ(read_text(folder / "a.csv"), "one\n");
  file.append("two\n");
  EXPECT_EQ(read_text(folder / "a.csv"), "one\ntwo\n");
}

TEST(OutputFile, TheTailFollowsTheNewestPiece) {
  const ScratchFolder folder;
  OutputFile file(folder / "a.xml", "</all>");
  file.append("<all>");
  EXPECT_EQ(read_text(folder / "a.xml"), "<all></all>");
  file.append("<x/>");
  EXPECT_EQ(read_text(folder / "a.xml"), "<all><x/></all>");
}

TEST(OutputFile, OpeningEmptiesAnOlderFile) {
  const ScratchFolder folder;
  { OutputFile(folder / "a.csv").append("a long old text\n"); }
  OutputFile file(folder / "a.csv");
  file.append("new\n");
  file.close();
  EXPECT_EQ(read_text(folder / "a.csv"), "new\n");
}

TEST(OutputFile, GoesOnAfterTheBytesItIsToKeep) {
  const ScratchFolder folder;
  std::int64_t kept = 0;
  {
    OutputFile file(folder / "a.xml", "</all>");
    file.append("<all>\n");
    kept = file.bytes();
    file.append("<later, and longer than the tail/>");
  }
  OutputFile file(folder / "a.xml", "</all>", kept);
  file.sync();
  EXPECT_EQ(read_text(folder / "a.xml"), "<all>\n</all>");
  file.append("<x/>");
  EXPECT_EQ(read_text(folder / "a.xml"), "<all>\n<x/></all>");
  EXPECT_THROW(OutputFile(folder / "a.xml", "", 1000), InputError);
  EXPECT_THROW(OutputFile(folder / "none.xml", "", 0), FileError);
  EXPECT_FALSE(std::filesystem::exists(folder / "none.xml"));
}

TEST(OutputFile, GoesOnAfterAWholeLineOnly) {
  const ScratchFolder folder;
  const std::string text = "a,b\n1,2\n3,4\n";
  std::ofstream(folder / "a.csv") << text;
  for (const std::int64_t inside : {1, 3, 5, 7, 11}) {
    SCOPED_TRACE(inside);
    test::expect_refusal([&] { OutputFile(folder / "a.csv", "", inside); }, {"a.csv: has changed"});
  }
  EXPECT_EQ(read_text(folder / "a.csv"), text) << "a refusal must not touch anything";
  { OutputFile(folder / "a.csv", "", 8).append("5,6\n"); }
  EXPECT_EQ(read_text(folder / "a.csv"), "a,b\n1,2\n5,6\n");
  OutputFile(folder / "a.csv", "", 0).append("c\n");
  EXPECT_EQ(read_text(folder / "a.csv"), "c\n");
}

TEST(OutputFile, APieceThatDoesNotFitLeavesTheFileWithWholePieces) {
  const ScratchFolder folder;
  OutputFile file(folder / "a.csv"), list(folder / "a.xml", "</all>");
  file.append("0123456789\n");
  list.append("<all>");
  {
    const SizeLimit limit(15);
    EXPECT_THROW(file.append("abcdefgh\n"), FileError);
    EXPECT_THROW(list.append("<x/><x/><x/>"), FileError);
  }
  EXPECT_EQ(read_text(folder / "a.csv"), "0123456789\n");
  EXPECT_EQ(read_text(folder / "a.xml"), "<all></all>");
  file.append("again\n");
  EXPECT_EQ(read_text(folder / "a.csv"), "0123456789\nagain\n");
}

TEST(OutputFile, AFullDiskIsNamedWithTheFile) {
  OutputFile file("/dev/full");
  EXPECT_EQ(test::refusal<FileError>([&] { file.append("row\n"); }),
            "/dev/full: cannot write: No space left on device");
}

TEST(OutputFile, AKilledProcessLeavesItsRows) {
  const ScratchFolder folder;
  const pid_t child = ::fork();
  if (child == 0) {
    OutputFile file(folder / "a.csv");
    for (int row = 0; row < 1000; ++row) file.append("row\n");
    std::raise(SIGKILL);
  }
  int status = 0;
  ASSERT_EQ(::waitpid(child, &status, 0), child);
  ASSERT_TRUE(WIFSIGNALED(status));
  EXPECT_EQ(test::lines_of(folder / "a.csv").size(), 1000u);
}

TEST(OutputFile, AFileThatCannotBeOpenedIsAFileError) {
  const ScratchFolder folder;
  EXPECT_THROW(OutputFile(folder / "absent/a.csv"), FileError);
}

TEST(WriteWhole, ReplacesTheFileAndLeavesNoTemporaryOne) {
  const ScratchFolder folder;
  write_whole(folder / "a.json", "old and long");
  write_whole(folder / "a.json", "new");
  EXPECT_EQ(read_text(folder / "a.json"), "new");
  EXPECT_FALSE(std::filesystem::exists(folder / "a.json.part"));
}

TEST(WriteWhole, KeepsTheOldFileWhenTheNewDoesNotFit) {
  const ScratchFolder folder;
  write_whole(folder / "a.json", "old");
  {
    const SizeLimit limit(10);
    EXPECT_THROW(write_whole(folder / "a.json", "longer than ten bytes"), FileError);
  }
  EXPECT_EQ(read_text(folder / "a.json"), "old");
  EXPECT_FALSE(std::filesystem::exists(folder / "a.json.part"));
}

/// Few files are flushed one by one, many with their disk. Those that have gone since are no fault.
TEST(UnflushedFiles, AreFlushedWhateverTheirNumber) {
  const ScratchFolder folder;
  for (const int count : {3, 100}) {
    UnflushedFiles files(true);
    for (int k = 0; k < count; ++k) files.add(folder.write("file-" + std::to_string(k), "text"));
    std::filesystem::remove(folder / "file-1");
    EXPECT_NO_THROW(files.flush());
  }
  UnflushedFiles gone(true);
  gone.add(folder / "no folder" / "file");
  EXPECT_NO_THROW(gone.flush());
}

TEST(UnflushedFiles, AFolderThatCannotBeFlushedIsNamed) {
  const ScratchFolder folder;
  test::expect_refusal<FileError>([&] { flush_names(folder / "none"); }, {"none: cannot write"});
}

}  // namespace output_file_test
}  // namespace nilas::output
