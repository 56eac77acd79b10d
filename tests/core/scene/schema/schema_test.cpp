/// The table is consistent with itself, and its products work.
#include "core/scene/schema/schema.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <set>

#include "core/scene/spec/values.h"
#include "tests/core/scene/complete_scene.h"

namespace nilas::scene {
namespace schema_test {

using testing::in_scene;
using testing::SceneFolder;

TEST(Schema, ElementNamesAreUniqueAndParentsComeFirst) {
  std::set<std::string> seen;
  for (const auto& element : scene_schema()) {
    EXPECT_TRUE(element.parent.empty() ? seen.empty() : seen.count(element.parent) == 1) << element.name;
    EXPECT_TRUE(seen.insert(element.name).second) << element.name;
    EXPECT_FALSE(element.doc.empty()) << element.name;
  }
}

TEST(Schema, AttributesAreComplete) {
  for (const auto& element : scene_schema()) {
    std::set<std::string> seen;
    for (const auto& a : element.attributes) {
      SCOPED_TRACE(element.name + "/@" + a.name);
      EXPECT_TRUE(seen.insert(a.name).second);
      EXPECT_FALSE(a.doc.empty());
      EXPECT_FALSE(a.required && !a.default_value.empty());
      EXPECT_TRUE(a.type != ValueType::choice || !a.choices.empty());
      for (const auto& choice : a.not_built) EXPECT_EQ(std::count(a.choices.begin(), a.choices.end(), choice), 1);
      if (a.default_value.empty()) continue;
      EXPECT_EQ(value_problem(a, a.default_value), std::nullopt);
      EXPECT_FALSE(is_not_built(a, a.default_value) && element.built);
    }
  }
}

TEST(Schema, ConditionsNameAttributesAndValuesThatExist) {
  const auto expect_known = [](const ElementSpec& element, const Condition& condition) {
    if (condition.values.empty()) return;
    const AttributeSpec* decides = find_attribute(element, condition.attribute);
    ASSERT_NE(decides, nullptr) << element.name << "/@" << condition.attribute;
    for (const auto& value : condition.values) EXPECT_EQ(value_problem(*decides, value), std::nullopt) << value;
  };
  for (const auto& element : scene_schema()) {
    if (!element.parent.empty()) expect_known(*find_element(element.parent), element.applies);
    for (const auto& a : element.attributes) expect_known(element, a.applies);
  }
}

/// The defaults that the table prints are those of the reader: values and places of a whole element, member by member.
/// A member whose default is a separate number in the table fails here.
TEST(Schema, DefaultsAreThoseOfTheStructs) {
  const SceneFolder folder;
  const Scene scene =
      folder.read(in_scene("<contact><friction between='ice ice' static='0'/></contact><water><current/></water>"
                           "<hydro><drag/><virtual_drag/></hydro><tank length='10' width='5' depth='2'/>"));
  const Scene plain;
  EXPECT_EQ(scene.time, plain.time);
  EXPECT_EQ(scene.gravity, plain.gravity);
  EXPECT_EQ(scene.seed, plain.seed);
  EXPECT_EQ(scene.twin, plain.twin);
  EXPECT_EQ(scene.output, plain.output);
  ContactScene contact = scene.contact;
  contact.friction.at(0).material_a = contact.friction.at(0).material_b = FrictionScene{}.material_a;
  EXPECT_EQ(contact.friction.at(0), FrictionScene{});
  contact.friction.clear();
  EXPECT_EQ(contact, plain.contact);
  EXPECT_EQ(scene.water->current, CurrentScene{});
  EXPECT_EQ(scene.water->density, WaterScene{}.density);
  EXPECT_EQ(scene.water->level, WaterScene{}.level);
  EXPECT_EQ(scene.hydro->drag, DragScene{});
  EXPECT_EQ(scene.hydro->virtual_drag, VirtualDragScene{});
  EXPECT_EQ(scene.tank, TankScene{});
}

TEST(Schema, DefaultsOfIceAreThoseOfTheStructs) {
  const SceneFolder folder;
  const Scene scene =
      folder.read(in_scene("<ice><field region='0 0 1 1'/><floe outline='0 0 1 0 1 1'/><vary property='thickness'/>"
                           "</ice><hydro><buoyancy/></hydro>"
                           "<fracture><crushing/><bending/><splitting/><cracks/><damage/></fracture>"));
  EXPECT_EQ(scene.ice->density, IceScene{}.density);
  EXPECT_EQ(scene.ice->youngs_modulus, IceScene{}.youngs_modulus);
  EXPECT_EQ(scene.ice->poisson, IceScene{}.poisson);
  EXPECT_EQ(scene.ice->thickness, IceScene{}.thickness);
  EXPECT_EQ(scene.ice->fields.at(0), FieldScene{});
  FloeScene floe = scene.ice->floes.at(0);
  floe.outline.clear();
  floe.line = 0;
  EXPECT_EQ(floe, FloeScene{});
  VaryScene vary = scene.ice->vary.at(0);
  vary.line = 0;
  EXPECT_EQ(vary, VaryScene{});
  FractureScene fracture = *scene.fracture;
  EXPECT_EQ(fracture.crushing, CrushingScene{});
  EXPECT_EQ(fracture.bending, BendingScene{});
  EXPECT_EQ(fracture.splitting, SplittingScene{});
  EXPECT_EQ(fracture.cracks, CracksScene{});
  EXPECT_EQ(fracture.damage, DamageScene{});
  fracture.crushing.reset(), fracture.bending.reset(), fracture.splitting.reset(), fracture.cracks.reset();
  fracture.damage.reset();
  EXPECT_EQ(fracture, FractureScene{});
}

TEST(Schema, DefaultsOfBodiesAreThoseOfTheStructs) {
  const SceneFolder folder;
  const Scene scene = folder.read(in_scene(
      "<body/><vessel><hull/><mass value='1'/><carriage/><part name='a' joint='hinge' density='1000'/></vessel>"));
  BodyScene body = scene.bodies.at(0);
  EXPECT_EQ(body.density, SolidScene::k_density);
  body.density.reset();
  body.name.clear();
  body.line = 0;
  EXPECT_EQ(body, BodyScene{});
  PartScene part = scene.vessel->parts.at(0);
  part.density.reset();
  part.name.clear();
  part.line = 0;
  EXPECT_EQ(part, PartScene{});
  EXPECT_EQ(scene.vessel->carriage, CarriageScene{});
  EXPECT_EQ(scene.vessel->generate, HullGenerateScene{});
  VesselScene vessel = *scene.vessel;
  vessel.parts.clear();
  vessel.carriage.reset(), vessel.generate.reset(), vessel.mass.value.reset();
  EXPECT_EQ(vessel, VesselScene{});
}

TEST(Schema, EveryOldNameOfAChoiceLeadsToOneOfToday) {
  std::size_t names = 0;
  for (const auto& element : scene_schema())
    for (const auto& attribute : element.attributes)
      for (const auto& [old_name, name] : attribute.old_names) {
        ++names;
        EXPECT_EQ(std::count(attribute.choices.begin(), attribute.choices.end(), name), 1) << name;
        EXPECT_EQ(std::count(attribute.choices.begin(), attribute.choices.end(), old_name), 0) << old_name;
      }
  EXPECT_EQ(names, 3u);
}

/// Exit status of xmllint on a scene and the XSD.
int validate(const SceneFolder& folder, const std::string& scene) {
  const auto xsd = folder.write("scene.xsd", schema_xsd());
  const auto file = folder.write("validated.xml", scene);
  const std::string command = "xmllint --noout --schema '" + xsd.string() + "' '" + file.string() + "' >'" +
                              (folder.path() / "xmllint.txt").string() + "' 2>&1";
  return std::system(command.c_str());
}

std::string verdict(const SceneFolder& folder) {
  std::ifstream in(folder.path() / "xmllint.txt");
  return {std::istreambuf_iterator<char>(in), {}};
}

TEST(Xsd, AcceptsGoodScenes) {
  const SceneFolder folder;
  testing::write_inputs(folder);
  EXPECT_EQ(validate(folder, testing::k_complete_scene), 0) << verdict(folder);
  EXPECT_EQ(validate(folder, folder.read(testing::k_complete_scene).as_run), 0) << verdict(folder);
  EXPECT_EQ(validate(folder, folder.read("<scene version='1'/>").as_run), 0) << verdict(folder);
  EXPECT_EQ(validate(folder, in_scene("<contact law='pyramid-8' integrator='moreau'/>")), 0) << verdict(folder);
}

TEST(Xsd, RejectsBadScenes) {
  const SceneFolder folder;
  for (const char* content :
       {"<bodie/>", "<contact tolerence='1'/>", "<time step='0'/>", "<time step='nan'/>", "<time step='INF'/>",
        "<time step='1 s'/>", "<gravity value='0 0'/>", "<gravity value='0 0 0 0'/>", "<contact law='coulom'/>",
        "<contact max_iterations='1.5'/>", "<contact gyroscopic='yes'/>", "<tank length='1'/>", "<ice poisson='0.6'/>",
        "<ice><floe outline='0 0 1 0'/></ice>", "<hydro><drag/><drag/></hydro>", "<body name='a,b'/>",
        "<vessel><carriage free='heave yow'/></vessel>", "<time>text</time>", "<input file='x'/>"})
    EXPECT_NE(validate(folder, in_scene(content)), 0) << content;
  EXPECT_NE(validate(folder, "<scene version='2'/>"), 0);
  EXPECT_NE(validate(folder, "<scene/>"), 0);
}

TEST(Markdown, NamesEverything) {
  const std::string page = schema_markdown();
  for (const auto& element : scene_schema()) {
    EXPECT_NE(page.find("## `<" + element.name + ">`"), std::string::npos) << element.name;
    for (const auto& a : element.attributes)
      EXPECT_NE(page.find("| `" + a.name + "` |"), std::string::npos) << element.name << "/@" << a.name;
  }
  EXPECT_NE(page.find("| `end` | a finite number [s] | `10` |"), std::string::npos) << page;
}

/// Every row of a table has as many cells as its head.
TEST(Markdown, TablesAreRectangular) {
  std::istringstream page(schema_markdown());
  for (std::string line; std::getline(page, line);) {
    if (line.rfind("| ", 0) != 0) continue;
    std::size_t bars = 0;
    for (std::size_t i = 0; i < line.size(); ++i) bars += line[i] == '|' && (i == 0 || line[i - 1] != '\\') ? 1 : 0;
    EXPECT_EQ(bars, 5u) << line;
  }
}

}  // namespace schema_test
}  // namespace nilas::scene
