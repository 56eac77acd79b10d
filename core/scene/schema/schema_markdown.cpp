/// Writes the schema table as the scene reference page.
#include <algorithm>

#include "core/scene/schema/schema.h"
#include "core/scene/spec/values.h"

namespace nilas::scene {

namespace {

constexpr const char* k_introduction = R"(# Scene reference

A scene is an XML file. Attributes hold numbers and words; child elements hold parts of the scene.
Lengths are in metres and all units are SI. An attribute in another unit carries it in its name
(`heading_deg`). Blanks separate the numbers of a vector. Numbers are finite decimals with a point.
Names must be unique.

Paths are relative to the folder of the scene file. Only the output folder is relative to the
working directory.

What a scene does not name is not modelled. What it names and this version lacks is refused. Names
of choices that have changed are still read, with a warning that gives the new name.
)";

/// Wraps text to 100 characters. A word that would start a list at the start of a line stays on the previous line.
std::string wrapped(const std::string& text) {
  constexpr std::size_t k_width = 100;
  std::string out;
  std::size_t column = 0;
  for (const std::string& word : split_words(text)) {
    const bool begins_list = word == "-" || word == "+" || word == "*" || word == "=" ||
                             (word.back() == '.' && parse_integer(word.substr(0, word.size() - 1)));
    if (column > 0 && column + 1 + word.size() > k_width && !begins_list) {
      out += "\n";
      column = 0;
    }
    out += (column > 0 ? " " : "") + word;
    column += (column > 0 ? 1 : 0) + word.size();
  }
  return out;
}

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
  if (!spec.built) s += " It is not built in this version.";
  if (spec.applies.values.empty()) return s;
  s += " It applies only with " + spec.applies.attribute;
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
      return "occurs exactly once.";
    case Count::many:
      return "occurs any number of times.";
    case Count::optional:
      return spec.always ? "occurs at most once. If it is absent, its defaults hold." : "occurs at most once.";
  }
  return "";
}

std::string element_section(const ElementSpec& spec) {
  const std::string built = spec.built ? "" : " **Not built in this version.**";
  std::string s = "\n## " + code("<" + spec.name + ">") + "\n\n" +
                  wrapped(code(path_of(spec)) + " " + count_text(spec) + built + " " + cell(spec.doc)) + "\n";
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

}  // namespace nilas::scene
