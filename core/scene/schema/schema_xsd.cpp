/// The schema table as W3C XML Schema 1.0.
#include <algorithm>

#include "core/scene/schema/schema.h"
#include "core/scene/spec/values.h"

namespace nilas::scene {

namespace {

std::string escaped(const std::string& text) {
  std::string s;
  for (const char c : text) {
    if (c == '&')
      s += "&amp;";
    else if (c == '<')
      s += "&lt;";
    else if (c == '>')
      s += "&gt;";
    else if (c == '"')
      s += "&quot;";
    else
      s += c;
  }
  return s;
}

constexpr const char* k_head = R"(<?xml version="1.0" encoding="UTF-8"?>
<xs:schema xmlns:xs="http://www.w3.org/2001/XMLSchema">
  <xs:simpleType name="number">
    <xs:restriction base="xs:double">
      <xs:pattern value="[+\-]?([0-9]+(\.[0-9]*)?|\.[0-9]+)([eE][+\-]?[0-9]+)?"/>
    </xs:restriction>
  </xs:simpleType>
  <xs:simpleType name="integer">
    <xs:restriction base="xs:long"/>
  </xs:simpleType>
  <xs:simpleType name="switch">
    <xs:restriction base="xs:token">
      <xs:enumeration value="true"/>
      <xs:enumeration value="false"/>
    </xs:restriction>
  </xs:simpleType>
  <xs:simpleType name="label">
    <xs:restriction base="xs:token">
      <xs:pattern value="[^,;/\\&quot;'&lt;&gt;]+"/>
    </xs:restriction>
  </xs:simpleType>
  <xs:simpleType name="path">
    <xs:restriction base="xs:token">
      <xs:minLength value="1"/>
    </xs:restriction>
  </xs:simpleType>
)";

/// Writes the nested declarations with their indentation.
class XsdWriter {
 public:
  std::string text() {
    out_ = k_head;
    element(scene_schema().front(), 1);
    return out_ + "</xs:schema>\n";
  }

 private:
  void line(int depth, const std::string& text) {
    out_ += std::string(2 * static_cast<std::size_t>(depth), ' ') + text + '\n';
  }

  void documentation(int depth, const std::string& text) {
    line(depth, "<xs:annotation><xs:documentation>" + escaped(text) + "</xs:documentation></xs:annotation>");
  }

  void element(const ElementSpec& spec, int depth) {
    line(depth, "<xs:element name=\"" + spec.name + "\"" + occurrence(spec) + ">");
    documentation(depth + 1, spec.doc + (spec.built ? "" : " Not built in this version."));
    line(depth + 1, "<xs:complexType>");
    children(spec, depth + 2);
    for (const auto& a : spec.attributes) attribute(a, depth + 2);
    line(depth + 1, "</xs:complexType>");
    line(depth, "</xs:element>");
  }

  /// Children may have any order. XSD 1.0 can count them only where none may repeat.
  void children(const ElementSpec& spec, int depth) {
    const auto specs = children_of(spec.name);
    if (specs.empty()) return;
    const bool repeat = repeats(spec);
    line(depth, repeat ? "<xs:choice minOccurs=\"0\" maxOccurs=\"unbounded\">" : "<xs:all>");
    for (const auto* child : specs) element(*child, depth + 1);
    line(depth, repeat ? "</xs:choice>" : "</xs:all>");
  }

  static bool repeats(const ElementSpec& parent) {
    const auto specs = children_of(parent.name);
    return std::any_of(specs.begin(), specs.end(), [](const auto* child) { return child->count == Count::many; });
  }

  static std::string occurrence(const ElementSpec& spec) {
    if (spec.parent.empty() || repeats(*find_element(spec.parent))) return "";
    return spec.count == Count::optional ? " minOccurs=\"0\"" : "";
  }

  void attribute(const AttributeSpec& spec, int depth) {
    std::string head = "<xs:attribute name=\"" + spec.name + "\"";
    if (spec.required) head += " use=\"required\"";
    if (!spec.default_value.empty()) head += " default=\"" + escaped(spec.default_value) + "\"";
    line(depth, head + ">");
    documentation(depth + 1, attribute_documentation(spec));
    type(spec, depth + 1);
    line(depth, "</xs:attribute>");
  }

  static std::string attribute_documentation(const AttributeSpec& spec) {
    std::string text = spec.doc;
    if (!spec.unit.empty()) text += " [" + unit_text(spec) + "]";
    if (!spec.built) text += " Not built in this version.";
    for (const auto& choice : spec.not_built) text += " '" + choice + "' is not built in this version.";
    return text;
  }

  void type(const AttributeSpec& spec, int depth) {
    line(depth, "<xs:simpleType>");
    if (spec.min_count == 1 && spec.max_count == 1)
      item(spec, depth + 1);
    else
      list(spec, depth + 1);
    line(depth, "</xs:simpleType>");
  }

  void list(const AttributeSpec& spec, int depth) {
    line(depth, "<xs:restriction>");
    line(depth + 1, "<xs:simpleType><xs:list><xs:simpleType>");
    item(spec, depth + 2);
    line(depth + 1, "</xs:simpleType></xs:list></xs:simpleType>");
    line(depth + 1, "<xs:minLength value=\"" + std::to_string(spec.min_count) + "\"/>");
    if (spec.max_count != k_any_count)
      line(depth + 1, "<xs:maxLength value=\"" + std::to_string(spec.max_count) + "\"/>");
    line(depth, "</xs:restriction>");
  }

  /// One value of the attribute.
  void item(const AttributeSpec& spec, int depth) {
    line(depth, "<xs:restriction base=\"" + base(spec.type) + "\">");
    if (!spec.choices.empty()) line(depth + 1, "<xs:pattern value=\"" + choice_pattern(spec.choices) + "\"/>");
    if (spec.type == ValueType::words && spec.choices.empty()) line(depth + 1, R"(<xs:pattern value="\S+"/>)");
    if (spec.type == ValueType::number || spec.type == ValueType::integer) bounds(spec.range, depth + 1);
    line(depth, "</xs:restriction>");
  }

  static std::string base(ValueType type) {
    switch (type) {
      case ValueType::number:
        return "number";
      case ValueType::integer:
        return "integer";
      case ValueType::boolean:
        return "switch";
      case ValueType::name:
        return "label";
      case ValueType::text:
        return "xs:string";
      case ValueType::words:
      case ValueType::choice:
        return "xs:token";
      case ValueType::path:
      case ValueType::hull:
        return "path";
    }
    return "";
  }

  static std::string choice_pattern(const std::vector<std::string>& choices) {
    std::string pattern;
    for (const auto& choice : choices) {
      const bool counted = choice.size() > 2 && choice.compare(choice.size() - 2, 2, "-k") == 0;
      pattern += (pattern.empty() ? "" : "|") + (counted ? choice.substr(0, choice.size() - 1) + "[0-9]+" : choice);
    }
    return pattern;
  }

  void bounds(const Range& range, int depth) {
    const Range unbounded;
    const auto bound = [&](const char* kind, bool inclusive, double value) {
      line(depth, std::string("<xs:") + kind + (inclusive ? "Inclusive" : "Exclusive") + " value=\"" +
                      bound_text(value) + "\"/>");
    };
    if (range.min > unbounded.min) bound("min", range.min_inclusive, range.min);
    if (range.max < unbounded.max) bound("max", range.max_inclusive, range.max);
  }

  /// A bound as text; xs:long does not accept an exponent.
  static std::string bound_text(double value) {
    const auto whole = static_cast<std::int64_t>(value);
    return static_cast<double>(whole) == value ? std::to_string(whole) : format_number(value);
  }

  std::string out_;
};

}  // namespace

std::string schema_xsd() { return XsdWriter().text(); }

}  // namespace nilas::scene
