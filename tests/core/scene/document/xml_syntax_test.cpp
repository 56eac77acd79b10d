/// Files that are no XML, cut short or empty.
#include <gtest/gtest.h>

#include "tests/core/scene/complete_scene.h"

namespace nilas::scene {
namespace xml_syntax_test {

using testing::expect_fault;
using testing::SceneFolder;

TEST(XmlSyntax, EmptyFiles) {
  const SceneFolder folder;
  for (const char* text : {"", " \n ", "<?xml version='1.0'?>\n", "<!-- nothing -->\n"}) {
    const auto faults = folder.faults(text);
    ASSERT_EQ(faults.size(), 1u) << text;
    EXPECT_NE(faults[0].message.find("holds no XML element"), std::string::npos) << faults[0].text();
  }
}

TEST(XmlSyntax, AFileCutShortNamesWhatIsOpen) {
  const SceneFolder folder;
  expect_fault(folder.faults("<scene version='1'>\n  <time end='2'/>\n  <contact law='pyramid'>\n"), 3, "<contact>",
               {"never closed", "cut short"});
  expect_fault(folder.faults("<scene version='1'>\n  <time end='2'/>\n  <contact law='pyr"), 3, "<contact>",
               {"the file ends inside this tag"});
}

TEST(XmlSyntax, WhatIsLargerThanAnySceneIsRefusedAtOnce) {
  const SceneFolder folder;
  const auto message = [&](const std::string& text) { return folder.faults(text).at(0).message; };
  std::string tags = "<scene version='1'>", attributes = "<scene version='1'><ice";
  for (int k = 0; k < 1'000'000; ++k) tags += "<i/>";
  for (int k = 0; k < 1001; ++k) attributes += " a" + std::to_string(k) + "='1'";
  EXPECT_EQ(message(tags + "</scene>"), "the file has more than 1000000 tags");
  EXPECT_EQ(message(attributes + "/></scene>"), "the tag has more than 1000 attributes");
  EXPECT_EQ(message(std::string((64 << 20) + 1, ' ')), "the file has more than 64 MB");
}

/// Each column was once counted from the start of its line: a scene on one line took minutes.
TEST(XmlSyntax, ColumnsAreRightInALineOfManyElements) {
  const SceneFolder folder;
  std::string text = "<scene version='1'>";
  for (int k = 0; k < 3000; ++k) text += "<å/>";
  const auto faults = folder.faults(text + "</scene>");
  ASSERT_GT(faults.size(), 2999U);
  for (const auto& fault : faults)
    if (fault.where == "<å>") {
      EXPECT_EQ((fault.column - 20) % 4, 0) << fault.column;
    }
  std::string longer = "<scene version='1'>";
  for (int k = 0; k < 20000; ++k) longer += "<abcd/>";
  EXPECT_EQ(folder.faults(longer + "</scene>").back().column, 0) << "of such a line no column is known";
}

/// However many bytes are missing at the end, the scene is refused (not read in part).
TEST(XmlSyntax, EveryTruncationIsRefused) {
  const SceneFolder folder;
  testing::write_inputs(folder);
  const std::string whole = testing::k_complete_scene;
  const std::size_t end = whole.rfind('>');
  for (std::size_t size = 0; size <= end; size += 7) {
    const auto faults = folder.faults(whole.substr(0, size));
    ASSERT_EQ(faults.size(), 1u) << size;
    EXPECT_GT(faults[0].line, 0) << size << faults[0].text();
  }
}

TEST(XmlSyntax, TagsThatDoNotMatch) {
  const SceneFolder folder;
  expect_fault(folder.faults("<scene version='1'>\n<hydro>\n<drag/>\n</water>\n</scene>"), 4, "<water>",
               {"found </water>", "allowed: </hydro>", "line 2"});
  expect_fault(folder.faults("<scene version='1'>\n</scene>\n</scene>"), 3, "<scene>", {"closes nothing"});
}

TEST(XmlSyntax, FaultyAttributes) {
  const SceneFolder folder;
  expect_fault(folder.faults("<scene version='1'>\n<time step='1' step='2'/>\n</scene>"), 2, "<time>",
               {"each name once"});
  expect_fault(folder.faults("<scene version='1'>\n<time step=1/>\n</scene>"), 2, "<time>", {"name=\"value\""});
  const auto faults = folder.faults("<scene version='1'>\n<time step='1 end='2'/>\n<seed value='1'/>\n</scene>");
  ASSERT_EQ(faults.size(), 1u);
  EXPECT_EQ(faults[0].line, 2) << faults[0].text();
}

TEST(XmlSyntax, NotOneScene) {
  const SceneFolder folder;
  expect_fault(folder.faults("<scene version='1'/>\n<scene version='1'/>"), 2, "", {"only one element"});
  expect_fault(folder.faults("<scene version='1'/>\nend"), 2, "", {"not well-formed"});
  expect_fault(folder.faults("begin\n<scene version='1'/>"), 1, "", {"only one element"});
  expect_fault(folder.faults("<mesh/>"), 1, "<mesh>", {"as the root", "allowed: <scene>"});
  expect_fault(folder.faults("<Scene version='1'/>"), 1, "<Scene>", {"allowed: <scene>"});
}

TEST(XmlSyntax, BinaryContent) {
  const SceneFolder folder;
  expect_fault(folder.faults(std::string("<scene version='1'>\n\0</scene>", 29)), 2, "", {"zero byte"});
  EXPECT_EQ(folder.faults("\x89PNG\r\n\x1a\n....").size(), 1u);
  EXPECT_EQ(folder.faults("# a page\n\nnot a scene\n").size(), 1u);
}

TEST(XmlSyntax, ByteOrderMarkAndWindowsLines) {
  const SceneFolder folder;
  expect_fault(folder.faults("\xEF\xBB\xBF<scene version='1'>\r\n<time end='x'/>\r\n</scene>\r\n"), 2, "<time end>",
               {"'x'"});
  EXPECT_TRUE(folder.faults("\xEF\xBB\xBF<scene version='1'/>\r\n").empty());
}

}  // namespace xml_syntax_test
}  // namespace nilas::scene
