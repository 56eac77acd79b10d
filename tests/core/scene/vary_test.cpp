/// Tests of <vary>: its meaning, and the refused cases.
#include <gtest/gtest.h>

#include <algorithm>

#include "tests/core/scene/scene_files.h"

namespace nilas::scene {
namespace vary_test {

using testing::expect_fault;
using testing::in_scene;
using testing::SceneFolder;

std::string ice(const std::string& content) { return in_scene("<ice>\n" + content + "\n</ice>"); }

TEST(Vary, ReadsToPlainValues) {
  const SceneFolder folder;
  const Scene scene = folder.read(
      ice("<vary property='thickness' cov='0.08' correlation_length='0.5'/>"
          "<vary property='flexural_strength' distribution='lognormal' cov='0.2' mean='5e4' correlation_length='0.5'"
          " with='thickness compressive_strength' correlation='0.5 -0.25'/>\n"
          "<vary property='compressive_strength' distribution='weibull' cov='0.1' correlation_length='0.5'/>"));
  const auto& vary = scene.ice->vary;
  ASSERT_EQ(vary.size(), 3u);
  EXPECT_EQ(name_of(vary[0].property), "thickness");
  EXPECT_EQ(name_of(vary[0].distribution), "normal");
  EXPECT_EQ(vary[0].cov, 0.08);
  EXPECT_EQ(vary[0].mean, 0);
  EXPECT_EQ(vary[0].correlation_length, 0.5);
  EXPECT_EQ(vary[0].line, 3);
  EXPECT_EQ(vary[1].mean, 5e4);
  const std::vector<std::pair<FloeProperty, double>> pairs{{FloeProperty::thickness, 0.5},
                                                           {FloeProperty::compressive_strength, -0.25}};
  EXPECT_EQ(vary[1].correlations, pairs);
  EXPECT_EQ(vary[2].mean, 1e5) << "the default of <fracture>";
  EXPECT_EQ(vary[2].line, 4);
  const Scene again = SceneFolder().read(scene.as_run);
  EXPECT_EQ(again.as_run, scene.as_run);
}

bool notes(const Scene& scene, const std::string& note) {
  return std::count(scene.notes.begin(), scene.notes.end(), note) == 1;
}

TEST(Vary, WhatHasNoEffectIsNamed) {
  const SceneFolder folder;
  const Scene scene = folder.read(ice("<vary property='thickness' cov='0.1'/><vary property='flexural_strength'/>"));
  EXPECT_TRUE(notes(scene,
                    "<ice><vary>: flexural_strength has no effect in a run without <fracture>; `nilas field` writes "
                    "it."));
  EXPECT_FALSE(
      notes(scene, "<ice><vary>: thickness has no effect in a run without <fracture>; `nilas field` writes it."));
  EXPECT_TRUE(notes(folder.read(ice("<vary property='density' cov='0.1' mean='900'/>")),
                    "<ice><vary mean>: no effect with property 'density'."));
}

struct Refused {
  std::string content, where;
  std::vector<std::string> words;
  int line = 4;
};

/// The third pair makes the first two possible.
TEST(Vary, CorrelationsAreJudgedTogether) {
  const SceneFolder folder;
  const std::string two = "<vary property='thickness'/><vary property='density' with='thickness' correlation='0.9'/>";
  EXPECT_TRUE(folder
                  .faults(ice(two + "<vary property='flexural_strength' with='thickness density' "
                                    "correlation='0.9 0.9'/>"))
                  .empty());
  expect_fault(folder.faults(ice(two + "\n<vary property='flexural_strength' with='thickness' correlation='0.9'/>")), 4,
               "<ice><vary correlation>", {"positive definite"});
}

TEST(Vary, FaultsNameTheLine) {
  const SceneFolder folder;
  const std::string thickness = "<vary property='thickness' cov='0.1'/>\n", with = "<vary property='density' with=";
  const std::vector<Refused> cases{
      {thickness + "<vary property='thickness'/>", "<ice><vary property>", {"already by the element of line 3"}},
      {thickness + "<vary property='hardness'/>", "<ice><vary property>", {"found 'hardness'"}},
      {thickness + "<vary/>", "<ice><vary property>", {"missing"}},
      {thickness + "<vary property='density' cov='1.5'/>", "<ice><vary cov>", {"found '1.5'"}},
      {thickness + "<vary property='density' distribution='weibull'/>",
       "<ice><vary distribution>",
       {"found 'weibull' for density", "allowed: normal, lognormal, uniform"}},
      {thickness + with + "'density' correlation='0.5'/>", "<ice><vary with>", {"the property itself"}},
      {thickness + with + "'flexural_strength' correlation='0.5'/>", "<ice><vary with>", {"does not vary"}},
      {thickness + with + "'thickness'/>", "<ice><vary correlation>", {"found 0 numbers and 1 properties"}},
      {thickness + "<vary property='density' correlation='0.5'/>", "<ice><vary correlation>", {"1 numbers and 0"}},
      {thickness + with + "'thickness' correlation='0.5 0.4'/>", "<ice><vary correlation>", {"2 numbers and 1"}},
      {thickness + with + "'thickness' correlation='1'/>", "<ice><vary correlation>", {"found '1'"}},
      {thickness + with + "'thickness thickness' correlation='0.5 0.5'/>", "<ice><vary with>", {"already named"}},
      {thickness + with + "'thickness' correlation='0.5' correlation_length='2'/>",
       "<ice><vary correlation_length>",
       {"differs from that of 'thickness'"}},
      {thickness + with +
           "'thickness' correlation='0.9'/>\n<vary property='flexural_strength' with='thickness density' "
           "correlation='0.9 -0.9'/>",
       "<ice><vary correlation>",
       {"found 0.9 -0.9", "positive definite"},
       5}};
  for (const auto& c : cases) {
    SCOPED_TRACE(c.content);
    expect_fault(folder.faults(ice(c.content)), c.line, c.where, c.words);
  }
}

}  // namespace vary_test
}  // namespace nilas::scene
