/// nilas compare as a user runs it: tables that repeat, errors of known size, and a clear end whatever happens.
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "core/output/text/html.h"
#include "tests/apps/compare_scenes.h"
#include "tests/support/size_limit.h"
#include "tests/support/started_program.h"

namespace compare_test {

using namespace nilas_test;

TEST(Compare, LeavesTablesPicturesAndAPageThatSayTheSame) {
  const ScratchFolder folder;
  folder.write("ship.xml", k_ship);
  const auto result =
      run_nilas("compare ship.xml --out out --solvers auto,nsgs --dt 0.01,0.005 --seeds 2 --jobs 2", folder.path());
  ASSERT_EQ(result.exit_code, 0) << result.out << result.err;
  const fs::path out = folder.path() / "out";
  const auto json = json_of(out / "compare.json");
  EXPECT_EQ(json["settings"].size(), 4U);
  EXPECT_TRUE(json["complete"]);
  EXPECT_EQ(json["measure"], "load");
  EXPECT_EQ(json["load_error_coverage"]["runs"], 8);
  const Table runs(out / "compare.csv");
  // 4 settings, a perturbed run and a reference for each of 2 realisations, and one run to check the reference.
  EXPECT_EQ(runs.rows(), 4U * 2 + 2 + 2 + 1);
  for (const auto& status : runs.text("status")) EXPECT_EQ(status, "done");
  EXPECT_TRUE(runs.has("contact_fx_p99_N"));
  EXPECT_TRUE(runs.has("law_map_m_s"));
  const Table settings(out / "settings.csv");
  for (std::size_t k = 0; k < settings.rows(); ++k) {
    EXPECT_EQ(settings.text("label")[k], json["settings"][k]["label"]);
    EXPECT_GT(settings["compute_s_per_s"][k], 0);
    EXPECT_TRUE(std::isfinite(settings["load_difference_N"][k]));
    EXPECT_NE(settings["load_N"][k], 0);
  }
  for (const char* name : {"front.svg", "front.png", "compare.html"})
    EXPECT_GT(fs::file_size(out / name), 1000U) << name;
  expect_page(out, nilas::output::html_text(json["text"][0].get<std::string>().substr(0, 20)));
  EXPECT_EQ(read_text(out / "compare.html").find("http"), read_text(out / "compare.html").find("http://www.w3.org"));
  EXPECT_NE(result.out.find("parallel efficiency"), std::string::npos) << result.out;
}

TEST(Compare, AHostileNameDoesNotBreakItsPage) {
  const ScratchFolder folder;
  folder.write("sh<i>p&.xml", k_ship);
  const auto result = run_nilas("compare \"sh<i>p&.xml\" --dt 0.01,0.005 --seeds 1 --quiet --out out", folder.path());
  ASSERT_EQ(result.exit_code, 0) << result.err;
  expect_page(folder.path() / "out", "sh&lt;i&gt;p&amp;: accuracy and cost");
  EXPECT_EQ(read_text(folder.path() / "out/compare.html").find("<i>"), std::string::npos);
}

TEST(Compare, GivesTheSameTableAgainButForTimings) {
  const ScratchFolder folder;
  folder.write("ship.xml", k_ship);
  for (const char* out : {"a", "b"})
    ASSERT_EQ(
        run_nilas(
            std::string("compare ship.xml --solvers auto,pgs --laws coulomb,pyramid --seeds 2 --quiet --out ") + out,
            folder.path())
            .exit_code,
        0);
  const Table a(folder.path() / "a/compare.csv"), b(folder.path() / "b/compare.csv");
  EXPECT_EQ(a.header(), b.header());
  for (const auto& column : a.header()) {
    const bool timing =
        column.rfind("ms_", 0) == 0 || column == "cpu_s" || column == "wall_s" || column == "compute_s_per_s";
    if (timing) continue;
    EXPECT_EQ(a.text(column), b.text(column)) << column;
  }
  EXPECT_EQ(read_text(folder.path() / "a/loads.csv"), read_text(folder.path() / "b/loads.csv"));
  const Table c(folder.path() / "a/settings.csv"), d(folder.path() / "b/settings.csv");
  for (const auto& column : c.header()) {
    const bool timing =
        column.rfind("compute_", 0) == 0 || column == "ms_per_step" || column == "dominated" || column == "chosen";
    if (timing) continue;
    EXPECT_EQ(c.text(column), d.text(column)) << column;
  }
}

TEST(Compare, SaysWhatCannotRunTogether) {
  const ScratchFolder folder;
  folder.write("ship.xml", k_ship);
  const auto result = run_nilas(
      "compare ship.xml --out out --solvers auto,pgs --laws coulomb,ccp --seeds 1 --until 0.05", folder.path());
  EXPECT_EQ(result.exit_code, 0) << result.err;
  EXPECT_NE(result.out.find("cannot run: pgs + ccp"), std::string::npos) << result.out;
  EXPECT_EQ(json_of(folder.path() / "out/compare.json")["cannot_run"].size(), 1U);
}

TEST(Compare, RefusesNamesThatDoNotExist) {
  const ScratchFolder folder;
  folder.write("ship.xml", k_ship);
  const auto refused = [&](const std::string& flags, const std::string& words) {
    const auto result = run_nilas("compare ship.xml --out out " + flags, folder.path());
    EXPECT_EQ(result.exit_code, 2) << flags;
    EXPECT_NE(result.err.find(words), std::string::npos) << result.err;
    EXPECT_FALSE(fs::exists(folder.path() / "out")) << flags;
  };
  refused("--solvers auto,newtn", "newton");
  refused("--laws colomb", "coulomb");
  refused("--integrators moro", "moreau");
  refused("--stabilisations project", "projection");
  refused("--dt 0.01,-1", "--dt");
  refused("--solvers auto", "nothing to compare");
  refused("--reference nowhere --solvers nsgs", "no run folder");
  EXPECT_EQ(run_nilas("compare nowhere.xml --out out", folder.path()).exit_code, 4);
  EXPECT_EQ(run_nilas("compare --resume nowhere", folder.path()).exit_code, 4);
  EXPECT_EQ(run_nilas("compare --resume .", folder.path()).exit_code, 2);
}

TEST(Compare, AFailingSettingStaysInTheTable) {
  const ScratchFolder folder;
  folder.write("stack.xml", stack("tolerance=\"10\" on_failure=\"stop\""));
  const auto result =
      run_nilas("compare stack.xml --out out --solvers nsgs,newton --tolerance 10,1e-12 --seeds 1", folder.path());
  EXPECT_EQ(result.exit_code, 0) << result.out << result.err;
  const Table runs(folder.path() / "out/compare.csv");
  bool failed = false;
  for (std::size_t k = 0; k < runs.rows(); ++k) {
    if (runs.text("status")[k] != "failed") continue;
    failed = true;
    EXPECT_NE(runs.text("cause")[k].find("exit code 3"), std::string::npos) << runs.text("cause")[k];
  }
  EXPECT_TRUE(failed);
  expect_page(folder.path() / "out", "runs failed");
}

TEST(Compare, GoesOnAfterAKillAndDoesNotRunAgainWhatIsDone) {
  const ScratchFolder folder;
  folder.write("ship.xml", k_ship);
  const std::string grid = "compare ship.xml --solvers auto,nsgs,apgd --dt 0.01,0.005 --seeds 2 --quiet --out out";
  {
    Started started(grid, folder.path());
    const auto results = [&] {
      std::error_code error;
      return std::distance(fs::directory_iterator(folder.path() / "out/results", error), fs::directory_iterator{});
    };
    while (started.runs() && (!fs::exists(folder.path() / "out/results") || results() < 3))
      std::this_thread::sleep_for(std::chrono::milliseconds(2));
    started.stop(SIGKILL);
  }
  std::map<std::string, fs::file_time_type> done;
  for (const auto& entry : fs::directory_iterator(folder.path() / "out/results"))
    if (entry.path().extension() == ".json") done[entry.path().string()] = entry.last_write_time();
  ASSERT_FALSE(done.empty());
  const auto result = run_nilas("compare --resume out --quiet", folder.path());
  EXPECT_EQ(result.exit_code, 0) << result.err;
  for (const auto& [file, time] : done) EXPECT_EQ(fs::last_write_time(file), time) << file;
  const Table runs(folder.path() / "out/compare.csv");
  for (const auto& status : runs.text("status")) EXPECT_EQ(status, "done");
  EXPECT_TRUE(json_of(folder.path() / "out/compare.json")["complete"]);
}

TEST(Compare, InterruptedLeavesAPageAndCode130) {
  const ScratchFolder folder;
  folder.write("ship.xml", k_ship);
  Started started("compare ship.xml --until 20 --dt 0.01,0.001 --out out --budget 0 --quiet", folder.path());
  while (started.runs() && !fs::exists(folder.path() / "out/compare.html"))
    std::this_thread::sleep_for(std::chrono::milliseconds(5));
  EXPECT_EQ(started.stop(SIGINT), 130);
  expect_page(folder.path() / "out", "it was interrupted");
}

TEST(Compare, ABudgetOfASecondStillLeavesAPage) {
  const ScratchFolder folder;
  folder.write("ship.xml", k_ship);
  const auto result = run_nilas("compare ship.xml --until 600 --out out --budget 1", folder.path());
  EXPECT_TRUE(result.exit_code == 0 || result.exit_code == 3) << result.err;
  EXPECT_NE(result.out.find("left out"), std::string::npos) << result.out;
  expect_page(folder.path() / "out", "budget");
}

TEST(Compare, AFullDiskIsAFileError) {
  const ScratchFolder folder;
  folder.write("ship.xml", k_ship);
  ProgramResult result;
  {
    const nilas::test::SizeLimit limit(1000);
    result = run_nilas("compare ship.xml --dt 0.01,0.005 --seeds 1 --out out", folder.path());
  }
  EXPECT_EQ(result.exit_code, 4) << result.out << result.err;
  EXPECT_FALSE(fs::exists(folder.path() / "out")) << "there was not even room for a plan";
}

TEST(Compare, ADiskThatFillsUpDuringTheRunsLeavesAPageAndCanGoOn) {
  const ScratchFolder folder;
  folder.write("ship.xml", k_ship);
  ProgramResult result;
  {
    const nilas::test::SizeLimit limit(60000);  // the page has about half of it, and tables of a run have more
    result = run_nilas("compare ship.xml --dt 0.01,0.005 --seeds 1 --out out", folder.path());
  }
  EXPECT_EQ(result.exit_code, 4) << result.out << result.err;
  EXPECT_NE(result.err.find("out/runs"), std::string::npos) << result.err;
  expect_page(folder.path() / "out", "--resume continues it");
  EXPECT_EQ(run_nilas("compare --resume out --quiet", folder.path()).exit_code, 0);
  const Table runs(folder.path() / "out/compare.csv");
  for (const auto& status : runs.text("status")) EXPECT_EQ(status, "done");
}

TEST(Compare, WithoutItsReferenceIsJudgedByTheMostAccurateThatIsDoneAndSaysSo) {
  const ScratchFolder folder;
  folder.write("ship.xml", k_ship);
  ASSERT_EQ(run_nilas("compare ship.xml --dt 0.01,0.005 --seeds 1 --out out --quiet", folder.path()).exit_code, 0);
  // as a reference that the budget ended
  for (const char* id : {"reference-r0", "check-r0"})
    fs::remove(folder.path() / "out/results" / (std::string(id) + ".json"));
  const auto result = run_nilas("compare --resume out --budget 0.01", folder.path());
  EXPECT_EQ(result.exit_code, 0) << result.out << result.err;
  EXPECT_EQ(json_of(folder.path() / "out/compare.json")["judged_in_its_place_by"], "\"step 0.005 s\"");
  expect_page(folder.path() / "out", "in its place");
}

TEST(Compare, SaysWhatMoreTimeWouldTellAndItsCommandDoesIt) {
  const ScratchFolder folder;
  folder.write("ship.xml", k_ship);
  ASSERT_EQ(run_nilas("compare ship.xml --solvers auto,nsgs --dt 0.01,0.005 --seeds 2 --out out --quiet", folder.path())
                .exit_code,
            0);
  // as where the budget ended in the second realisation
  for (const char* id : {"s01-r1", "s02-r1", "s03-r1"})
    fs::remove(folder.path() / "out/results" / (std::string(id) + ".json"));
  const auto cut = run_nilas("compare --resume out --budget 0.01", folder.path());
  EXPECT_EQ(cut.exit_code, 0) << cut.out << cut.err;
  auto json = json_of(folder.path() / "out/compare.json");
  EXPECT_EQ(json["shared_realisations"], nlohmann::json({0}));
  for (const auto& setting : json["settings"]) EXPECT_EQ(setting["load_N"]["runs"], 1) << setting;
  ASSERT_TRUE(json["with_more_time"]["next"].is_object());
  EXPECT_EQ(json["with_more_time"]["next"]["missing_runs"], 3);
  const std::string command = json["with_more_time"]["next"]["command"];
  EXPECT_EQ(command.rfind("nilas compare --resume out --budget ", 0), 0U) << command;
  EXPECT_NE(cut.out.find("all 4 settings would have 2 realisations"), std::string::npos) << cut.out;
  EXPECT_NE(cut.out.find("\n  " + command + "\n"), std::string::npos) << cut.out;
  expect_page(folder.path() / "out", command);
  EXPECT_EQ(run_nilas(command.substr(std::string("nilas ").size()), folder.path()).exit_code, 0);
  json = json_of(folder.path() / "out/compare.json");
  EXPECT_TRUE(json["complete"]);
  EXPECT_EQ(json["shared_realisations"], nlohmann::json({0, 1}));
  for (const auto& setting : json["settings"]) EXPECT_EQ(setting["load_N"]["runs"], 2) << setting;
}

TEST(Compare, GrowsByRealisations) {
  const ScratchFolder folder;
  folder.write("ship.xml", k_ship);
  ASSERT_EQ(run_nilas("compare ship.xml --solvers auto,nsgs --seeds 1 --out out --quiet", folder.path()).exit_code, 0);
  EXPECT_EQ(run_nilas("compare --resume out --seeds 3 --quiet", folder.path()).exit_code, 0);
  const auto json = json_of(folder.path() / "out/compare.json");
  EXPECT_TRUE(json["complete"]);
  EXPECT_EQ(json["realisations"], 3);
  for (const auto& setting : json["settings"]) EXPECT_EQ(setting["done"], 3);
  EXPECT_EQ(json["settings"][1]["from_own"]["realisations"], nlohmann::json({0, 1, 2}));
  const auto fewer = run_nilas("compare --resume out --seeds 2", folder.path());
  EXPECT_EQ(fewer.exit_code, 2);
  EXPECT_NE(fewer.err.find("has 3 realisations"), std::string::npos) << fewer.err;
}

TEST(Compare, JudgesByTheIceLoadOverOneWindowForAll) {
  const ScratchFolder folder;
  folder.write("ship.xml", k_ship);
  ASSERT_EQ(run_nilas("compare ship.xml --dt 0.02,0.01,0.005 --seeds 1 --keep-runs --out out --quiet", folder.path())
                .exit_code,
            0);
  const fs::path out = folder.path() / "out";
  const auto json = json_of(out / "compare.json");
  EXPECT_EQ(json["channel"], "ice_resistance_N");
  const double from = json["windows"][0]["from_s"], to = json["windows"][0]["to_s"];
  EXPECT_GT(from, 0.05) << "after the ramp";
  EXPECT_NEAR(std::remainder(from, 0.02), 0, 1e-9) << "where all steps end";
  const Table runs(out / "compare.csv");
  for (std::size_t k = 0; k < runs.rows(); ++k) {
    const Table vessel(out / "runs" / runs.text("id")[k] / "vessel.csv");
    double impulse = 0;
    for (std::size_t row = 0; row < vessel.rows(); ++row)
      if (vessel["time_s"][row] > from + 1e-9) impulse += vessel["ice_resistance_N"][row] * runs["step_s"][k];
    EXPECT_NEAR(runs["ice_resistance_mean_N"][k], impulse / (to - from), 1e-9) << runs.text("id")[k];
    EXPECT_GT(runs["ice_resistance_mean_N"][k], 0) << "positive astern";
  }
}

TEST(Compare, LeavesAloneARunsFolderThatItDidNotWrite) {
  const ScratchFolder folder;
  folder.write("ship.xml", k_ship);
  fs::create_directories(folder.path() / "runs/precious");
  const auto result = run_nilas("compare ship.xml --dt 0.01,0.005 --out . --force", folder.path());
  EXPECT_EQ(result.exit_code, 2) << result.err;
  EXPECT_TRUE(fs::exists(folder.path() / "runs/precious"));
}

TEST(Compare, CanBeJudgedByARunFolder) {
  const ScratchFolder folder;
  folder.write("ship.xml", k_ship);
  ASSERT_EQ(run_nilas("run ship.xml --out truth --quiet", folder.path()).exit_code, 0);
  const auto result =
      run_nilas("compare ship.xml --dt 0.01,0.005 --seeds 1 --reference truth --out out --quiet", folder.path());
  ASSERT_EQ(result.exit_code, 0) << result.err;
  const Table settings(folder.path() / "out/settings.csv");
  auto row = rows_by(settings, "label");
  EXPECT_EQ(settings["load_difference_N"][row["own setting"]], 0);
  EXPECT_NE(settings["load_difference_N"][row["step 0.005 s"]], 0);
}

TEST(Compare, IsNotJudgedByARunOfOtherIce) {
  const ScratchFolder folder;
  folder.write("ship.xml", k_ship);
  ASSERT_EQ(run_nilas("run ship.xml --seed 5 --out truth --quiet", folder.path()).exit_code, 0);
  const auto result = run_nilas("compare ship.xml --dt 0.01,0.005 --reference truth --out out", folder.path());
  EXPECT_EQ(result.exit_code, 2);
  EXPECT_NE(result.err.find("has the seed 5"), std::string::npos) << result.err;
}

}  // namespace compare_test
