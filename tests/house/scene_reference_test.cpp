/// docs/reference/scene.md must equal the schema's own text, so that a change of the table comes with its page.
#include <gtest/gtest.h>

#include <string>

#include "core/scene/schema/schema.h"
#include "tests/support/file_text.h"

TEST(House, TheSceneReferenceIsThatOfTheSchema) {
  EXPECT_EQ(nilas::test::read_text(std::string(NILAS_SOURCE_DIR) + "/docs/reference/scene.md"),
            nilas::scene::schema_markdown())
      << "write it again: build/release/nilas schema --markdown > docs/reference/scene.md";
}
