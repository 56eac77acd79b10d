/// Relations between the values of a scene.
#include "core/scene/check/cross_checks.h"

#include <gtest/gtest.h>

#include "tests/core/scene/complete_scene.h"

namespace nilas::scene {
namespace cross_checks_test {

using testing::expect_fault;
using testing::in_scene;
using testing::SceneFolder;

struct CrossCase {
  std::string content, where, word;
};

void expect_each(const std::vector<CrossCase>& cases) {
  const SceneFolder folder;
  testing::write_inputs(folder);
  for (const auto& c : cases) {
    SCOPED_TRACE(c.content);
    expect_fault(folder.faults(in_scene(c.content)), 2, c.where, {c.word});
  }
}

TEST(CrossChecks, TimeAndGravity) {
  expect_each({{"<time start='5' end='5'/>", "<time end>", "after the start, > 5 [s]"},
               {"<time start='20'/>", "<time end>", "found 10"},
               {"<gravity value='0 1 -9'/><hydro><buoyancy/></hydro>", "<gravity value>", "along -Z"}});
}

TEST(CrossChecks, Vessel) {
  const std::string mass = "<mass value='1500'/>";
  expect_each(
      {{"<vessel>" + mass + "</vessel>", "<vessel>", "has no hull"},
       {"<vessel hull='hulls/icebreaker'>" + mass + "<hull/></vessel>", "<vessel><hull>", "one of them"},
       {"<vessel><hull/>" + mass + "<carriage/><fixed/></vessel>", "<vessel><fixed>", "one of them"},
       {"<vessel velocity='1 0 0'><hull/>" + mass + "<fixed/></vessel>", "<vessel velocity>", "free vessel"},
       {"<vessel angular_velocity='0 0 1'><hull/>" + mass + "<carriage/></vessel>", "<vessel angular_velocity>",
        "free vessel"},
       {"<vessel><hull/></vessel>", "<vessel>", "without <water>"},
       {"<vessel position='0 0'><hull/>" + mass + "</vessel>", "<vessel position>", "3 numbers"},
       {"<water/><vessel position='0 0'><hull/></vessel>", "<vessel position>", "from the mass"},
       {"<water/><vessel><hull/><mass value='1' draught='1'/></vessel>", "<vessel><mass draught>", "one of them"}});
}

TEST(CrossChecks, Inertia) {
  expect_each(
      {{"<body inertia='1 1 -1 0 0 0'/>", "<body inertia>", "positive definite"},
       {"<body inertia='1 1 1 2 0 0'/>", "<body inertia>", "positive definite"},
       {"<body inertia='1 1 2.1 0 0 0'/>", "<body inertia>", "sum of the other two"},
       {"<body inertia='3 3 3 2.9 0 0'/>", "<body inertia>", "sum of the other two"},
       {"<vessel><hull/><mass value='1' inertia='1 2 4 0 0 0'/></vessel>", "<vessel><mass inertia>", "sum of"}});
  const SceneFolder folder;
  EXPECT_TRUE(folder.faults(in_scene("<body inertia='0.1 0.2 0.3 0 0 0'/>")).empty()) << "a plate reaches the bound";
}

TEST(CrossChecks, Bodies) {
  expect_each({{"<body mass='1' density='2'/>", "<body density>", "one of them"},
               {"<body shape='mesh'/>", "<body mesh>", "missing"},
               {"<body shape='plane' fixed='false'/>", "<body fixed>", "always fixed"},
               {"<body fixed='true' velocity='1 0 0'/>", "<body velocity>", "does not move"},
               {"<body name='a'/><body name='a'/>", "<body name>", "taken by the element of line 2"},
               {"<body name='a'/><ice><floe name='a' outline='0 0 1 0 0 1'/></ice>", "<ice><floe name>", "unique"}});
}

TEST(CrossChecks, IceThatMovesLiesWithinTheTank) {
  const auto content = [](const std::string& region, const std::string& more = "") {
    return "<tank length='40' width='10' depth='2'/><ice><field region='" + region + "'" + more + "/></ice>";
  };
  const std::string allowed = "x from 0 to 40 and y from -5 to 5 [m]";
  for (const char* region : {"-0.1 -5 20 5", "0 -5.1 20 5", "0 -5 40.1 5", "0 -5 40 5.1", "50 6 60 8"})
    expect_each({{content(region), "<ice><field region>", allowed},
                 {content(region), "<ice><field region>", std::string("found ") + region}});
  const SceneFolder folder;
  EXPECT_TRUE(folder.faults(in_scene(content("0 -5 40 5"))).empty());
  EXPECT_TRUE(folder.faults(in_scene(content("-1 -6 41 6", " kind='level' fixed='true'"))).empty());
  EXPECT_TRUE(folder.faults(in_scene("<ice><field region='-1 -6 41 6'/></ice>")).empty()) << "there is no tank";
}

TEST(CrossChecks, Ice) {
  expect_each({{"<ice><field/></ice>", "<ice><field region>", "missing"},
               {"<ice><field region='1 0 0 1'/></ice>", "<ice><field region>", "x0 = 1, x1 = 0"},
               {"<ice><field region='0 1 1 1'/></ice>", "<ice><field region>", "y0 = 1, y1 = 1"},
               {"<ice><field kind='file'/></ice>", "<ice><field file>", "missing"},
               {"<ice><floe outline='0 0 1 0'/></ice>", "<ice><floe outline>", "at least 6"},
               {"<ice><floe outline='0 0 1 0 1 1 0'/></ice>", "<ice><floe outline>", "even number"},
               {"<ice><floe outline='0 0 1 0 1 1' fixed='true' velocity='1 0 0'/></ice>", "<ice><floe velocity>",
                "does not move"},
               {"<ice><field region='0 0 1 1'><size min='2'/></field></ice>", "<ice><field><size max>", ">= 2"},
               {"<ice><field region='0 0 1 1'><size mean='3'/></field></ice>", "<ice><field><size mean>", "<= 1.6"},
               {"<ice><field region='0 0 1 1'><size distribution='as-library'/></field></ice>",
                "<ice><field><size distribution>", "library"},
               {"<ice><field kind='channel' region='0 0 4 1' channel_width='1'/></ice>", "<ice><field channel_width>",
                "less than the region's width 1"},
               {"<ice><field region='0 0 1 1'><shape vertices='9 5'/></field></ice>", "<ice><field><shape vertices>",
                "fewest"}});
  const SceneFolder folder;
  EXPECT_TRUE(
      folder.faults(in_scene("<ice><field region='0 0 1 1'><size distribution='fixed' mean='3'/></field></ice>"))
          .empty());
}

TEST(CrossChecks, Friction) {
  const auto friction = [](const std::string& attributes) {
    return "<contact><friction " + attributes + "/></contact>";
  };
  expect_each({{friction("between='ice ice'"), "<contact><friction static>", "missing"},
               {friction("between='ice ice' static='0.1' kinetic='0.2'"), "<contact><friction static>", "not below"},
               {friction("between='ice hul' static='0.1'"), "<contact><friction between>", "nearest: hull"},
               {friction("between='ice' static='0.1'"), "<contact><friction between>", "2 words"},
               {friction("between='ice *' static='0.1' elastic='true' restitution='0.2'"),
                "<contact><friction restitution>", "damping_ratio"},
               {friction("between='hull wall' static='0.1' elastic='true'"), "<contact><friction stiffness>",
                "materials other than ice"},
               {"<contact><friction between='ice hull' static='0'/><friction between='hull ice' static='0'/></contact>",
                "<contact><friction between>", "already named in line 2"}});
}

TEST(CrossChecks, ContactsOfAllBodiesAreOfWholeSteps) {
  expect_each({{"<contact integrator='reference'/><output contacts='all'/>", "<output contacts>", "allowed: hull"}});
  const SceneFolder folder;
  EXPECT_TRUE(folder.faults(in_scene("<contact integrator='reference'/>")).empty());
  EXPECT_TRUE(folder.faults(in_scene("<output contacts='all'/>")).empty());
}

TEST(CrossChecks, FilesMustExist) {
  const SceneFolder folder;
  folder.write("empty/readme.txt", "");
  folder.write("hull.obj", "");
  const auto expect_missing = [&](const std::string& content, const std::string& where, const std::string& path) {
    SCOPED_TRACE(content);
    expect_fault(folder.faults(in_scene(content)), 2, where,
                 {(folder.path() / path).string() + ": there is no such file"});
  };
  const auto vessel = [](const std::string& hull, const std::string& content) {
    return "<vessel " + hull + "><mass value='1'/>" + content + "</vessel>";
  };
  expect_missing(vessel("hull='none'", ""), "<vessel hull>", "none");
  expect_missing(vessel("hull='sub/../none.stl'", ""), "<vessel hull>", "none.stl");
  expect_missing(vessel("hull='empty'", ""), "<vessel hull>", "empty/fluid.stl");
  expect_missing(vessel("", "<hull/><carriage><path file='p.csv'/></carriage>"), "<vessel><carriage><path file>",
                 "p.csv");
  expect_missing(vessel("", "<hull/><carriage><force_balance kind='six-cells' layout='c.csv'/></carriage>"),
                 "<vessel><carriage><force_balance layout>", "c.csv");
  expect_missing("<ice><field kind='file' file='f.json'/></ice>", "<ice><field file>", "f.json");
  expect_missing("<body shape='mesh' mesh='m.stl'/>", "<body mesh>", "m.stl");
  expect_fault(folder.faults(in_scene(vessel("hull='hull.obj'", ""))), 2, "<vessel hull>", {"ending in .stl"});
  expect_fault(folder.faults(in_scene("<ice><field kind='file' file='empty'/></ice>")), 2, "<ice><field file>",
               {"found a folder"});
}

TEST(CrossChecks, AKnownFaultDoesNotBringAnother) {
  const SceneFolder folder;
  EXPECT_EQ(folder.faults(in_scene("<time start='20' end='x'/>")).size(), 1u);
  EXPECT_EQ(folder.faults(in_scene("<vessel hul='x'><mass value='1'/></vessel>")).size(), 1u);
  EXPECT_EQ(folder.faults(in_scene("<ice><field regio='0 0 1 1'/></ice>")).size(), 1u);
  EXPECT_EQ(folder.faults(in_scene("<body shape='plane' fixed='no'/>")).size(), 1u);
}

/// Files of WAMIT have no dimensions, others have no length; a database is that of a vessel.
TEST(CrossChecks, Database) {
  const std::string vessel = "<vessel><hull/><mass value='1500'/><fixed/></vessel>";
  const auto with = [&](const std::string& attributes) {
    return "<hydro><database " + attributes + "/></hydro>" + vessel;
  };
  expect_each({{with("file='ship.1' density='1000' gravity='9.81'"), "<hydro><database>", "length is missing"},
               {with("file='ship.hst' length='1' gravity='9.81'"), "<hydro><database>", "density is missing"},
               {with("file='floes.json' length='1'"), "<hydro><database length>", "only WAMIT"},
               {"<hydro><database file='floes.json'/></hydro>", "<hydro><database>", "no vessel"}});
}

}  // namespace cross_checks_test
}  // namespace nilas::scene
