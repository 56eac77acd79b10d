/// `nilas hydro`: its report, its exit codes, its picture and the forms that it writes.
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>

#include "tests/support/mentions.h"
#include "tests/support/program.h"

namespace hydro_test {

using namespace nilas_test;

const std::string k_data = std::string(NILAS_SOURCE_DIR) + "/tests/data/hydro/";
const std::string k_fpso = "hydro " + k_data + "mss/fpso.1 --length 1 --density 1025 --gravity 9.81";
const std::string k_fpso_body = " --volume 97960.9 --cog 0.788631 0 -1 --radii 16.3 54 54";

nlohmann::json hydro_json(const ScratchFolder& folder, const std::string& arguments) {
  const auto made = run_nilas(arguments + " --json", folder.path());
  EXPECT_EQ(made.exit_code, 0) << made.err;
  return nlohmann::json::parse(made.out, nullptr, false);
}

/// Natural periods of the coupled body, the two self-checks, and the limits of the added mass.
TEST(Hydro, ReportsOnTheFpso) {
  const ScratchFolder folder;
  const auto report = hydro_json(folder, k_fpso + k_fpso_body);
  EXPECT_EQ(report["frequencies"], 47);
  EXPECT_EQ(report["headings"], 19);
  EXPECT_TRUE(report["depth_m"].is_null());
  EXPECT_NEAR(report["modes"][2]["added_mass_infinite"].get<double>(), 1.7283e8, 1e4);
  ASSERT_EQ(report["natural_periods"].size(), 3u);
  EXPECT_EQ(report["natural_periods"][0]["mode"], "roll");
  EXPECT_NEAR(report["natural_periods"][1]["period_s"].get<double>(), 10.5, 0.1);
  for (const auto& row : report["haskind_newman"]) EXPECT_NEAR(row["median"].get<double>(), 1, 3e-3) << row;
  ASSERT_EQ(report["closure"].size(), 6u);
  for (const auto& row : report["closure"]) EXPECT_LT(row["share"].get<double>(), 5e-3) << row;
  EXPECT_TRUE(report["faults"].empty());
  EXPECT_FALSE(report["damping_positive"].get<bool>());
}

TEST(Hydro, PrintsTablesForPeople) {
  const ScratchFolder folder;
  const auto made = run_nilas(k_fpso, folder.path());
  EXPECT_EQ(made.exit_code, 0) << made.err;
  for (const char* words :
       {"47 frequencies from 0.03834", "Haskind-Newman", "A(inf)", "the mass of the body is not given"})
    EXPECT_TRUE(mentions(made.out, words)) << made.out;
  EXPECT_TRUE(mentions(made.err, "2 values of damping are negative: pitch")) << made.err;
}

TEST(Hydro, AWrongLengthEndsWithCode3AndAMissingOneWithCode2) {
  const ScratchFolder folder;
  const auto wrong = run_nilas("hydro " + k_data + "mss/fpso --length 2 --density 1025 --gravity 9.81", folder.path());
  EXPECT_EQ(wrong.exit_code, 3);
  EXPECT_TRUE(mentions(wrong.err, "ULEN")) << wrong.err;
  const auto missing = run_nilas("hydro " + k_data + "mss/fpso.3 --density 1025 --gravity 9.81", folder.path());
  EXPECT_EQ(missing.exit_code, 2);
  EXPECT_TRUE(mentions(missing.err, "the length of the computation is missing")) << missing.err;
  EXPECT_EQ(run_nilas("hydro nothing.h5", folder.path()).exit_code, 4);
}

TEST(Hydro, ConvertsAndDraws) {
  const ScratchFolder folder;
  const auto made = run_nilas(k_fpso + k_fpso_body + " --out a.h5 --picture a.png", folder.path());
  EXPECT_EQ(made.exit_code, 0) << made.err;
  EXPECT_GT(std::filesystem::file_size(folder / "a.png"), 10000u);
  EXPECT_EQ(run_nilas("hydro a.h5 --out b --out-length 10", folder.path()).exit_code, 0);
  const auto first = hydro_json(folder, k_fpso);
  const auto again = hydro_json(folder, "hydro b.hst --length 10 --density 1025 --gravity 9.81");
  const double expected = first["modes"][4]["damping_peak"], found = again["modes"][4]["damping_peak"];
  EXPECT_NEAR(found, expected, 2e-6 * expected);
}

/// A database without the added mass at infinite frequency serves a run once it is completed. The FPSO has its own,
/// with which that of Ogilvie's relation agrees: within 0.5 % in heave.
TEST(Hydro, CompletesADatabase) {
  const ScratchFolder folder;
  ASSERT_EQ(run_nilas(k_fpso + k_fpso_body + " --out whole", folder.path()).exit_code, 0);
  // Rows of period 0 are those of the infinite frequency.
  std::ifstream whole(folder / "whole.1");
  std::ofstream lacking(folder / "lacking.1");
  int left_out = 0;
  for (std::string row; std::getline(whole, row);) {
    if (std::stod(row) == 0)
      ++left_out;
    else
      lacking << row << "\n";
  }
  lacking.close();
  for (const char* kind : {".3", ".hst"})
    std::filesystem::copy_file(folder / (std::string("whole") + kind), folder / (std::string("lacking") + kind));
  EXPECT_EQ(left_out, 36);
  const std::string read = "hydro lacking.1 --length 1 --density 1025 --gravity 9.81";
  EXPECT_TRUE(hydro_json(folder, read)["modes"][2]["added_mass_infinite"].is_null());
  const auto made = run_nilas(read + k_fpso_body + " --complete --out completed.h5", folder.path());
  EXPECT_EQ(made.exit_code, 0) << made.err;
  EXPECT_TRUE(mentions(made.err, "Ogilvie's relation")) << made.err;
  const double own = hydro_json(folder, k_fpso)["modes"][2]["added_mass_infinite"];
  const double found = hydro_json(folder, "hydro completed.h5")["modes"][2]["added_mass_infinite"];
  EXPECT_NEAR(found, own, 5e-3 * own);
  const auto again = run_nilas("hydro completed.h5 --complete", folder.path());
  EXPECT_EQ(again.exit_code, 2);
  EXPECT_TRUE(mentions(again.err, "already")) << again.err;
}

TEST(Hydro, DoesNotReplaceItsOwnInput) {
  const ScratchFolder folder;
  EXPECT_EQ(run_nilas(k_fpso + " --out a", folder.path()).exit_code, 0);
  const auto made = run_nilas("hydro a.1 --length 1 --density 1025 --gravity 9.81 --out a", folder.path());
  EXPECT_EQ(made.exit_code, 2);
  EXPECT_TRUE(mentions(made.err, "would replace")) << made.err;
}

}  // namespace hydro_test
