/// Reading and checks of <mooring>.
#include <gtest/gtest.h>

#include "tests/core/scene/scene_files.h"

namespace nilas::scene {
namespace check_mooring_test {

using testing::expect_fault;
using testing::in_scene;
using testing::SceneFolder;

const std::string k_line = "<line name='a' fairlead='1 0 0' anchor='9 0 -5' length='12' weight='3' stiffness='1e5'/>";

std::string vessel(const std::string& inside) { return "<vessel><hull/><mass value='1'/>" + inside + "</vessel>"; }
std::string moored(const std::string& attributes, const std::string& inside) {
  return vessel("\n<mooring " + attributes + ">\n" + inside + "\n</mooring>\n");
}

TEST(Mooring, IsRead) {
  const SceneFolder folder;
  folder.write("spring.csv", "stretch_m,tension_N\n0,0\n1,5\n");
  const Scene scene = folder.read(in_scene(moored(
      "depth='5' start='as-placed'",
      "<line name='a' fairlead='1 2 3' anchor='9 0 -5' length='12' weight='-3' stiffness='1e5' bed_friction='0.4' "
      "damping='7' break_load='100' break_time='8' turret='true'/>"
      "<spring_line name='b' fairlead='1 0 0' anchor='9 0 0' length='7' stiffness='10' knee='2' second_stiffness='30'/>"
      "<spring_line name='c' fairlead='1 0 0' anchor='9 0 0' length='7' table='spring.csv'/>"
      "<turret at='1 2 0' friction='6'/>")));
  const MooringScene& mooring = scene.vessel->mooring.value();
  EXPECT_EQ(mooring.model, MooringKind::quasi_static);
  EXPECT_EQ(mooring.start, MooringStart::as_placed);
  EXPECT_EQ(mooring.depth, 5);
  ASSERT_EQ(mooring.lines.size(), 1u);
  const CatenaryScene& line = mooring.lines[0];
  EXPECT_EQ(line.name, "a");
  EXPECT_EQ(line.fairlead, Vec3(1, 2, 3));
  EXPECT_EQ(line.anchor, Vec3(9, 0, -5));
  EXPECT_EQ(line.length, 12);
  EXPECT_EQ(line.weight, -3);
  EXPECT_EQ(line.stiffness, 1e5);
  EXPECT_EQ(line.bed_friction, 0.4);
  EXPECT_EQ(line.damping, 7);
  EXPECT_EQ(line.break_load, 100);
  EXPECT_EQ(line.break_time, 8);
  EXPECT_TRUE(line.turret);
  ASSERT_EQ(mooring.springs.size(), 2u);
  EXPECT_EQ(mooring.springs[0].stiffness, 10);
  EXPECT_EQ(mooring.springs[0].knee, 2);
  EXPECT_EQ(mooring.springs[0].second_stiffness, 30);
  EXPECT_TRUE(mooring.springs[1].table.ends_with("spring.csv"));
  EXPECT_EQ(mooring.turret->at, Vec3(1, 2, 0));
  EXPECT_EQ(mooring.turret->friction, 6);
}

/// The defaults of the schema are those of the struct.
TEST(Mooring, HasTheDefaultsOfItsStruct) {
  const SceneFolder folder;
  const MooringScene mooring = *folder.read(in_scene(moored("", k_line))).vessel->mooring;
  MooringScene plain;
  plain.lines.emplace_back();
  plain.lines[0].name = "a";
  plain.lines[0].fairlead = {1, 0, 0};
  plain.lines[0].anchor = {9, 0, -5};
  plain.lines[0].length = 12;
  plain.lines[0].weight = 3;
  plain.lines[0].stiffness = 1e5;
  plain.lines[0].line = mooring.lines[0].line;
  EXPECT_EQ(mooring, plain);
}

/// The scene as run says the same.
TEST(Mooring, IsKeptInTheSceneAsRun) {
  const SceneFolder folder;
  const Scene scene = folder.read(in_scene(moored("depth='5'", k_line)));
  MooringScene again = *folder.read(scene.as_run).vessel->mooring;
  again.lines[0].line = scene.vessel->mooring->lines[0].line;
  EXPECT_EQ(again, *scene.vessel->mooring);
}

TEST(Mooring, IsReadFromItsOwnFile) {
  const SceneFolder folder;
  folder.write("lines/spring.csv", "stretch_m,tension_N\n0,0\n1,5\n");
  folder.write("lines/mooring.xml", "<mooring depth='5' start='as-placed'>" + k_line +
                                        "<spring_line name='c' fairlead='1 0 0' anchor='9 0 0' length='7' "
                                        "table='spring.csv'/></mooring>");
  const Scene scene = folder.read(in_scene(vessel("<mooring file='lines/mooring.xml' depth='6'/>")));
  const MooringScene& mooring = scene.vessel->mooring.value();
  EXPECT_EQ(mooring.depth, 6);  // what the scene gives goes first
  EXPECT_EQ(mooring.start, MooringStart::as_placed);
  EXPECT_EQ(mooring.lines.size(), 1u);
  ASSERT_EQ(mooring.springs.size(), 1u);
  EXPECT_TRUE(mooring.springs[0].table.ends_with("lines/spring.csv")) << mooring.springs[0].table;
  folder.write("lines/mooring.xml", "<mooring>\n<line name='a'/></mooring>");
  const auto faults = folder.faults(in_scene(vessel("<mooring file='lines/mooring.xml'/>")));
  ASSERT_FALSE(faults.empty());
  EXPECT_EQ(faults[0].line, 2);
  EXPECT_TRUE(faults[0].file.ends_with("lines/mooring.xml")) << faults[0].file;
  folder.write("lines/mooring.xml", "<scene/>");
  expect_fault(folder.faults(in_scene(vessel("<mooring file='lines/mooring.xml'/>"))), 1, "<scene>",
               {"found <scene> as the root", "allowed: <mooring>"});
  expect_fault(folder.faults(in_scene(vessel("<mooring file='no.xml'>" + k_line + "</mooring>"))), 2,
               "<vessel><mooring file>", {"no.xml"});
}

TEST(Mooring, WrongOnesAreRefusedWithTheirPlace) {
  const SceneFolder folder;
  folder.write("spring.csv", "");
  const std::string spring = "<spring_line name='b' fairlead='1 0 0' anchor='9 0 0' length='7' ";
  struct Wrong {
    std::string content;
    int line;
    std::string where;
    std::vector<std::string> words;
  };
  const std::string on_turret =
      "<line name='t' fairlead='1 0 0' anchor='9 0 0' length='12' weight='3' stiffness='1e5' "
      "turret='true'/>";
  const std::vector<Wrong> cases{
      {vessel("\n<fixed/><mooring>" + k_line + "</mooring>"), 3, "<vessel><mooring>", {"<fixed>", "a free vessel"}},
      {vessel("\n<carriage/><mooring>" + k_line + "</mooring>"), 3, "<vessel><mooring>", {"<carriage>"}},
      {moored("", ""), 3, "<vessel><mooring>", {"found no line"}},
      {moored("", k_line + "\n" + k_line), 5, "<vessel><mooring><line name>", {"'a' is taken", "line 4"}},
      {moored("depth='4'", k_line), 4, "<vessel><mooring><line anchor>", {"-5 m", "-4 m", "on the bed or above"}},
      {moored("", on_turret), 4, "<vessel><mooring><line turret>", {"without <turret>"}},
      {moored("", k_line + "<turret at='0 0 0'/>"), 4, "<vessel><mooring><turret>", {"no line is on the turret"}},
      {moored("", spring + "/>"), 4, "<vessel><mooring><spring_line>", {"neither stiffness nor table"}},
      {moored("", spring + "stiffness='1' table='spring.csv'/>"),
       4,
       "<vessel><mooring><spring_line table>",
       {"a stiffness and a table"}},
      {moored("", spring + "stiffness='1' knee='1'/>"), 4, "<vessel><mooring><spring_line knee>", {"belong together"}},
      {moored("", "<line name='a' fairlead='1 0 0' anchor='9 0 0' length='12' weight='0' stiffness='1'/>"),
       4,
       "<vessel><mooring><line weight>",
       {"found 0", "<spring_line>"}},
      {moored("model='moordyn'", ""), 3, "<vessel><mooring>", {"has no file"}},
      {moored("model='moordyn' file='spring.csv'", k_line),
       4,
       "<vessel><mooring><line>",
       {"from its file", "no <line>"}},
      {moored("", k_line) + "<contact integrator='reference'/>", 3, "<vessel><mooring>", {"'reference'", "moreau"}},
  };
  for (const Wrong& wrong : cases) {
    SCOPED_TRACE(wrong.content);
    expect_fault(folder.faults(in_scene(wrong.content)), wrong.line, wrong.where, wrong.words);
  }
}

/// Without a depth the floor of the tank is the bed.
TEST(Mooring, TakesTheFloorOfATankForItsBed) {
  const SceneFolder folder;
  const std::string tank = "<tank length='30' width='20' depth='4' floor='";
  EXPECT_TRUE(folder.faults(in_scene(moored("", k_line) + tank + "false'/>")).empty());
  expect_fault(folder.faults(in_scene(moored("", k_line) + tank + "true'/>")), 4, "<vessel><mooring><line anchor>",
               {"-4 m"});
}

}  // namespace check_mooring_test
}  // namespace nilas::scene
