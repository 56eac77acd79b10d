#include "core/scene/document/xml_syntax.h"

#include <algorithm>
#include <vector>

#include "core/scene/document/source_columns.h"

namespace nilas::scene {

namespace {

/// Walks over the tags of a text and keeps the elements that are open.
class TagWalk {
 public:
  TagWalk(const std::string& text, const std::string& file) : text_(text), file_(file) {}

  std::optional<Fault> first_fault() {
    for (auto at = text_.find('<'); at != std::string::npos; at = text_.find('<', at)) {
      const auto end = end_of(at);
      if (end == std::string::npos)
        return fault(at, "the file ends inside this tag; it is cut short, or a '>' or a quote is missing");
      if (auto wrong = take(at, end)) return wrong;
      at = end;
    }
    if (open_.empty()) return std::nullopt;
    return fault(open_.back(), "<" + name_at(open_.back() + 1) + "> is never closed; the file is cut short, or </" +
                                   name_at(open_.back() + 1) + "> is missing");
  }

  /// The first tag with more attributes than any element has.
  std::optional<Fault> first_crowded() const {
    constexpr int k_most_attributes = 1000;
    for (auto at = text_.find('<'); at != std::string::npos; at = text_.find('<', at)) {
      const auto end = std::min(end_of(at), text_.size());
      const bool is_element = at + 1 < text_.size() && text_[at + 1] != '!' && text_[at + 1] != '?';
      const auto from = text_.begin() + static_cast<std::ptrdiff_t>(at);
      if (is_element && std::count(from, text_.begin() + static_cast<std::ptrdiff_t>(end), '=') > k_most_attributes)
        return fault(at, "the tag has more than " + std::to_string(k_most_attributes) + " attributes");
      at = end;
    }
    return std::nullopt;
  }

 private:
  /// One past the '>' of the markup that begins at `at`.
  std::size_t end_of(std::size_t at) const {
    if (text_.compare(at, 4, "<!--") == 0) return behind("-->", at + 4);
    if (text_.compare(at, 9, "<![CDATA[") == 0) return behind("]]>", at);
    if (text_.compare(at, 2, "<?") == 0) return behind("?>", at);
    char quote = 0;
    for (auto i = at; i < text_.size(); ++i) {
      const char c = text_[i];
      if (quote != 0)
        quote = c == quote ? char{0} : quote;
      else if (c == '"' || c == '\'')
        quote = c;
      else if (c == '>')
        return i + 1;
    }
    return std::string::npos;
  }

  std::size_t behind(const std::string& closing, std::size_t from) const {
    const auto at = text_.find(closing, from);
    return at == std::string::npos ? at : at + closing.size();
  }

  std::optional<Fault> take(std::size_t at, std::size_t end) {
    const char kind = text_[at + 1];
    if (kind == '!' || kind == '?') return std::nullopt;
    if (kind != '/') {
      if (text_[end - 2] != '/') open_.push_back(at);
      return std::nullopt;
    }
    const std::string name = name_at(at + 2);
    if (open_.empty()) return fault(at, "</" + name + "> closes nothing");
    const std::string expected = name_at(open_.back() + 1);
    if (name != expected)
      return fault(at, "found </" + name + ">; allowed: </" + expected + ">, since the <" + expected + "> of line " +
                           std::to_string(line_of(open_.back())) + " is open");
    open_.pop_back();
    return std::nullopt;
  }

  std::string name_at(std::size_t at) const {
    const auto end = std::min(text_.find_first_of(" \t\r\n/><", at), text_.size());
    return text_.substr(at, end - at);
  }

  int line_of(std::size_t at) const {
    return 1 + static_cast<int>(std::count(text_.begin(), text_.begin() + static_cast<std::ptrdiff_t>(at), '\n'));
  }

  Fault fault(std::size_t at, const std::string& message) const {
    const auto start = at == 0 ? std::string::npos : text_.rfind('\n', at - 1);
    const auto first = start == std::string::npos ? 0 : start + 1;
    const std::string name = name_at(text_[at + 1] == '/' ? at + 2 : at + 1);
    return {file_, line_of(at), column_of(text_.substr(first), at - first), "<" + name + ">", message};
  }

  const std::string& text_;
  const std::string& file_;
  std::vector<std::size_t> open_;  ///< offsets of the '<' of open elements
};

}  // namespace

std::optional<Fault> size_fault(const std::string& text, const std::string& file) {
  constexpr std::size_t k_most_bytes_of_scene = std::size_t{64} << 20;
  constexpr std::ptrdiff_t k_most_tags = 1'000'000;
  if (text.size() > k_most_bytes_of_scene) return Fault{file, 0, 0, "", "the file has more than 64 MB"};
  if (std::count(text.begin(), text.end(), '<') > k_most_tags)
    return Fault{file, 0, 0, "", "the file has more than " + std::to_string(k_most_tags) + " tags"};
  return TagWalk(text, file).first_crowded();
}

std::optional<Fault> tag_fault(const std::string& text, const std::string& file) {
  return TagWalk(text, file).first_fault();
}

}  // namespace nilas::scene
