#include "core/scene/document/source_columns.h"

#include <algorithm>

namespace nilas::scene {

static constexpr const char* k_xml_blanks = " \t\r\n";

static bool is_blank(char c) { return c == ' ' || c == '\t' || c == '\r' || c == '\n'; }

static std::string without_comments(std::string text) {
  for (auto open = text.find("<!--"); open != std::string::npos; open = text.find("<!--", open)) {
    const auto close = std::min(text.find("-->", open), text.size());
    std::replace_if(
        text.begin() + static_cast<std::ptrdiff_t>(open), text.begin() + static_cast<std::ptrdiff_t>(close),
        [](char c) { return c != '\n'; }, ' ');
  }
  return text;
}

int column_of(const std::string& line, std::size_t byte) {
  const auto starts_character = [](char c) { return (static_cast<unsigned char>(c) & 0xC0U) != 0x80U; };
  const auto end = line.begin() + static_cast<std::ptrdiff_t>(std::min(byte, line.size()));
  return 1 + static_cast<int>(std::count_if(line.begin(), end, starts_character));
}

/// Counts on from the place that was asked for before, so that a line of many elements is counted once.
int SourceColumns::column_in(Line& line, std::size_t byte) {
  if (byte < line.byte) return column_of(line.text, byte);
  line.column += column_of(line.text.substr(line.byte, byte - line.byte), byte - line.byte) - 1;
  line.byte = byte;
  return line.column;
}

SourceColumns::SourceColumns(const std::string& text) {
  const std::string clean = without_comments(text);
  for (std::size_t first = 0; first <= clean.size();) {
    const auto last = std::min(clean.find('\n', first), clean.size());
    lines_.push_back({clean.substr(first, last - first)});
    first = last + 1;
  }
}

SourceColumns::Line* SourceColumns::find(int line) {
  constexpr std::size_t k_longest = 1 << 16;
  const bool known = line >= 1 && static_cast<std::size_t>(line) <= lines_.size();
  return known && lines_[line - 1].text.size() <= k_longest ? &lines_[line - 1] : nullptr;
}

int SourceColumns::tag(int line, const std::string& name) {
  Line* l = find(line);
  if (!l) return 0;
  const std::string open = "<" + name;
  for (auto at = l->text.find(open, l->cursor); at != std::string::npos; at = l->text.find(open, at + 1)) {
    const auto end = at + open.size();
    if (end < l->text.size() && !is_blank(l->text[end]) && l->text[end] != '>' && l->text[end] != '/') continue;
    l->cursor = end;
    return column_in(*l, at);
  }
  return 0;
}

int SourceColumns::attribute(int line, const std::string& name) {
  Line* l = find(line);
  if (!l) return 0;
  for (auto at = l->text.find(name, l->cursor); at != std::string::npos; at = l->text.find(name, at + 1)) {
    if (at > 0 && !is_blank(l->text[at - 1])) continue;
    const auto equals = l->text.find_first_not_of(k_xml_blanks, at + name.size());
    if (equals != std::string::npos && l->text[equals] != '=') continue;
    // Continue after the value, whose text could look like an attribute.
    const auto quote = std::min(l->text.find_first_of("\"'", at), l->text.size());
    const auto close = quote < l->text.size() ? l->text.find(l->text[quote], quote + 1) : std::string::npos;
    l->cursor = close == std::string::npos ? at + name.size() : close + 1;
    return column_in(*l, at);
  }
  return 0;
}

}  // namespace nilas::scene
