/// A scene that names a feature which this version lacks is refused with the place, never ignored.
#include <gtest/gtest.h>

#include "tests/core/scene/scene_files.h"

namespace nilas::scene {
namespace not_built_test {

using testing::expect_fault;
using testing::in_scene;
using testing::SceneFolder;

struct NotBuilt {
  std::string content, where;
};

TEST(NotBuilt, EachIsRefusedWithItsPlace) {
  const SceneFolder folder;
  folder.write("file", "");
  const std::string vessel = "<vessel><hull/><mass value='1'/>";
  const std::vector<NotBuilt> cases{
      {"<water><current profile='file'/></water>", "<water><current profile>"},
      {"<water><waves kind='regular' height='0.1' period='2'/></water>", "<water><waves>"},
      {"<hydro><added_mass model='strip'/></hydro>", "<hydro><added_mass>"},
      {"<hydro><radiation model='cummins'/></hydro>", "<hydro><radiation>"},
      {vessel + "<control mode='dp'/></vessel>", "<vessel><control>"},
      {vessel + "<thrusters file='file'/></vessel>", "<vessel><thrusters>"},
      {vessel + "<mooring file='file'/></vessel>", "<vessel><mooring>"}};
  for (const auto& c : cases) {
    SCOPED_TRACE(c.content);
    expect_fault(folder.faults(in_scene(c.content)), 2, c.where, {"not built in this version"});
  }
}

TEST(NotBuilt, TheMessageSaysWhatToDo) {
  const SceneFolder folder;
  expect_fault(folder.faults(in_scene("<water><waves/></water>")), 2, "<water><waves>", {"remove the element"});
}

TEST(NotBuilt, WhatSaysTheSameAsNothingIsTaken) {
  const SceneFolder folder;
  EXPECT_TRUE(folder
                  .faults(in_scene("<output problems='never' contacts='none'/>"
                                   "<ice><field region='0 0 1 1' breakable='true'/></ice>"))
                  .empty());
}

}  // namespace not_built_test
}  // namespace nilas::scene
