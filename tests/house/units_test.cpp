/// Every number of a scene has a unit from which `--scale` finds its factor.
#include <gtest/gtest.h>

#include "core/scene/schema/schema.h"
#include "core/scene/spec/unit.h"

namespace units_test {

using namespace nilas::scene;

TEST(House, UnitsOfTheSchemaAreKnown) {
  for (const ElementSpec& element : scene_schema()) {
    const auto exponent = [&](const std::string& name) {
      return find_attribute(element, name) ? std::optional(1.0) : std::nullopt;
    };
    for (const AttributeSpec& attribute : element.attributes) {
      if (!attribute.scaled) continue;
      EXPECT_TRUE(parse_unit(attribute.unit, exponent))
          << "<" << element.name << " " << attribute.name << ">: '" << attribute.unit
          << "' is not known; write it in symbols of core/scene/spec/unit.cpp, or add its symbol there";
      for (const OtherUnit& other : attribute.other_units)
        EXPECT_TRUE(parse_unit(other.unit, exponent) && find_attribute(element, other.applies.attribute))
            << "<" << element.name << " " << attribute.name << ">: '" << other.unit << "'";
      const bool whole = attribute.type == ValueType::integer;
      EXPECT_TRUE(!whole || parse_unit(attribute.unit, exponent) == Dimension{})
          << "<" << element.name << " " << attribute.name << ">: a whole number cannot be scaled";
    }
  }
}

}  // namespace units_test
