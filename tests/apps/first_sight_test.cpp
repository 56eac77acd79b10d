/// Tests of run and check with inputs that once gave plausible but wrong results.
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "tests/support/mentions.h"
#include "tests/support/program.h"

namespace first_sight_test {

using namespace nilas_test;
using Json = nlohmann::json;

/// One line with single blanks, so that wrapped sentences can be searched.
std::string unwrapped(const std::string& text) {
  std::istringstream in(text);
  std::string all;
  for (std::string word; in >> word;) all += (all.empty() ? "" : " ") + word;
  return all;
}

const std::string k_towing = shipped_scene("towing.xml").string() + " ";

TEST(FirstSight, ATowThatMeetsLittleIceTellsTheIceLoadAndNotTheRampsInertia) {
  const ScratchFolder folder;
  const auto result =
      run_nilas("run " + k_towing + "--until 4 --set ice/field/@concentration=0.05 --out run", folder.path());
  ASSERT_EQ(result.exit_code, 0) << result.err;
  const Json summary = Json::parse(read_text(folder / "run/summary.json"));
  EXPECT_LT(std::abs(summary["load_error"]["mean_N"].get<double>()), 30) << "it had said 82.3 N +- 0.039 N";
  EXPECT_TRUE(mentions(result.out, "\nice load ")) << result.out;
  EXPECT_TRUE(mentions(result.out, "inertia")) << result.out;
  EXPECT_FALSE(mentions(result.out, "tow force x")) << result.out;
}

TEST(FirstSight, ATowIntoTheTanksWallEndsThereAndIsForetold) {
  const ScratchFolder folder;
  const std::string scene = k_towing + "--until 14 --set vessel/carriage/@speed=2 --set ice/field/@concentration=0.05";
  const auto check = run_nilas("check " + scene, folder.path());
  ASSERT_EQ(check.exit_code, 0) << check.err;
  EXPECT_TRUE(mentions(unwrapped(check.out), "the hull reaches the tank's end wall (x = 27 m) at 11.25 s"))
      << check.out;
  const auto result =
      run_nilas("run " + scene + " --out run --json --set contact/@solver=nsgs --dt 0.02", folder.path());
  ASSERT_EQ(result.exit_code, 0) << result.err;
  const Json summary = Json::parse(result.out);
  EXPECT_EQ(summary["status"], "done");
  EXPECT_EQ(summary["ended_early"], "the carriage would drive the hull into the tank's end wall (x = 27 m)");
  EXPECT_NEAR(summary["time_end_s"], 11.24, 0.03);
  EXPECT_TRUE(mentions(result.err, "the run ends at")) << result.err;
  const Table vessel(folder / "run/vessel.csv");
  for (const double pitch : vessel["pitch_deg"]) EXPECT_LT(std::abs(pitch), 2);
  EXPECT_LT(summary["loads"]["contact_fx_N"]["max"], 1e5) << "it had been 9.9e6 N";
}

TEST(FirstSight, WhatCanHardlyBeMeantIsWarnedOfWithItsPlace) {
  const ScratchFolder folder;
  const auto check = [&](const std::string& changes) {
    return unwrapped(run_nilas("check " + k_towing + changes, folder.path()).out);
  };
  EXPECT_TRUE(mentions(check("--set ice/@density=1100"), "<ice density>: ice of 1100 kg/m^3 sinks in water of 1005"));
  EXPECT_TRUE(mentions(check("--set contact/friction[1]/@static=30 --set contact/friction[1]/@kinetic=30"),
                       "<contact><friction static>: found 30; measured coefficients of ice are below 1"));
  folder.write("empty.xml", "<scene version=\"1\"/>\n");
  EXPECT_TRUE(mentions(run_nilas("check empty.xml", folder.path()).out, "the scene has no bodies"));
  folder.write("dry.xml", "<scene version=\"1\"><water/>\n<ice><floe outline=\"0 0 1 0 1 1\"/></ice></scene>\n");
  const std::string dry = unwrapped(run_nilas("check dry.xml", folder.path()).out);
  EXPECT_TRUE(mentions(dry, "dry.xml:1:")) << dry;
  EXPECT_TRUE(mentions(dry, "the scene has water but no <hydro>")) << dry;
  const Json json = Json::parse(run_nilas("check dry.xml --json", folder.path()).out);
  EXPECT_EQ(json["warnings"].size(), 2u) << json["warnings"];
}

TEST(FirstSight, APathThatEndsBeforeTheRunEndsIt) {
  const ScratchFolder folder;
  folder.write("path.csv", "t_s,x_m,y_m,yaw_deg\n0,0,0,0\n0.5,0.05,0,0\n1,0.2,0,0\n1.5,0.4,0,0\n");
  folder.write("path.xml", R"(<scene version="1"><time step="0.02" end="3"/><water/><hydro><buoyancy/><drag/></hydro>
<vessel position="0 0"><hull length="3"/><mass draught="0.15"/>
<carriage free="heave"><path file="path.csv"/></carriage></vessel></scene>
)");
  const auto result = run_nilas("run path.xml --out run --json", folder.path());
  ASSERT_EQ(result.exit_code, 0) << result.err;
  const Json summary = Json::parse(result.out);
  EXPECT_NEAR(summary["time_end_s"], 1.5, 1e-9);
  EXPECT_EQ(summary["ended_early"], "the carriage's path ends at 1.5 s");
  EXPECT_TRUE(mentions(result.err, "the path ends at 1.5 s; the run ends there, before its end at 3 s")) << result.err;
}

TEST(FirstSight, CrushedIceThatStandsInTheHullIsTold) {
  const ScratchFolder folder;
  const auto result =
      run_nilas("run " + shipped_scene("level-ice.xml").string() +
                    " --until 4.6 --out run --solver nsgs --set contact/@tolerance=1e-3 contact/@max_iterations=200",
                folder.path());
  ASSERT_EQ(result.exit_code, 0) << result.err;
  EXPECT_TRUE(mentions(result.out, "m of rigid contacts at")) << result.out;
  EXPECT_TRUE(mentions(result.out, "crushed ice, at most")) << result.out;
  const Json summary = Json::parse(read_text(folder / "run/summary.json"));
  EXPECT_GT(summary["worst"]["crushed_overlap_max_m"]["value"], 1e-3) << "beside a penetration of 0";
  EXPECT_TRUE(mentions(result.out, "solver at least")) << "many steps miss the tolerance\n" << result.out;
}

TEST(FirstSight, CheckTellsPeriodsAndTheDefaultsOfTheScale) {
  const ScratchFolder folder;
  folder.write("ship.xml", R"(<scene version="1"><time end="60"/><water/><hydro><buoyancy/><drag/></hydro>
<vessel position="0 0"><hull length="100" beam="20" draught="6"/><mass draught="6"/>
<carriage speed="1.5" ramp="8" free="heave"><force_balance kind="six-cells"/></carriage></vessel>
<ice><field region="110 -20 200 20"/></ice></scene>
)");
  const std::string text = unwrapped(run_nilas("check ship.xml", folder.path()).out);
  EXPECT_TRUE(mentions(text, "<time step>: 0.05 s is taken")) << text;
  EXPECT_TRUE(mentions(
      text,
      "<ice preset>: 'full-scale sea ice' is taken, since the hull is 100 m long: thickness 1 m, mean floe size 20 m"))
      << text;
  EXPECT_TRUE(mentions(text, "natural periods, without added mass:")) << text;
  EXPECT_TRUE(mentions(text, "held by the load cells")) << text;
  EXPECT_FALSE(mentions(text, "warning")) << text;
  const std::string soft =
      unwrapped(run_nilas("check ship.xml --set vessel/carriage/force_balance/@stiffness=1e7", folder.path()).out);
  EXPECT_TRUE(mentions(soft, "sets the vessel swinging on its load cells in surge")) << soft;
  const Json json = Json::parse(run_nilas("check ship.xml --json", folder.path()).out);
  EXPECT_GE(json["natural_periods"].size(), 4u);
}

}  // namespace first_sight_test
