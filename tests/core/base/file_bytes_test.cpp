#include "core/base/file_bytes.h"

#include <gtest/gtest.h>
#include <sys/stat.h>

#include <fstream>
#include <thread>

#include "core/base/error.h"
#include "tests/support/refusal.h"
#include "tests/support/scratch_folder.h"

namespace nilas {
namespace file_bytes_test {

namespace fs = std::filesystem;

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

TEST(FileBytes, NeitherDevicesNorEndlessFilesAreRead) {
  const test::ScratchFolder folder;
  fs::create_symlink("/dev/zero", folder / "link");
  for (const fs::path& path : {fs::path("/dev/zero"), folder / "link", fs::path("/dev/null")}) {
    test::expect_refusal<FileError>([&] { file_bytes(path); }, {"is a device"});
    test::expect_refusal<FileError>([&] { demand_file(path); }, {"is no file"});
  }
  fs::create_symlink("loop", folder / "loop");
  EXPECT_THROW(file_bytes(folder / "loop"), FileError);
  EXPECT_THROW(demand_file(folder / "loop"), FileError);
}

TEST(FileBytes, LargeFilesAreRefusedBeforeTheyAreRead) {
  const test::ScratchFolder folder;
  const fs::path file = folder.write("large", "");
  constexpr std::size_t k_terabyte = std::size_t{1} << 40;
  fs::resize_file(file, k_terabyte);  // it takes no place on the disk
  test::expect_refusal([&] { file_bytes(file); }, {"too large", "4096 MB"});
  EXPECT_EQ(file_bytes(folder.write("ten", "0123456789"), 10).size(), 10U);
  EXPECT_THROW(file_bytes(folder / "ten", 9), InputError);
}

TEST(FileBytes, PipesAreReadToTheEnd) {
  const test::ScratchFolder folder;
  const fs::path pipe = folder / "pipe";
  ASSERT_EQ(::mkfifo(pipe.c_str(), S_IRUSR | S_IWUSR), 0);
  const std::string sent(200000, 'x');
  std::thread writer([&] { std::ofstream(pipe) << sent; });
  EXPECT_EQ(file_bytes(pipe), sent);
  writer.join();
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
