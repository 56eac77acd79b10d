/// Pictures and films by `nilas view`. They need Chromium and ffmpeg; without them they fail, unless
/// NILAS_PAGE_TESTS_MAY_SKIP is 1.
/// NILAS_PAGE_TESTS_MAY_SKIP is 1.
#include <gtest/gtest.h>

#include <algorithm>
#include <chrono>
#include <thread>

#include "tests/apps/small_scenes.h"
#include "tests/support/mentions.h"
#include "tests/support/started_program.h"

namespace view_pictures_test {

using namespace nilas_test;
using nilas::test::mentions;

bool finds(const std::string& programs) { return std::system(("command -v " + programs + " >/dev/null").c_str()) == 0; }

bool has_browser() {
  return std::getenv("CHROME") != nullptr || finds("chromium") || finds("chromium-browser") || finds("google-chrome");
}

bool may_skip() {
  const char* const may = std::getenv("NILAS_PAGE_TESTS_MAY_SKIP");
  return may != nullptr && std::string(may) == "1";
}

/// The number of four bytes, the first one the highest.
std::uint32_t number_at(const std::string& bytes, std::size_t at) {
  std::uint32_t number = 0;
  for (std::size_t k = 0; k < 4; ++k) number = 256 * number + static_cast<unsigned char>(bytes.at(at + k));
  return number;
}

/// A run of a second, and a folder of its own for what the program leaves in between.
class ViewPictures : public ::testing::Test {
 protected:
  void SetUp() override {
    if (!has_browser() && may_skip()) GTEST_SKIP() << "There is no browser.";
    folder.write("ship.xml", k_ship);
    fs::create_directories(in("between"));
    ASSERT_EQ(run_nilas("run ship.xml --quiet --out run", folder.path()).exit_code, 0);
  }
  /// Calls `nilas view run` with the variables of the environment in front.
  ProgramResult view(const std::string& options, const std::string& variables = "") const {
    const fs::path out = in("out.txt"), err = in("err.txt");
    const std::string command = "cd '" + folder.path().string() + "' && env " + variables + " TMPDIR='" +
                                in("between").string() + "' '" NILAS_PROGRAM "' view run " + options + " >'" +
                                out.string() + "' 2>'" + err.string() + "' </dev/null";
    const int status = std::system(command.c_str());
    return {WIFEXITED(status) ? WEXITSTATUS(status) : -1, read_text(out), read_text(err)};
  }
  void expect_refusal(const std::string& options, int exit_code, const std::string& words,
                      const std::string& variables = "") const {
    const auto result = view(options, variables);
    EXPECT_EQ(result.exit_code, exit_code) << options << result.err;
    EXPECT_TRUE(mentions(result.err, words)) << result.err;
    EXPECT_TRUE(fs::is_empty(in("between"))) << options;
  }
  void expect_picture(const std::string& file, std::uint32_t width, std::uint32_t height) const {
    const std::string bytes = read_text(in(file));
    ASSERT_GT(bytes.size(), 3000U) << file;
    EXPECT_EQ(bytes.substr(0, 8), "\x89PNG\r\n\x1a\n") << file;
    EXPECT_EQ(number_at(bytes, 16), width) << file;
    EXPECT_EQ(number_at(bytes, 20), height) << file;
    EXPECT_EQ(bytes.substr(bytes.size() - 8, 4), "IEND") << file;
  }
  fs::path in(const std::string& file) const { return folder.path() / file; }

  ScratchFolder folder;
};

TEST_F(ViewPictures, TheSameCommandGivesTheSamePictures) {
  const auto first = view("--png 0.5,1 --size 640x360 --out a.png");
  ASSERT_EQ(first.exit_code, 0) << first.err;
  EXPECT_TRUE(mentions(first.out, "written: a-0.5s.png\nwritten: a-1s.png")) << first.out;
  ASSERT_EQ(view("--png 0.5 --size 640x360 --out b.png").exit_code, 0);
  ASSERT_EQ(view("--png 1 --size 640x360 --plain").exit_code, 0);
  for (const char* file : {"a-0.5s.png", "a-1s.png", "b.png", "run/view-1s.png"}) expect_picture(file, 640, 360);
  EXPECT_EQ(read_text(in("a-0.5s.png")), read_text(in("b.png"))) << "byte by byte";
  EXPECT_NE(read_text(in("a-0.5s.png")), read_text(in("a-1s.png")));
  EXPECT_NE(read_text(in("run/view-1s.png")), read_text(in("a-1s.png"))) << "plain";
  EXPECT_TRUE(fs::is_empty(in("between")));
}

TEST_F(ViewPictures, WhatCannotBeDrawnIsRefused) {
  expect_refusal("--png 3", 2, "allowed: a time from 0 to 1 s");
  expect_refusal("--png nan", 2, "--png: found nan; allowed: a finite number");
  expect_refusal("--frames f --speed inf", 2, "--speed: found inf");
  expect_refusal("--png 1 --look color=heat", 2, "Allowed: plain, speed, thickness");
  expect_refusal("--png 1 --look banana=2", 2, "--look: There is no option \"banana\". Allowed: view, follow, color");
  expect_refusal("--png 1 --look t=3", 2, "has an option of its own");
  expect_refusal("--png 1 --size 10x10", 2, "--size: found 10x10");
  expect_refusal("--png 1 --camera nowhere", 2, "allowed: scene, bow, side, top, stern");
  expect_refusal("--png 1 --camera 1,2,x,4,5,6", 2, "six numbers");
  expect_refusal("--png 1 --out nowhere/a.png", 4, "no folder");
  expect_refusal("--png 1 --frames f", 2, "at once");
  expect_refusal("--until 1", 2, "--mp4 or --frames");
  expect_refusal("--frames f --from 1 --until 0.5", 2, "at or after --from 1");
  expect_refusal("--frames f --fps 0", 2, "--fps");
  EXPECT_FALSE(fs::exists(in("f")));
}

TEST_F(ViewPictures, AMissingOrBrokenBrowserIsNamed) {
  expect_refusal("--png 1", 2, "Install the package chromium", "-u CHROME PATH=/nowhere");
  expect_refusal("--png 1 --browser nothing", 2, "--browser: nothing");
  expect_refusal("--png 1", 2, "CHROME: nothing", "CHROME=nothing");
  expect_refusal("--png 1 --browser /bin/true", 4, "true has ended before its time");
}

TEST_F(ViewPictures, AFilmIsDrawnPictureByPictureWithoutFfmpeg) {
  expect_refusal("--mp4", 2, "Without it, --frames DIR", "CHROME=/bin/true PATH=/nowhere");
  const auto result = view("--frames film --fps 5 --from 0.2 --until 0.8 --speed 0.5 --size 320x180 --camera bow");
  ASSERT_EQ(result.exit_code, 0) << result.err;
  EXPECT_TRUE(mentions(result.out, "7 pictures, 1.40 s at 5 pictures a second")) << result.out;
  for (int k = 0; k < 7; ++k) expect_picture("film/frame-00000" + std::to_string(k) + ".png", 320, 180);
  EXPECT_NE(read_text(in("film/frame-000002.png")), read_text(in("film/frame-000003.png")));
  expect_refusal("--frames film", 2, "not empty");
}

TEST_F(ViewPictures, AFilmIsWrittenByFfmpeg) {
  if (!finds("ffmpeg") && may_skip()) GTEST_SKIP() << "There is no ffmpeg.";
  for (const char* file : {"a.mp4", "b.mp4"})
    ASSERT_EQ(view(std::string("--mp4 ") + file + " --fps 5 --size 320x180").exit_code, 0);
  const std::string film = read_text(in("a.mp4"));
  EXPECT_EQ(film.substr(4, 4), "ftyp");
  EXPECT_EQ(film, read_text(in("b.mp4"))) << "byte by byte";
  expect_refusal("--mp4 a.mp4 --size 321x180", 2, "even numbers");
  expect_refusal("--mp4 film.avi", 2, "ends with .mp4");
  EXPECT_TRUE(std::none_of(fs::directory_iterator(folder.path()), fs::directory_iterator(),
                           [](const auto& entry) { return entry.path().extension() == ".part"; }));
}

TEST_F(ViewPictures, CtrlCEndsTheBrowserAndLeavesNoHalfFile) {
  ::setenv("TMPDIR", in("between").c_str(), 1);
  Started drawing(finds("ffmpeg") ? "view run --mp4 half.mp4 --fps 240 --speed 0.01 --size 320x180"
                                  : "view run --frames half --fps 240 --speed 0.01 --size 320x180",
                  folder.path());
  ::unsetenv("TMPDIR");
  while (drawing.runs() && fs::is_empty(in("between"))) std::this_thread::sleep_for(std::chrono::milliseconds(5));
  std::this_thread::sleep_for(std::chrono::milliseconds(1500));
  EXPECT_EQ(drawing.stop(SIGINT), 130) << read_text(in("err.txt"));
  EXPECT_FALSE(fs::exists(in("half.mp4")));
  EXPECT_FALSE(fs::exists(in(".half.mp4.part")));
  EXPECT_TRUE(fs::is_empty(in("between")));
}

}  // namespace view_pictures_test
