/// The schema table as the scene reference page.
#include <algorithm>

#include "core/scene/schema/schema.h"
#include "core/scene/schema/values.h"

namespace nilas {

namespace {

constexpr const char* k_introduction = R"(# Scene reference

A scene is an XML file. Attributes hold numbers and words, child elements hold things. Lengths are in metres, and all
units are SI; an attribute in another unit carries it in its name (`heading_deg`). Vectors are blank-separated. Names
are unique. Paths are relative to the scene file's folder, except the output folder, which is relative to the working
directory. Numbers are finite decimals with a point.

What is not named is not modelled. Where a default's model is not built yet, the nearest one that is built stands in and
the run says so; what a scene names and this version lacks is refused.
)";

std::string cell(const std::string& text) {
  std::string s;
  for (const char c : text)
    s += c == '|' ? std::string("\\|") : c == '<' ? "&lt;" : c == '>' ? "&gt;" : std::string(1, c);
  return s;
}

std::string code(const std::string& text) { return "`" + text + "`"; }

std::string values_cell(const AttributeSpec& spec) {
  if (spec.choices.empty()) return cell(allowed_text(spec));
  std::string s;
  for (const auto& choice : spec.choices) {
    const bool built = std::count(spec.not_built.begin(), spec.not_built.end(), choice) == 0;
    s += (s.empty() ? "" : ", ") + code(choice) + (built ? "" : " (not built)");
  }
  return s;
}

std::string default_cell(const AttributeSpec& spec) {
  if (spec.required) return "required";
  std::string s = spec.default_value.empty() ? cell(spec.default_note) : code(spec.default_value);
  return s.empty() ? "none" : s;
}

std::string meaning_cell(const AttributeSpec& spec) {
  std::string s = cell(spec.doc);
  if (!spec.built) s += " Not built in this version.";
  if (spec.applies.values.empty()) return s;
  s += " Only with " + spec.applies.attribute;
  for (std::size_t i = 0; i < spec.applies.values.size(); ++i)
    s += (i == 0 ? " " : ", ") + code(spec.applies.values[i]);
  return s + ".";
}

std::string path_of(const ElementSpec& spec) {
  return spec.parent.empty() ? spec.name : path_of(*find_element(spec.parent)) + "/" + spec.name;
}

std::string count_text(const ElementSpec& spec) {
  switch (spec.count) {
    case Count::one:
      return "exactly one";
    case Count::many:
      return "any number";
    case Count::optional:
      return spec.always ? "at most one; absent means its defaults" : "at most one";
  }
  return "";
}

std::string element_section(const ElementSpec& spec) {
  std::string s = "\n## " + code("<" + spec.name + ">") + "\n\n" + code(path_of(spec)) + ", " + count_text(spec) + ".";
  if (!spec.built) s += " **Not built in this version.**";
  s += " " + cell(spec.doc) + "\n";
  if (spec.attributes.empty()) return s + "\nIt takes no attributes.\n";
  s += "\n| attribute | allowed | default | meaning |\n|---|---|---|---|\n";
  for (const auto& a : spec.attributes)
    s += "| " + code(a.name) + " | " + values_cell(a) + " | " + default_cell(a) + " | " + meaning_cell(a) + " |\n";
  return s;
}

}  // namespace

std::string schema_markdown() {
  std::string page = k_introduction;
  for (const auto& element : scene_schema()) page += element_section(element);
  return page;
}

}  // namespace nilas
