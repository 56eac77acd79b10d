/// JSON texts of studies.
#include "apps/compare/workshop/json_store.h"

#include <gtest/gtest.h>

namespace json_store_test {

using namespace nilas::compare;

TEST(JsonStore, IndentsByTwoBlanksAsOtherCommands) {
  EXPECT_EQ(json_text({{"a", 1}, {"b", {{"c", 2}}}}), "{\n  \"a\": 1,\n  \"b\": {\n    \"c\": 2\n  }\n}\n");
}

}  // namespace json_store_test
