#include "core/output/text/fill_template.h"

#include <fmt/format.h>

#include <vector>

#include "core/base/error.h"
#include "core/output/text/html.h"

namespace nilas::output {

namespace {

using Json = nlohmann::ordered_json;

std::string in_gnuplot(const std::string& text) {
  std::string out;
  for (const char c : text) out += c == '\'' ? std::string("''") : c == '\n' ? std::string(" ") : std::string(1, c);
  return out;
}

std::string plain(const Json& value) {
  if (value.is_string()) return value.get<std::string>();
  if (value.is_number_float()) return fmt::format("{}", value.get<double>());
  return value.is_null() ? "" : value.dump();
}

bool holds(const Json& value) {
  if (value.is_string()) return !value.get_ref<const std::string&>().empty();
  return !value.is_null() && value != false && !(value.is_array() && value.empty());
}

struct Tag {
  enum class Kind { value, raw, section, inverted, end } kind = Kind::value;
  std::string name;
  std::size_t begin = 0, end = 0;  ///< positions in the text
};

class Filler {
 public:
  Filler(std::string_view text, const Json& data, Escape escape) : text_(text), escape_(escape), scopes_{&data} {}

  std::string fill() {
    std::string out;
    const std::size_t end = fill_from(0, "", out);
    if (end != text_.size()) throw ContractError("template: a section ends that did not begin");
    return out;
  }

 private:
  /// The next tag from a position on; an end tag at the end of the text if there is none.
  Tag next(std::size_t from) const {
    Tag tag;
    tag.begin = text_.find("{{", from);
    if (tag.begin == std::string_view::npos) return {Tag::Kind::end, "", text_.size(), text_.size()};
    const bool raw = text_.substr(tag.begin).starts_with("{{{");
    const std::string_view close = raw ? "}}}" : "}}";
    const std::size_t inside = tag.begin + close.size(), stop = text_.find(close, inside);
    if (stop == std::string_view::npos) throw ContractError("template: a tag is not closed");
    tag.name = std::string(text_.substr(inside, stop - inside));
    tag.end = stop + close.size();
    if (raw) tag.kind = Tag::Kind::raw;
    const std::string_view marks = "#^/";
    if (const auto mark = marks.find(tag.name.front()); !raw && mark != std::string_view::npos) {
      tag.kind = mark == 0 ? Tag::Kind::section : mark == 1 ? Tag::Kind::inverted : Tag::Kind::end;
      tag.name.erase(0, 1);
      take_line(tag);
    }
    return tag;
  }

  /// Extends a tag that is alone in its line to the whole line.
  void take_line(Tag& tag) const {
    std::size_t begin = tag.begin, end = tag.end;
    while (begin > 0 && text_[begin - 1] == ' ') --begin;
    while (end < text_.size() && text_[end] == ' ') ++end;
    const bool starts = begin == 0 || text_[begin - 1] == '\n', ends = end < text_.size() && text_[end] == '\n';
    if (!starts || !ends) return;
    tag.begin = begin;
    tag.end = end + 1;
  }

  /// Fills up to the end of the section `name`. Returns the position behind it.
  std::size_t fill_from(std::size_t from, const std::string& name, std::string& out) {
    for (;;) {
      const Tag tag = next(from);
      out += text_.substr(from, tag.begin - from);
      from = tag.end;
      if (tag.kind == Tag::Kind::end) {
        if (tag.name != name) throw ContractError("template: section '" + name + "' is not closed");
        return from;
      }
      if (tag.kind == Tag::Kind::section || tag.kind == Tag::Kind::inverted)
        from = section(tag, out);
      else
        out += tag.kind == Tag::Kind::raw ? plain(value(tag.name)) : escaped(plain(value(tag.name)));
    }
  }

  std::size_t section(const Tag& tag, std::string& out) {
    const Json& found = value(tag.name);
    if (holds(found) == (tag.kind == Tag::Kind::inverted)) return skip(tag);
    if (tag.kind == Tag::Kind::inverted) return fill_from(tag.end, tag.name, out);
    std::size_t end = tag.end;
    const auto once = [&](const Json& scope) {
      scopes_.push_back(&scope);
      end = fill_from(tag.end, tag.name, out);
      scopes_.pop_back();
    };
    if (found.is_array())
      for (const auto& element : found) once(element);
    else
      once(found);
    return end;
  }

  /// The position behind a section that is left out.
  std::size_t skip(const Tag& tag) const {
    std::size_t from = tag.end;
    for (int depth = 1; depth > 0;) {
      const Tag inner = next(from);
      if (inner.begin == text_.size()) throw ContractError("template: section '" + tag.name + "' is not closed");
      const bool opens = inner.kind == Tag::Kind::section || inner.kind == Tag::Kind::inverted;
      depth += opens ? 1 : inner.kind == Tag::Kind::end ? -1 : 0;
      from = inner.end;
    }
    return from;
  }

  const Json& value(const std::string& name) const {
    if (name == ".") return *scopes_.back();
    for (auto scope = scopes_.rbegin(); scope != scopes_.rend(); ++scope)
      if ((*scope)->is_object() && (*scope)->contains(name)) return (*scope)->at(name);
    throw ContractError("template: no value for '" + name + "'");
  }

  std::string escaped(const std::string& text) const {
    return escape_ == Escape::html ? html_text(text) : in_gnuplot(text);
  }

  std::string_view text_;
  Escape escape_;
  std::vector<const Json*> scopes_;
};

}  // namespace

std::string fill_template(std::string_view text, const Json& data, Escape escape) {
  return Filler(text, data, escape).fill();
}

}  // namespace nilas::output
