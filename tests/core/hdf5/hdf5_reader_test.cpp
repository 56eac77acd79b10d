/// Tests of files that crash HDF5 or lead it astray: the process that reads them ends, and this one goes on.
#include <gtest/gtest.h>
#include <signal.h>
#include <unistd.h>

#include <atomic>
#include <fstream>
#include <thread>

#include "core/base/error.h"
#include "core/hdf5/hdf5_columns.h"
#include "core/hdf5/hdf5_file.h"
#include "core/hdf5/reading_process.h"
#include "tests/support/scratch_folder.h"

namespace nilas::hdf5 {
namespace hdf5_reader_test {

using test::ScratchFolder;

std::string refusal(const std::function<void()>& call) {
  try {
    call();
  } catch (const InputError& fault) {
    return fault.what();
  } catch (const FileError& fault) {
    return std::string("file: ") + fault.what();
  }
  return "";
}

TEST(Hdf5Reader, ReadsWhatWasWritten) {
  const ScratchFolder folder;
  Hdf5Writer writer;
  writer.add_group("g");
  std::vector<double> numbers(300000);
  for (std::size_t k = 0; k < numbers.size(); ++k) numbers[k] = 0.1 * static_cast<double>(k);
  writer.add("g/numbers", numbers);
  writer.add("g/integers", std::vector<std::int64_t>{1, -2, std::int64_t{1} << 60});
  writer.add("none", std::vector<double>{});
  writer.add("title", std::string("a title"));
  writer.save(folder / "a.h5");
  const Hdf5Reader file(folder / "a.h5"), again(folder / "a.h5", Hdf5Reader::Place::disk);
  for (const Hdf5Reader* one : {&file, &again}) {
    EXPECT_EQ(one->exact_numbers("g/numbers"), numbers);
    EXPECT_EQ(one->wide_integers("g/integers"), (std::vector<std::int64_t>{1, -2, std::int64_t{1} << 60}));
    EXPECT_EQ(one->numbers("none").size(), 0);
    EXPECT_EQ(one->text("title"), "a title");
    EXPECT_EQ(one->text("other"), "");
    EXPECT_EQ(one->shape("g/numbers"), std::vector<std::size_t>{300000});
    EXPECT_EQ(one->datasets("g"), (std::vector<std::string>{"integers", "numbers"}));
    EXPECT_TRUE(one->has("g"));
    EXPECT_FALSE(one->has("h"));
  }
  EXPECT_NE(refusal([&] { file.integers("g/integers"); }).find("beyond 32 bits"), std::string::npos);
  EXPECT_NE(refusal([&] { file.integers("h"); }).find("a.h5: /h: is missing"), std::string::npos);
}

/// The labels and the numbers of a database of Capytaine. What HDF5 reads no further is passed over.
void read_database(const std::filesystem::path& path) {
  const Hdf5Reader file(path);
  for (const std::string name : {"radiating_dof", "influenced_dof", "added_mass", "omega"}) try {
      file.dimension_names(name);
      if (file.kind(name) == Hdf5Reader::Kind::numbers)
        file.exact_numbers(name);
      else
        file.texts(name);
    } catch (const InputError& fault) {
      if (std::string(fault.what()).find("HDF5 itself") != std::string::npos) throw;
    }
}

TEST(Hdf5Reader, RefusesAFileThatCrashesHdf5) {
  const std::filesystem::path stored = std::filesystem::path(NILAS_SOURCE_DIR) / "tests/fuzz";
  EXPECT_NE(refusal([&] { read_database(stored / "findings/bem_hdf5/crash"); }).find("is damaged: HDF5 itself crashed"),
            std::string::npos);
  EXPECT_NO_THROW(read_database(stored / "corpus/bem_hdf5/capytaine"));
}

/// HDF5 would wait ever longer for the program that writes the file.
TEST(Hdf5Reader, AFileCutShortIsNotAwaited) {
  const ScratchFolder folder;
  const Hdf5Columns::Layout layout{
      "rows", "of a test", "blocks", "first and last", {{"x_m", "m", "a number", std::vector<double>{}}}};
  {
    Hdf5Columns columns(folder / "a.h5", layout);
    columns.add(1.0);
    columns.end_row();
    columns.end_block();
    columns.write();
  }
  std::filesystem::resize_file(folder / "a.h5", std::filesystem::file_size(folder / "a.h5") / 2);
  EXPECT_THROW(Hdf5Columns(folder / "a.h5", layout, Hdf5Columns::Length{1, 1}), InputError);
}

std::string told(const std::function<void(int)>& child, ReadingLimits limits = {std::size_t{256} << 20, 5}) {
  return refusal([&] {
    ReadingProcess process("a.h5", limits, child);
    char answer = 0;
    process.receive({&answer, 1});
  });
}

/// Keeps the compiler from leaving out what has no effect.
std::atomic<long> sink = 0;

TEST(ReadingProcess, TellsHowItEnded) {
  EXPECT_EQ(told([](int) { ::raise(SIGSEGV); }), "a.h5: is damaged: HDF5 itself crashed at it (signal 11)");
  EXPECT_EQ(told([](int) { ::raise(SIGABRT); }), "a.h5: is damaged: HDF5 itself crashed at it (signal 6)");
  EXPECT_EQ(told([](int) { ::_exit(0); }), "a.h5: is damaged: HDF5 itself ended at it");
  EXPECT_EQ(told([](int) { throw 1; }), "a.h5: is damaged: HDF5 itself ended at it");
  EXPECT_EQ(told([](int) { ::raise(SIGKILL); }),
            "file: a.h5: cannot be read: the process that read it was ended by signal 9");
}

TEST(ReadingProcess, EndsWhereItTakesTooLong) {
  const auto endless = [](int) {
    while (true) ++sink;
  };
  EXPECT_EQ(told(endless, {std::size_t{256} << 20, 1}),
            "a.h5: is damaged: HDF5 itself took more than 1 s of processor time for it");
}

TEST(ReadingProcess, HasBoundedMemory) {
  const auto greedy = [](int socket) {
    const std::unique_ptr<void, void (*)(void*)> much(std::malloc(std::size_t{1} << 30), std::free);
    const std::unique_ptr<void, void (*)(void*)> some(std::malloc(std::size_t{1} << 26), std::free);
    const char answer = much ? 'm' : some ? 's' : 'n';
    send_bytes(socket, {&answer, 1});
  };
  ReadingProcess process("a.h5", {std::size_t{256} << 20, 5}, greedy);
  char answer = 0;
  process.receive({&answer, 1});
  EXPECT_EQ(answer, 's');
}

/// A process can be copied while other threads take memory and read files.
TEST(Hdf5Reader, ThreadsReadAtOnce) {
  const ScratchFolder folder;
  Hdf5Writer writer;
  writer.add("x", std::vector<double>{1, 2, 3});
  writer.save(folder / "a.h5");
  std::atomic<int> good = 0;
  std::vector<std::thread> threads;
  for (int k = 0; k < 4; ++k)
    threads.emplace_back([&] {
      for (int each = 0; each < 10; ++each)
        if (Hdf5Reader(folder / "a.h5").exact_numbers("x") == std::vector<double>{1, 2, 3}) ++good;
    });
  for (auto& thread : threads) thread.join();
  EXPECT_EQ(good, 40);
}

TEST(Hdf5Reader, LeavesNoProcessAndNoOpenFile) {
  const ScratchFolder folder;
  Hdf5Writer writer;
  writer.add("x", std::vector<double>{1});
  writer.save(folder / "a.h5");
  folder.write("b.h5", "no HDF5");
  const auto open_files = [] {
    return std::distance(std::filesystem::directory_iterator("/proc/self/fd"), std::filesystem::directory_iterator());
  };
  Hdf5Reader(folder / "a.h5").has("x");
  const auto before = open_files();
  for (int k = 0; k < 5; ++k) {
    Hdf5Reader(folder / "a.h5").has("x");
    EXPECT_THROW(Hdf5Reader(folder / "b.h5"), InputError);
  }
  EXPECT_EQ(open_files(), before);
  std::ifstream children("/proc/self/task/" + std::to_string(::getpid()) + "/children");
  std::string child;
  EXPECT_FALSE(children >> child) << child;
}

}  // namespace hdf5_reader_test
}  // namespace nilas::hdf5
