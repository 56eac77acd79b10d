/// `nilas report`: the page of a run, of what is left of one, and of several.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <regex>

#include "core/hdf5/hdf5_file.h"
#include "tests/apps/small_scenes.h"
#include "tests/support/mentions.h"
#include "tests/support/program.h"

namespace report_page_test {

using namespace nilas_test;
using nilas::test::mentions;
using Json = nlohmann::json;

constexpr const char* k_pier = R"(<scene version="1" name="piers">
  <time step="0.01" end="1"/>
  <contact tolerance="1e-6"><friction between="* ice" static="0.1" kinetic="0.1"/></contact>
  <water density="1025"><current velocity="0.5 0 0"/></water>
  <hydro><buoyancy/><drag form="1" skin="0.005"/></hydro>
  <body name="west" shape="cylinder" radius="0.5" height="6" position="0 0 0" fixed="true"/>
  <body name="east" shape="cylinder" radius="0.5" height="6" position="9 0 0" fixed="true"/>
  <ice thickness="0.2"><floe outline="-3.6 -1 -0.6 -1 -0.6 1 -3.6 1" velocity="0.5 0 0"/></ice>
</scene>
)";

constexpr const char* k_sections[] = {"scene", "loads",  "spectra", "statistics", "place", "pressure",
                                      "ice",   "breaks", "energy",  "solver",     "time",  "gaps"};

/// The data of a page's script.
Json data_of(const std::string& page) {
  const std::string mark = "<script type=\"application/json\" id=\"report-data\">";
  const auto begin = page.find(mark) + mark.size();
  return Json::parse(page.substr(begin, page.find("</script>", begin) - begin));
}

class ReportPage : public ::testing::Test {
 protected:
  static void SetUpTestSuite() {
    shared().write("ship.xml", k_ship);
    ASSERT_EQ(run_nilas("run ship.xml --quiet --out ship", shared().path()).exit_code, 0);
  }
  ReportPage() { fs::copy(shared().path() / "ship", in("run"), fs::copy_options::recursive); }

  fs::path in(const std::string& file) const { return folder.path() / file; }
  ProgramResult report(const std::string& arguments) const { return run_nilas("report " + arguments, folder.path()); }
  /// The page of a run that must be written.
  std::string page_of(const std::string& run) const {
    const auto result = report(run);
    EXPECT_EQ(result.exit_code, 0) << result.err;
    const std::string page = read_text(in(run + "/report.html"));
    for (const char* section : k_sections)
      EXPECT_NE(page.find("<section id=\"" + std::string(section) + "\">"), std::string::npos) << section;
    EXPECT_EQ(page.find("@NILAS"), std::string::npos) << "a place that was not filled";
    EXPECT_FALSE(std::regex_search(page, std::regex("(src|href)=\"?(https?:)?//"))) << "names another machine";
    return page;
  }
  void expect_refusal(const std::string& arguments, int exit_code, const std::string& words) const {
    const auto result = report(arguments);
    EXPECT_EQ(result.exit_code, exit_code) << arguments << ": " << result.err;
    EXPECT_TRUE(mentions(result.err, words)) << arguments << ": " << result.err;
  }
  void cut(const std::string& file, std::size_t bytes) const {
    fs::resize_file(in(file), fs::file_size(in(file)) - bytes);
  }

  ScratchFolder folder;

 private:
  static ScratchFolder& shared() {
    static ScratchFolder scratch;
    return scratch;
  }
};

/// A force as pages write it, in N.
double newton(const std::string& text, const std::regex& pattern) {
  std::smatch found;
  if (!std::regex_search(text, found, pattern)) return std::nan("");
  return std::stod(found[1]) * (found[2] == "kN" ? 1e3 : 1);
}

TEST_F(ReportPage, BeginsWithTheLoadOfTheSummary) {
  const std::string page = page_of("run");
  const Json along = Json::parse(read_text(in("run/summary.json"))).at("ice_load").at("along");
  EXPECT_NEAR(newton(page, std::regex("pushed the vessel back with (\\S+) (k?N) on average")), along.at("mean_N"),
              5e-4 * along.at("mean_N").get<double>());
  EXPECT_NEAR(newton(page, std::regex("(?:known to within|uncertain by more than) (\\S+) (k?N)")),
              along.at("estimate_N"), 0.05 * along.at("estimate_N").get<double>());
  EXPECT_NEAR(newton(page, std::regex("largest load of one step was (\\S+) (k?N) astern")), along.at("raw_peak_N"),
              5e-4 * along.at("raw_peak_N").get<double>());
  EXPECT_TRUE(mentions(page, "at the bow")) << "where it acted";
  EXPECT_TRUE(mentions(page, "replay.html#t="));
  EXPECT_TRUE(mentions(page, "Nothing: every file"));
}

/// The script's data hold the loads of the table, and all of the impulse of contacts.h5.
TEST_F(ReportPage, ItsDataAreThoseOfTheRun) {
  const Json data = data_of(page_of("run"));
  const Table vessel(in("run/vessel.csv"));
  const nilas::hdf5::Hdf5Reader table(in("run/contacts.h5"));
  double impulse = 0, drawn = 0;
  const auto x = table.exact_numbers("contacts/impulse_x_Ns"), y = table.exact_numbers("contacts/impulse_y_Ns"),
             z = table.exact_numbers("contacts/impulse_z_Ns");
  for (std::size_t k = 0; k < x.size(); ++k) impulse += std::hypot(x[k], y[k], z[k]);
  for (const Json& cell : data.at("hull").at("cells")) drawn += cell.at(5).get<double>();
  ASSERT_GT(impulse, 0);
  EXPECT_NEAR(drawn, impulse, 1e-9 * impulse);
  std::map<std::string, Json> plots;
  for (const Json& plot : data.at("plots")) plots[plot.at("id")] = plot;
  const Json& load = plots.at("load-along").at("curves").at(0);
  ASSERT_EQ(load.at("y").size(), vessel.rows());
  for (std::size_t k = 0; k < vessel.rows(); ++k)
    EXPECT_NEAR(load.at("y").at(k), vessel["ice_resistance_N"][k], 1e-5 * std::abs(vessel["ice_resistance_N"][k]));
  for (const Json& share : plots.at("concentration").at("curves").at(0).at("y")) EXPECT_LE(share.get<double>(), 100.01);
  for (const char* id :
       {"load-across", "force-carriage", "exceedance", "energy", "residual", "iterations", "step-time"})
    EXPECT_TRUE(plots.contains(id)) << id;
}

TEST_F(ReportPage, AKilledRunIsReportedFromItsTables) {
  const std::vector<double> loads = Table(in("run/vessel.csv"))["ice_resistance_N"];
  fs::remove(in("run/summary.json"));
  cut("run/vessel.csv", 900);
  cut("run/steps.csv", 500);
  const std::string left = read_text(in("run/vessel.csv"));
  const auto rows = static_cast<std::size_t>(std::count(left.begin(), left.end(), '\n')) - 1;
  ASSERT_LT(rows, loads.size());
  const auto result = report("run");
  ASSERT_EQ(result.exit_code, 0) << result.err;
  EXPECT_TRUE(mentions(result.out, "There is no summary.json")) << result.out;
  EXPECT_TRUE(mentions(result.out, "chance alone")) << result.out;
  std::size_t first = 0;
  while (loads[first] == 0) ++first;
  double sum = 0;
  for (std::size_t k = first; k < rows; ++k) sum += loads[k];
  const double mean = sum / static_cast<double>(rows - first);
  EXPECT_NEAR(newton(result.out, std::regex("back\\s+with\\s+(\\S+)\\s+(k?N)\\s+on")), mean, 1e-3 * mean) << result.out;
}

TEST_F(ReportPage, WhatWasNotCopiedIsNamed) {
  for (const char* file : {"run/contacts.h5", "run/steps.csv", "run/trajectory.pvd"}) fs::remove(in(file));
  const std::string page = page_of("run");
  for (const char* said : {"contacts.h5", "The table steps.csv", "stored no motion of the ice"})
    EXPECT_TRUE(mentions(page, said)) << said;
  EXPECT_TRUE(data_of(page).at("hull").is_null());
  EXPECT_TRUE(mentions(page, "pushed the vessel back")) << "the load is still known";
  fs::remove(in("run/vessel.csv"));
  expect_refusal("run", 2, "no table of the folder holds a step");
}

/// A load whose halves differ must not seem well known, nor a run compared with itself agree.
TEST_F(ReportPage, ALoadThatIsNotSteadyIsSaidToBe) {
  Json summary = Json::parse(read_text(in("run/summary.json")));
  Json& halves = summary["ice_load"]["along"]["halves"];
  halves = Json{{"mean_N", {10, 30}}, {"estimate_N", {1, 2}}, {"differ", true}};
  folder.write("run/summary.json", summary.dump());
  std::string page = page_of("run");
  EXPECT_TRUE(mentions(page, "since it was not steady"));
  EXPECT_TRUE(mentions(page, "The load is not steady: its mean was"));
  EXPECT_TRUE(mentions(page, "across the course."));
  halves["mean_N"] = {10, 11};
  folder.write("run/summary.json", summary.dump());
  page = page_of("run");
  EXPECT_FALSE(mentions(page, "not steady"));
  expect_refusal("run run", 2, "is named twice");
}

TEST_F(ReportPage, FiguresThatDependOnTheStepAreNotToBeUsed) {
  Json summary = Json::parse(read_text(in("run/summary.json")));
  summary["ice_load"]["peaks"]["paired_steps"] = {
      {"p99_falls_by_1", 0.01}, {"filtered_peak_falls_by_1", 0.02}, {"raw_peak_falls_by_1", 0.4}, {"rigid", false}};
  folder.write("run/summary.json", summary.dump());
  const std::string page = page_of("run");
  EXPECT_TRUE(mentions(page, "the filtered peak and the 99th percentile of the steps. Do not use the raw peak (40 %"));
  summary["ice_load"]["peaks"].erase("paired_steps");
  folder.write("run/summary.json", summary.dump());
  EXPECT_FALSE(mentions(page_of("run"), "Do not use the raw peak")) << "a run of an earlier version";
}

/// Cut tables beside a whole summary, and a summary that lacks what single sections show.
TEST_F(ReportPage, ACutTableIsNamedAndASectionMayLackItsKeys) {
  EXPECT_TRUE(mentions(page_of("run"), "call: nilas view run.")) << "the path as it was given";
  cut("run/vessel.csv", fs::file_size(in("run/vessel.csv")) / 2);
  Json summary = Json::parse(read_text(in("run/summary.json")));
  summary["tow_force"] = Json{{"mean_N", nullptr}};
  summary["worst"] = 5;
  folder.write("run/summary.json", summary.dump());
  const std::string page = page_of("run");
  EXPECT_TRUE(mentions(page, "The table vessel.csv: It ends at "));
  EXPECT_TRUE(mentions(page, "The load of this run cannot be told"));
  EXPECT_FALSE(mentions(page, "Nothing: every file"));
}

TEST_F(ReportPage, AFolderOfAnotherVersionSaysWhatItCannotRead) {
  std::string scene = read_text(in("run/scene.xml"));
  scene.replace(scene.find("<water "), 7, "<water taste=\"salty\" ");
  folder.write("run/scene.xml", scene);
  Json summary = Json::parse(read_text(in("run/summary.json")));
  summary["ice_load"]["along"].erase("raw_peak_N");
  folder.write("run/summary.json", summary.dump());
  const std::string page = page_of("run");
  EXPECT_TRUE(mentions(page, "taste")) << "the scene has an attribute of another version";
  EXPECT_TRUE(mentions(page, "raw_peak_N")) << "the summary lacks a key";
  EXPECT_TRUE(mentions(page, "pushed the vessel back"));
  folder.write("run/summary.json", "{\"cut\": ");
  EXPECT_TRUE(mentions(page_of("run"), "summary.json is cut or damaged"));
  folder.write("run/contacts.h5", "no HDF5");
  folder.write("run/scene.xml", read_text(in("run/scene.xml")).substr(0, 200));
  page_of("run");
}

TEST_F(ReportPage, WhatIsNoRunIsRefused) {
  fs::create_directories(in("empty"));
  expect_refusal("nowhere", 4, "no such run folder");
  expect_refusal("empty", 2, "is no run folder");
  expect_refusal("run/scene.xml", 2, "is a file");
  expect_refusal("run --body bow", 2, "found 'bow'; allowed: ship");
  expect_refusal("run --out run/scene.xml", 4, "run/scene.xml");
  expect_refusal("run empty", 2, "is no run folder");
  expect_refusal("run run --contacts 0.5", 2, "--contacts draws one run");
  for (const char* table : {"run/vessel.csv", "run/steps.csv"}) {
    fs::remove(in(table));
    fs::create_directory(in(table));  // it can be opened, and not read
  }
  expect_refusal("run", 4, "vessel.csv: cannot be read");
}

TEST_F(ReportPage, FixedBodiesWithoutAVessel) {
  folder.write("piers.xml", k_pier);
  ASSERT_EQ(run_nilas("run piers.xml --quiet --out piers", folder.path()).exit_code, 0);
  const std::string page = page_of("piers");
  EXPECT_TRUE(mentions(page, "the ice pushed &#39;west&#39; along the drift with")) << "the body with the larger load";
  const Json hull = data_of(page).at("hull");
  EXPECT_NEAR(hull.at("outline"), 2 * 3.14159 * 0.5, 0.01);
  for (const Json& cell : hull.at("cells")) EXPECT_LT(std::abs(cell.at(0).get<double>()), 0.8) << "towards the ice";
  const auto east = report("piers --body east --out east");
  ASSERT_EQ(east.exit_code, 0) << east.err;
  EXPECT_TRUE(mentions(east.out, "No ice pressed on 'east'")) << east.out;
  EXPECT_TRUE(fs::exists(in("east/report.html")));
}

TEST_F(ReportPage, RunsWithoutIceAndWithoutLoads) {
  std::string open = k_ship;
  const auto ice = open.find("<ice "), end = open.find("</ice>") + 6;
  open.erase(ice, end - ice);
  folder.write("open.xml", open);
  folder.write("box.xml", k_box);
  ASSERT_EQ(run_nilas("run open.xml --quiet --out open", folder.path()).exit_code, 0);
  ASSERT_EQ(run_nilas("run box.xml --quiet --out box", folder.path()).exit_code, 0);
  const std::string page = page_of("open");
  EXPECT_TRUE(mentions(page, "No ice pressed on the vessel"));
  EXPECT_TRUE(mentions(page, "The carriage pulled with"));
  EXPECT_TRUE(mentions(page_of("box"), "it has no ice load"));
}

TEST_F(ReportPage, ComparesRunsAndNamesHowTheirScenesDiffer) {
  ASSERT_EQ(run_nilas("run run/scene.xml --quiet --out thick --set ice/@thickness=0.08", folder.path()).exit_code, 0);
  const auto result = report("run thick --json --out both");
  ASSERT_EQ(result.exit_code, 0) << result.err;
  const Json said = Json::parse(result.out);
  EXPECT_EQ(said.at("file"), "both/comparison.html");
  EXPECT_TRUE(mentions(said.at("headline").at(0), "The mean of thick is"));
  EXPECT_EQ(said.at("headline").at(1), "The scenes differ in ice/@thickness alone.");
  const std::string page = read_text(in("both/comparison.html"));
  EXPECT_TRUE(mentions(page, "ice/@thickness"));
  const Json plots = data_of(page).at("plots");
  EXPECT_EQ(plots.at(0).at("curves").size(), 2u);
  EXPECT_EQ(plots.at(0).at("curves").at(1).at("name"), "thick");
  EXPECT_FALSE(fs::exists(in("run/report.html")));
}

/// A mean is not compared with that of another scene as if one cause made the difference.
TEST_F(ReportPage, RunsOfUnlikeScenesAreDoubted) {
  ASSERT_EQ(
      run_nilas("run run/scene.xml --quiet --out two --set ice/@thickness=0.08 --seed 9", folder.path()).exit_code, 0);
  const std::string two = Json::parse(report("run two --json --out both").out).at("headline").dump();
  EXPECT_TRUE(mentions(two, "A difference of loads may come from any of these.")) << two;
  EXPECT_TRUE(mentions(two, "ice/@thickness")) << two;
  folder.write("piers.xml", k_pier);
  ASSERT_EQ(run_nilas("run piers.xml --quiet --out piers", folder.path()).exit_code, 0);
  const std::string unlike = Json::parse(report("run piers --json --out other").out).at("headline").dump();
  EXPECT_TRUE(mentions(unlike, "The scenes are unlike: they differ in ")) << unlike;
}

/// The floe that the first sentences name is marked on the plan and on the unrolled hull.
TEST_F(ReportPage, MarksTheFloeOfTheLargestLoad) {
  const std::string page = page_of("run");
  std::smatch found;
  ASSERT_TRUE(std::regex_search(page, found, std::regex("mostly by (floe \\d+)|, by (floe \\d+)")));
  const std::string name = found[1].matched ? found[1] : found[2];
  EXPECT_EQ(data_of(page).at("hull").at("peak").at("name"), name);
  EXPECT_TRUE(mentions(page, "<path class=\"culprit\" d=\"M"));
  EXPECT_TRUE(std::regex_search(page, std::regex("class=\"mark-name\"[^>]*>" + name + "<")));
}

/// A load of a step that was not solved must not be read as one that was.
TEST_F(ReportPage, SaysFirstWhereTheSolverEndedAboveItsTolerance) {
  EXPECT_EQ(report("run").out.find("above its tolerance"), std::string::npos);
  folder.write("ship.xml", k_ship);
  const auto run = run_nilas(
      "run ship.xml --quiet --out rough --set contact/@solver=nsgs --set contact/@tolerance=1e-30 "
      "--set contact/@max_iterations=1 --set contact/@on_failure=record",
      folder.path());
  ASSERT_EQ(run.exit_code, 0);
  for (const char* words : {"1e-30 m/s was asked for", "Do not use the loads of such a step", "then no solver helps"})
    EXPECT_TRUE(mentions(run.err, words)) << run.err;
  const auto result = report("rough");
  ASSERT_EQ(result.exit_code, 0) << result.err;
  const std::string told = std::regex_replace(result.out, std::regex("\\s+"), " ");
  EXPECT_TRUE(mentions(told, "that of the largest load among them, the solver ended above its tolerance")) << told;
}

TEST_F(ReportPage, SaysFirstThatTheRunWasInterruptedOrFailed) {
  EXPECT_FALSE(mentions(page_of("run"), "The run was interrupted"));
  Json summary = Json::parse(read_text(in("run/summary.json")));
  for (const auto& [status, words] :
       {std::pair{"interrupted", "The run was interrupted at "}, std::pair{"failed", "The run failed at "}}) {
    summary["status"] = status;
    folder.write("run/summary.json", summary.dump());
    EXPECT_TRUE(mentions(page_of("run"), words));
    EXPECT_TRUE(mentions(report("run").out, words));
  }
}

/// Nor must one whose load is wrong at a small residual.
TEST_F(ReportPage, SaysWhereSingleStepsAreNotToBeUsed) {
  Json summary = Json::parse(read_text(in("run/summary.json")));
  const auto told_with = [&](double p95) {
    summary["step_load_error"] = {{"every_steps", 100},  {"tolerance_m_s", 1e-8}, {"checked_steps", 9},
                                  {"unsolved_steps", 0}, {"mean_N", 50},          {"error_median_1", 0.01},
                                  {"error_p95_1", p95}};
    folder.write("run/summary.json", summary.dump());
    return std::regex_replace(report("run").out, std::regex("\\s+"), " ");
  };
  EXPECT_FALSE(mentions(told_with(0.02), "Do not use single steps"));
  EXPECT_TRUE(mentions(page_of("run"), "off by 1 % in the median and by 2 % in the 95th percentile"));
  const std::string told = told_with(0.6);
  EXPECT_TRUE(mentions(told, "by 60 % in the 95th percentile, of 50 N on average. Do not use single steps")) << told;
}

TEST_F(ReportPage, NamesCellsThatAreNoNumber) {
  EXPECT_FALSE(mentions(page_of("run"), "no finite number"));
  const std::string steps = read_text(in("run/steps.csv"));
  const std::string hash = Table(in("run/steps.csv")).text("state_hash").front();
  std::string digits = steps;
  digits.replace(digits.find(hash), hash.size(), std::string(hash.size(), '7'));
  folder.write("run/steps.csv", digits);
  EXPECT_FALSE(mentions(page_of("run"), "no finite number")) << "a hash of digits alone is no number either";
  folder.write("run/steps.csv", steps);
  std::string table = read_text(in("run/vessel.csv"));
  table.replace(table.rfind(',') + 1, table.size(), "what\n");
  const std::string column = table.substr(0, table.find('\n')).substr(table.substr(0, table.find('\n')).rfind(',') + 1);
  folder.write("run/vessel.csv", table);
  EXPECT_TRUE(mentions(page_of("run"), "1 cell is no finite number and left out of graphs, in " + column));
}

/// The first number of a row of a table, not a number where there is no such row.
double row_of(const std::string& page, const std::string& name) {
  std::smatch found;
  const bool is_there = std::regex_search(page, found, std::regex("<tr><th>" + name + "</th><td>([^<]+)</td>"));
  return is_there ? std::stod(found[1]) : std::nan("");
}

TEST_F(ReportPage, TheTimesOfPhasesAddUpToTheWallTime) {
  const std::string page = page_of("run");
  const Json summary = Json::parse(read_text(in("run/summary.json")));
  const double steps = summary.at("steps").get<double>(), wall = 1e3 * summary.at("wall_s").get<double>() / steps;
  EXPECT_NEAR(row_of(page, "all"), wall, 1e-3 * wall);
  EXPECT_GT(row_of(page, "other"), 0);
  EXPECT_LT(row_of(page, "other"), wall);
  EXPECT_TRUE(std::isnan(row_of(page, "resuming"))) << "the run was not resumed";
}

TEST_F(ReportPage, TellsTheTimeForResumingFromOtherTime) {
  const double before = row_of(page_of("run"), "other");
  Json summary = Json::parse(read_text(in("run/summary.json")));
  const double steps = summary.at("steps").get<double>();
  summary["wall_s"] = summary.at("wall_s").get<double>() + 0.5;
  summary["resuming_s"] = 0.5;
  folder.write("run/summary.json", summary.dump());
  const std::string page = page_of("run");
  EXPECT_NEAR(row_of(page, "resuming"), 500 / steps, 1e-3 * 500 / steps);
  EXPECT_NEAR(row_of(page, "other"), before, 1e-2 * before);
}

TEST_F(ReportPage, DrawsTheTensionsOfMooringLinesAndNamesTheLargest) {
  std::string moored = k_ship;
  const std::string carriage = "<carriage speed=\"0.5\" ramp=\"0.05\"/>";
  std::string lines = "<mooring depth=\"4\" start=\"as-placed\">";
  for (int k = 0; k < 10; ++k)
    lines += "<line name=\"m" + std::to_string(k) + "\" fairlead=\"1.5 0 0.3\" anchor=\"" +
             (k % 2 == 0 ? "13 " : "-10 ") + std::to_string(0.2 * k) + " -4\" length=\"" +
             (k % 2 == 0 ? "13" : "13.4") + "\" weight=\"3\" stiffness=\"2e4\" damping=\"10\"/>";
  moored.replace(moored.find(carriage), carriage.size(), lines + "</mooring>");
  folder.write("moored.xml", moored);
  const auto result = run_nilas("run moored.xml --quiet --out moored", folder.path());
  ASSERT_EQ(result.exit_code, 0) << result.err;
  const std::string page = page_of("moored");
  const Table steps(in("moored/steps.csv"));
  double largest = 0;
  std::string name;
  for (int k = 0; k < 10; ++k)
    for (const double tension : steps["line_m" + std::to_string(k) + "_tension_N"])
      if (tension > largest) {
        largest = tension;
        name = "m" + std::to_string(k);
      }
  std::smatch found;
  ASSERT_TRUE(
      std::regex_search(page, found, std::regex("largest tension of a mooring line was (\\S+) (k?N) in line (m\\d)")));
  EXPECT_NEAR(newton(page, std::regex("largest tension of a mooring line was (\\S+) (k?N)")), largest, 1e-3 * largest);
  EXPECT_EQ(found[3], name);
  const Json plots = data_of(page).at("plots");
  const auto plot =
      std::find_if(plots.begin(), plots.end(), [](const Json& p) { return p.at("id") == "mooring-tension"; });
  ASSERT_NE(plot, plots.end());
  const Json& curves = plot->at("curves");
  ASSERT_EQ(curves.size(), 10u) << "eight lines, the two others, and the largest";
  EXPECT_EQ(curves.at(0).at("name"), name);
  EXPECT_EQ(curves.at(8).at("name"), "mean and range of 2 others");
  EXPECT_EQ(curves.at(8).at("low").size(), curves.at(8).at("x").size());
  EXPECT_TRUE(mentions(curves.at(9).at("name"), "in " + name));
}

TEST_F(ReportPage, RunsOfDifferentScalesAreDoubted) {
  ASSERT_EQ(run_nilas("run run/scene.xml --quiet --scale 20 --out large", folder.path()).exit_code, 0);
  const auto both = report("run large --json --out both");
  ASSERT_EQ(both.exit_code, 0) << both.err;
  const std::string said = Json::parse(both.out).at("headline").dump();
  EXPECT_TRUE(mentions(said, "These runs are of different scales")) << said;
  EXPECT_TRUE(mentions(said, "which is 8000 times here")) << said;
  EXPECT_TRUE(mentions(said, "No error here covers other ice of the same kind")) << said;
}

TEST_F(ReportPage, WritesFiguresForPapers) {
  const auto result = report("run --figures --out paper");
  ASSERT_EQ(result.exit_code, 0) << result.err;
  for (const char* name : {"load-along", "exceedance", "load-by-place", "energy", "residual"}) {
    EXPECT_EQ(read_text(in("paper/figures/" + std::string(name) + ".pdf")).substr(0, 4), "%PDF") << name;
    EXPECT_TRUE(mentions(read_text(in("paper/figures/" + std::string(name) + ".svg")), "<svg")) << name;
  }
}

}  // namespace report_page_test
