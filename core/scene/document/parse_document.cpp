#include <tinyxml2.h>

#include <algorithm>

#include "core/scene/document/document.h"
#include "core/scene/document/source_columns.h"
#include "core/scene/document/xml_syntax.h"

namespace nilas::scene {

namespace {

std::string syntax_message(tinyxml2::XMLError error) {
  switch (error) {
    case tinyxml2::XML_ERROR_EMPTY_DOCUMENT:
      return "the file holds no XML element; a scene begins with <scene version=\"1\">";
    case tinyxml2::XML_ERROR_PARSING_ATTRIBUTE:
      return "an attribute is not well formed; allowed: name=\"value\", each name once, blanks between attributes";
    case tinyxml2::XML_ERROR_PARSING_ELEMENT:
      return "an element is not well formed";
    case tinyxml2::XML_ERROR_PARSING_COMMENT:
      return "a comment is not closed";
    case tinyxml2::XML_ELEMENT_DEPTH_EXCEEDED:
      return "elements are nested too deeply for a scene";
    case tinyxml2::XML_ERROR_PARSING_DECLARATION:
      return "an XML declaration stands in the wrong place";
    default:
      return "the text is not well-formed XML";
  }
}

/// "XMLElement name=time" is how the parser's message ends where it knows the element.
std::string element_in(const tinyxml2::XMLDocument& document) {
  const std::string message = document.ErrorStr() ? document.ErrorStr() : "";
  const std::string mark = "XMLElement name=";
  const auto at = message.rfind(mark);
  return at == std::string::npos ? "" : "<" + message.substr(at + mark.size()) + ">";
}

[[noreturn]] void refuse(const Fault& fault) { throw SceneError({fault}); }

class TreeBuilder {
 public:
  TreeBuilder(const std::string& text, const std::string& file) : columns_(text), file_(file) {}

  SceneElement build(const tinyxml2::XMLElement& source, const SceneElement* parent) {
    const std::string name = source.Name();
    const Place place{file_, source.GetLineNum(), columns_.tag(source.GetLineNum(), name)};
    SceneElement element = make_element(name, parent, place);
    for (const auto* a = source.FirstAttribute(); a; a = a->Next()) {
      const int line = a->GetLineNum();
      const int column = columns_.attribute(line, a->Name());
      const int fallback = line == place.line ? place.column : 0;
      element.attributes.push_back({a->Name(), a->Value(), {file_, line, column > 0 ? column : fallback}});
    }
    for (const auto* node = source.FirstChild(); node; node = node->NextSibling()) {
      if (const auto* child = node->ToElement()) element.children.push_back(build(*child, &element));
      if (node->ToText() && !element.text_place) element.text_place = Place{file_, node->GetLineNum(), 0};
    }
    return element;
  }

 private:
  SourceColumns columns_;
  std::string file_;
};

void refuse_extra_content(const tinyxml2::XMLDocument& document, const std::string& file) {
  int elements = 0;
  for (const auto* node = document.FirstChild(); node; node = node->NextSibling()) {
    const bool second = node->ToElement() && ++elements > 1;
    if (second || node->ToText())
      refuse({file, node->GetLineNum(), 0, "", "only one element, <scene>, may stand at the top of a scene file"});
  }
}

}  // namespace

SceneElement parse_document(const std::string& text, const std::string& file) {
  if (const auto nul = text.find('\0'); nul != std::string::npos) {
    const auto line = std::count(text.begin(), text.begin() + static_cast<std::ptrdiff_t>(nul), '\n') + 1;
    refuse({file, static_cast<int>(line), 0, "", "the file holds a zero byte; it is not XML in UTF-8"});
  }
  if (const auto size = size_fault(text, file)) refuse(*size);
  tinyxml2::XMLDocument document;
  const bool parsed = document.Parse(text.data(), text.size()) == tinyxml2::XML_SUCCESS;
  // The parser accepts some tags that close nothing.
  const auto tags = tag_fault(text, file);
  // A missing quote in an attribute also disturbs later tags: the earlier place is the cause.
  const bool in_attribute = document.ErrorID() == tinyxml2::XML_ERROR_PARSING_ATTRIBUTE;
  if (tags && !(in_attribute && document.ErrorLineNum() < tags->line)) refuse(*tags);
  const bool empty = document.ErrorID() == tinyxml2::XML_ERROR_EMPTY_DOCUMENT || (parsed && !document.RootElement());
  if (empty) refuse({file, 1, 0, "", syntax_message(tinyxml2::XML_ERROR_EMPTY_DOCUMENT)});
  if (!parsed) refuse({file, document.ErrorLineNum(), 0, element_in(document), syntax_message(document.ErrorID())});
  refuse_extra_content(document, file);
  return TreeBuilder(text, file).build(*document.RootElement(), nullptr);
}

}  // namespace nilas::scene
