/// Templates of pages and of scripts for gnuplot.
#include "core/output/text/fill_template.h"

#include <gtest/gtest.h>

#include "core/base/error.h"

namespace fill_template_test {

using namespace nilas;
using namespace nilas::output;
using Json = nlohmann::ordered_json;

std::string filled(const std::string& text, const Json& data) { return fill_template(text, data, Escape::html); }

TEST(Template, FillsValuesAsTheyAre) {
  EXPECT_EQ(filled("{{a}} of {{b}}: {{c}}{{d}}", {{"a", 3}, {"b", 0.1}, {"c", "text"}, {"d", nullptr}}),
            "3 of 0.1: text");
}

TEST(Template, EscapesHostileNamesForPages) {
  const Json data{{"name", "<script>alert('x')</script> & \"y\""}};
  EXPECT_EQ(filled("<td title=\"{{name}}\">", data),
            "<td title=\"&lt;script&gt;alert(&#39;x&#39;)&lt;/script&gt; &amp; &quot;y&quot;\">");
  EXPECT_EQ(filled("{{{name}}}", data), data["name"].get<std::string>());
}

TEST(Template, EscapesHostileNamesForGnuplot) {
  const Json data{{"name", "it's `rm -rf` \"\n"}};
  EXPECT_EQ(fill_template("set title '{{name}}'", data, Escape::gnuplot), "set title 'it''s `rm -rf` \" '")
      << "single quotes run no commands";
}

TEST(Template, RepeatsASectionPerElement) {
  const Json data{{"unit", "N"}, {"rows", {{{"x", 1}}, {{"x", 2}}}}, {"words", {"a", "b"}}};
  EXPECT_EQ(filled("{{#rows}}{{x}} {{unit}};{{/rows}}", data), "1 N;2 N;") << "outer names are seen within";
  EXPECT_EQ(filled("{{#words}}{{.}}{{/words}}", data), "ab");
}

TEST(Template, LeavesOutWhatIsNotThere) {
  const Json data{{"none", nullptr}, {"no", false}, {"empty", ""}, {"list", Json::array()}, {"zero", 0}, {"yes", true}};
  for (const char* name : {"none", "no", "empty", "list"}) {
    const std::string section = std::string(name) + "}}x{{/" + name + "}}";
    EXPECT_EQ(filled("{{#" + section, data), "") << name;
    EXPECT_EQ(filled("{{^" + section, data), "x") << name;
  }
  EXPECT_EQ(filled("{{#zero}}{{.}}{{/zero}}{{#yes}}x{{/yes}}{{^yes}}y{{/yes}}", data), "0x") << "0 is a number";
}

TEST(Template, SectionsMayStandWithinEachOther) {
  const Json data{{"a", {{{"b", {1, 2}}}, {{"b", Json::array()}}}}};
  EXPECT_EQ(filled("{{#a}}[{{#b}}{{.}}{{/b}}{{^b}}-{{/b}}]{{/a}}", data), "[12][-]");
}

TEST(Template, ATagAloneInItsLineTakesTheLineWithIt) {
  EXPECT_EQ(filled("a\n{{#x}}\nb\n{{/x}}\nc\n", {{"x", true}}), "a\nb\nc\n");
  EXPECT_EQ(filled("a\n  {{#x}}\nb\n  {{/x}}\nc\n", {{"x", false}}), "a\nc\n");
}

TEST(Template, RefusesWhatItCannotFill) {
  EXPECT_THROW(filled("{{unknown}}", Json::object()), ContractError);
  EXPECT_THROW(filled("{{#x}}", {{"x", true}}), ContractError);
  EXPECT_THROW(filled("{{#x}}", {{"x", false}}), ContractError);
  EXPECT_THROW(filled("{{/x}}", {{"x", true}}), ContractError);
  EXPECT_THROW(filled("{{x", {{"x", true}}), ContractError);
}

}  // namespace fill_template_test
