/// docs/reference/scene.md must equal the schema's own text, so that a change of the table comes with its page.
#include <gtest/gtest.h>

#include <fstream>
#include <sstream>

#include "core/scene/schema/schema.h"

TEST(House, TheSceneReferenceIsThatOfTheSchema) {
  std::ifstream in(std::string(NILAS_SOURCE_DIR) + "/docs/reference/scene.md");
  std::ostringstream text;
  text << in.rdbuf();
  EXPECT_EQ(text.str(), nilas::schema_markdown())
      << "write it again: build/release/nilas schema --markdown > docs/reference/scene.md";
}
