/// `nilas verify` as a user runs it.
#include <gtest/gtest.h>

#include <fstream>
#include <nlohmann/json.hpp>
#include <regex>
#include <sstream>

#include "apps/verify/case.h"
#include "tests/support/program.h"

namespace verify_test {

using namespace nilas_test;

const std::filesystem::path k_docs = std::filesystem::path(NILAS_SOURCE_DIR) / "docs";

TEST(Verify, EveryRowOfTheDefaultSetHolds) {
  const ScratchFolder folder;
  const auto result = run_nilas("verify --quiet --html --out table", folder.path());
  EXPECT_EQ(result.exit_code, 0) << result.out << result.err;
  const std::string page = read_text(folder.path() / "table/verify.html");
  for (const char family : std::string("ABCDEFGH")) {
    EXPECT_NE(page.find(std::string("<h2>") + family + " "), std::string::npos);
    EXPECT_TRUE(std::filesystem::exists(folder.path() / ("table/family-" + std::string(1, family) + ".png")));
  }
  EXPECT_NE(page.find("<svg"), std::string::npos);
  EXPECT_EQ(page.find("http-equiv"), std::string::npos);
}

TEST(Verify, RowsAreJson) {
  const ScratchFolder folder;
  const auto result = run_nilas("verify --case A5 --law pyramid --solver pgs --json", folder.path());
  ASSERT_EQ(result.exit_code, 0) << result.err;
  const auto json = nlohmann::json::parse(result.out);
  ASSERT_FALSE(json["rows"].empty());
  for (const auto& row : json["rows"]) {
    for (const char* name : {"case", "family", "law", "solver", "integrator", "step_s", "measured", "expected", "error",
                             "tolerance", "order", "verdict"})
      EXPECT_TRUE(row.contains(name)) << name;
    EXPECT_EQ(row["law"], "pyramid");
    EXPECT_EQ(row["solver"], "pgs");
    EXPECT_EQ(row["verdict"], "holds");
    EXPECT_LE(row["error"].get<double>(), row["tolerance"].get<double>());
  }
}

TEST(Verify, TheTableFitsATerminal) {
  const ScratchFolder folder;
  const auto result = run_nilas("verify --solver auto --case A --case B --case D --case F", folder.path());
  ASSERT_EQ(result.exit_code, 0) << result.err;
  std::istringstream lines(result.out);
  int count = 0;
  for (std::string line; std::getline(lines, line); ++count) EXPECT_LE(line.size(), 80u) << line;
  EXPECT_GT(count, 300);
}

TEST(Verify, WrongNamesAreBadInput) {
  const ScratchFolder folder;
  EXPECT_EQ(run_nilas("verify --case Q1", folder.path()).exit_code, 2);
  EXPECT_EQ(run_nilas("verify --solver nwton", folder.path()).exit_code, 2);
  const auto law = run_nilas("verify --law colomb", folder.path());
  EXPECT_EQ(law.exit_code, 2);
  EXPECT_NE(law.err.find("coulomb"), std::string::npos);
}

TEST(Verify, AFolderWithOthersFilesIsNotTouched) {
  const ScratchFolder folder;
  folder.write("mine/notes.txt", "mine");
  EXPECT_EQ(run_nilas("verify --case A3 --solver auto --out mine", folder.path()).exit_code, 2);
  EXPECT_EQ(run_nilas("verify --case A3 --solver auto --out mine --force --quiet", folder.path()).exit_code, 0);
  EXPECT_EQ(read_text(folder.path() / "mine/notes.txt"), "mine");
  EXPECT_EQ(read_text(folder.path() / "mine/verify.csv").substr(0, 12), "case,family,");
}

/// The page of limitations without the times, which are those of the run that wrote it.
std::string without_times(const std::string& page) {
  return std::regex_replace(page, std::regex("[0-9.e+-]+ (\\| 1 \\| - \\|\n)"), "a time $1");
}

TEST(Verify, ThePagesAreThoseOfTheProgram) {
  const ScratchFolder folder;
  // compared as a whole: gtest would print both pages
  EXPECT_TRUE(read_text(k_docs / "evidence/verification.md") == run_nilas("verify --markdown", folder.path()).out)
      << "write it again: build/release/nilas verify --markdown > docs/evidence/verification.md";
  const std::string limitations = without_times(run_nilas("verify --limitations", folder.path()).out);
  EXPECT_NE(limitations.find("| a time | 1 | - |"), std::string::npos);
  EXPECT_TRUE(without_times(read_text(k_docs / "evidence/limitations.md")) == limitations)
      << "write it again: build/release/nilas verify --limitations > docs/evidence/limitations.md";
}

TEST(Verify, ThePagesNameAsManyCasesAsThereAre) {
  const std::regex count("([0-9]+) cases (with known answers|were below)");
  const std::filesystem::path root = NILAS_SOURCE_DIR;
  for (const auto& page : {root / "README.md", root / "docs/evidence/validation-scenes.md"}) {
    const std::string text = read_text(page);
    std::smatch found;
    ASSERT_TRUE(std::regex_search(text, found, count)) << page;
    EXPECT_EQ(std::stoul(found[1]), nilas::verify::catalogue().size()) << page;
  }
}

TEST(Verify, TheExtremesAreDrawn) {
  const ScratchFolder folder;
  const auto result = run_nilas("verify --extremes --case friction --solver auto --out map", folder.path());
  EXPECT_EQ(result.exit_code, 0) << result.out << result.err;
  EXPECT_GT(std::filesystem::file_size(folder.path() / "map/extremes.png"), 1000u);
  EXPECT_NE(read_text(folder.path() / "map/extremes.csv").find("friction"), std::string::npos);
}

}  // namespace verify_test
