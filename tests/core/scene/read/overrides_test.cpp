/// --set PATH=VALUE.
#include "core/scene/read/overrides.h"

#include <gtest/gtest.h>

#include "tests/core/scene/scene_files.h"

namespace nilas::scene {
namespace overrides_test {

using testing::expect_fault;
using testing::SceneFolder;

constexpr const char* k_scene = R"(<scene version="1">
  <contact tolerance="1e-6"/>
  <ice>
    <field region="0 0 1 1"/>
    <field region="0 1 1 2" thickness="0.1"/>
  </ice>
  <body name="box" mass="1"/>
  <body name="a]=c" mass="1"/>
</scene>)";

class Overriding : public ::testing::Test {
 protected:
  Scene read(const std::string& path, const std::string& value) { return folder_.read(k_scene, {{path, value}}); }
  void expect_refused(const std::string& path, const std::string& value, const std::string& where,
                      const std::vector<std::string>& words) {
    SCOPED_TRACE(path);
    const auto faults = folder_.faults(k_scene, {{path, value}});
    expect_fault(faults, 0, where, words);
    for (const auto& fault : faults) EXPECT_EQ(fault.file, "--set");
  }
  SceneFolder folder_;
};

TEST_F(Overriding, AttributesThatAreThereAndThatAreNot) {
  EXPECT_EQ(read("contact/@tolerance", "1e-8").contact.tolerance, 1e-8);
  EXPECT_EQ(read("contact/@max_iterations", "5").contact.max_iterations, 5);
  EXPECT_EQ(read("scene/contact/@tolerance", "1e-8").contact.tolerance, 1e-8);
  EXPECT_EQ(read("/scene/contact/@tolerance", "1e-8").contact.tolerance, 1e-8);
  EXPECT_EQ(read("@name", "renamed").name, "renamed");
  EXPECT_EQ(read("/scene/@name", "renamed").name, "renamed");
}

TEST_F(Overriding, ElementsByNumberAndByAttribute) {
  EXPECT_EQ(read("ice/field[2]/@thickness", "0.05").ice->fields[1].thickness, 0.05);
  EXPECT_FALSE(read("ice/field[2]/@thickness", "0.05").ice->fields[0].thickness);
  EXPECT_EQ(read("body[@name='box']/@mass", "2").bodies[0].mass, 2);
  EXPECT_EQ(read("body[@name=\"box\"]/@mass", "2").bodies[0].mass, 2);
  EXPECT_EQ(read("body[@name='a]=c']/@mass", "2").bodies[1].mass, 2);
}

TEST_F(Overriding, MissingOptionalElementsAreMade) {
  EXPECT_EQ(read("output/@folder", "runs/x").output.folder, "runs/x");
  EXPECT_EQ(read("time/@end", "3").time.end, 3);
  const Scene scene = read("ice/field[1]/size/@mean", "1");
  EXPECT_EQ(std::get<LognormalSizeScene>(*scene.ice->fields[0].size()).mean, 1);
}

TEST_F(Overriding, TheLastOfSeveralWins) {
  const Scene scene = folder_.read(k_scene, {{"time/@end", "3"}, {"time/@step", "0.5"}, {"time/@end", "4"}});
  EXPECT_EQ(scene.time.end, 4);
  EXPECT_EQ(scene.time.step, 0.5);
}

TEST_F(Overriding, APlusIsOneMoreAndTheSameForAllPaths) {
  const Scene scene = folder_.read(k_scene, {{"ice/vary[+]/@property", "thickness"}, {"ice/vary[+]/@cov", "0.1"}});
  ASSERT_EQ(scene.ice->vary.size(), 1u);
  EXPECT_EQ(name_of(scene.ice->vary[0].property), "thickness");
  EXPECT_EQ(scene.ice->vary[0].cov, 0.1);
  const Scene floes = folder_.read(k_scene, {{"ice/field[+]/@kind", "level"}, {"ice/field[+]/@region", "50 0 60 1"}});
  ASSERT_EQ(floes.ice->fields.size(), 3u);
  EXPECT_EQ(name_of(floes.ice->fields[2].kind()), "level") << "behind those of the file";
  expect_refused("contact[+]/@tolerance", "1", "contact[+]/@tolerance", {"<scene> may hold one <contact> only"});
  expect_refused("ice/vary[+]/@cov", "0.1", "<ice><vary property>", {"the attribute is missing"});
}

TEST_F(Overriding, ValuesAreCheckedAsInTheFile) {
  expect_refused("contact/@tolerance", "-1", "<contact tolerance>", {"found '-1'", ">= 0 [m/s]"});
  expect_refused("water/waves[+]/@height", "1", "<water><waves period>", {"the attribute is missing"});
  expect_refused("time/@end", "-5", "<time end>", {"after the start"});
  expect_refused("ice/field[1]/@file", "none.json", "<ice><field file>", {"there is no such file"});
}

TEST_F(Overriding, WrongPathsNameTheNearest) {
  const auto refused = [&](const std::string& path, const std::vector<std::string>& words) {
    expect_refused(path, "1", path, words);
  };
  refused("contact/@tolerence", {"<contact> has no attribute 'tolerence'", "nearest: tolerance"});
  refused("contakt/@tolerance", {"<scene> has no element 'contakt'", "nearest: contact"});
  refused("ice/feld[1]/@z", {"<ice> has no element 'feld'", "nearest: field"});
  refused("ice/field[3]/@z", {"<ice> holds 2 <field>", "no number 3"});
  refused("ice/field/@z", {"<ice> holds 2 <field>", "field[1]"});
  refused("ice/floe/@z", {"<ice> holds no <floe>"});
  refused("body[@name='bos']/@mass", {"0 with name 'bos'", "nearest: box"});
  refused("body[@mass='1']/@mass", {"2 with mass '1'"});
  for (const char* path : {"", "contact", "contact/tolerance", "@", "contact/@", "//@x", "ice/field[0]/@z",
                           "ice/field[]/@z", "ice/field[-1]/@z", "ice/field[1/@z", "body[name='box']/@mass",
                           "body[@name=box]/@mass", "body[@name='box'/@mass", "contact/@tolerance/"})
    refused(path, {"this is no path", "contact/@tolerance"});
}

TEST(SplitOverride, AtTheEqualsSignBehindTheAttribute) {
  using Pair = std::pair<std::string, std::string>;
  EXPECT_EQ(split_override("contact/@tolerance=1e-8"), Pair("contact/@tolerance", "1e-8"));
  EXPECT_EQ(split_override("body[@name='box']/@mass=2"), Pair("body[@name='box']/@mass", "2"));
  EXPECT_EQ(split_override("body[@name='a=]b']/@mass=2"), Pair("body[@name='a=]b']/@mass", "2"));
  EXPECT_EQ(split_override("output/@folder=a=b"), Pair("output/@folder", "a=b"));
  EXPECT_EQ(split_override("output/@folder="), Pair("output/@folder", ""));
  EXPECT_THROW(split_override("contact/@tolerance"), InputError);
  EXPECT_THROW(split_override("body[@name='box']/@mass"), InputError);
}

}  // namespace overrides_test
}  // namespace nilas::scene
