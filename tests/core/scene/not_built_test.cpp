/// A scene that names a feature which this version lacks is refused with the place, never ignored.
#include <gtest/gtest.h>

#include "core/scene/schema/schema.h"
#include "tests/core/scene/scene_files.h"

namespace nilas::scene {
namespace not_built_test {

using testing::in_scene;
using testing::SceneFolder;

/// No element of this version is missing, so the rule is shown on an attribute of its own.
TEST(NotBuilt, IsAChoiceOrAnAttributeThatSaysSo) {
  AttributeSpec attribute;
  attribute.type = ValueType::choice;
  attribute.choices = {"regular", "breaking"};
  attribute.not_built = {"breaking"};
  EXPECT_FALSE(is_not_built(attribute, "regular"));
  EXPECT_TRUE(is_not_built(attribute, "breaking"));
  attribute.built = false;
  EXPECT_TRUE(is_not_built(attribute, "regular"));
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
