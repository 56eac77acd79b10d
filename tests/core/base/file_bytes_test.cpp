#include "core/base/file_bytes.h"

#include <gtest/gtest.h>

#include "core/base/error.h"
#include "tests/support/scratch_folder.h"

namespace nilas {
namespace file_bytes_test {

TEST(FileBytes, AreThoseOfTheFile) {
  const test::ScratchFolder folder;
  for (const std::size_t size : {0u, 1u, 65535u, 65536u, 65537u, 200000u}) {
    std::string bytes(size, 'x');
    for (std::size_t k = 0; k < size; ++k) bytes[k] = static_cast<char>(k * 7);
    EXPECT_EQ(file_bytes(folder.write("bytes", bytes)), bytes) << size;
  }
}

TEST(FileBytes, WhatCannotBeReadIsNoEmptyFile) {
  const test::ScratchFolder folder;
  EXPECT_THROW(file_bytes("/proc/self/mem"), FileError);  // opens, and fails at its first byte
  EXPECT_THROW(file_bytes(folder / "absent"), FileError);
  EXPECT_THROW(file_bytes(folder / "."), FileError);
}

TEST(FileBytes, AnAbsentFileIsToldWithTheNearestName) {
  const test::ScratchFolder folder;
  folder.write("towing.xml", "x");
  folder.write("else.txt", "x");
  const auto told = [&](const std::string& name) { return std::string(nothing_there(folder / name, "file").what()); };
  const std::string place = (folder / "").string();
  EXPECT_EQ(told("toing.xml"), place + "toing.xml: there is no such file; nearest: " + place + "towing.xml");
  EXPECT_EQ(told("q"), place + "q: there is no such file");
  EXPECT_EQ(std::string(nothing_there("no-such-folder/file", "file").what()),
            "no-such-folder/file: there is no such file");
}

TEST(IsFolder, TellsFoldersFromFilesAndFromNothing) {
  const test::ScratchFolder folder;
  EXPECT_TRUE(is_folder(folder / "."));
  EXPECT_FALSE(is_folder(folder.write("file", "x")));
  std::filesystem::create_symlink("loop", folder / "loop");
  for (const auto& name : {std::string("absent"), std::string("loop"), std::string(300, 'x')})
    EXPECT_THROW(is_folder(folder / name), FileError) << name;
}

}  // namespace file_bytes_test
}  // namespace nilas
