#include "core/base/log.h"

#include <gtest/gtest.h>
#include <spdlog/sinks/ostream_sink.h>

#include <sstream>

#include "core/base/error.h"
#include "tests/support/file_text.h"
#include "tests/support/scratch_folder.h"

namespace nilas {
namespace log_test {

TEST(WarningCounts, TheFirstOfAKindIsShownAllAreCounted) {
  std::ostringstream shown;
  auto sink = std::make_shared<spdlog::sinks::ostream_sink_mt>(shown);
  sink->set_pattern("%v");
  WarningCounts warnings(std::make_shared<spdlog::logger>("test", sink));
  warnings.warn("iterations", "solver stopped at t = 1 s");
  warnings.warn("iterations", "solver stopped at t = 2 s");
  warnings.warn("overlap", "floes overlap");
  EXPECT_EQ(shown.str(), "solver stopped at t = 1 s\nfloes overlap\n");
  EXPECT_EQ(warnings.counts(), (std::map<std::string, long>{{"iterations", 2}, {"overlap", 1}}));
  shown.str("");
  warnings.summarise();
  EXPECT_EQ(shown.str(), "iterations: 2 times in all\n");
}

TEST(MakeLogger, WritesDetailsToTheFileAtAnyConsoleLevel) {
  const test::ScratchFolder folder;
  const auto file = folder / "run.log";
  make_logger("off", file.string())->debug("a detail");
  const std::string text = test::read_text(file);
  EXPECT_NE(text.find("debug: a detail"), std::string::npos) << text;
}

TEST(MakeLogger, AppendsWhereAsked) {
  const test::ScratchFolder folder;
  const auto file = folder / "run.log";
  make_logger("off", file.string())->info("first");
  make_logger("off", file.string(), LogFile::append)->info("second");
  const std::string text = test::read_text(file);
  EXPECT_NE(text.find("first"), std::string::npos);
  EXPECT_NE(text.find("second"), std::string::npos);
}

TEST(MakeLogger, AFileThatCannotBeOpenedIsAFileError) {
  EXPECT_THROW(make_logger("off", "/dev/null/x.log"), FileError);
}

}  // namespace log_test
}  // namespace nilas
