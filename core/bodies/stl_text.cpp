#include "core/bodies/stl_text.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <string_view>

#include "core/base/error.h"
#include "core/bodies/weld.h"

namespace nilas {

namespace {

constexpr std::string_view k_blank = " \t\r\n\v\f";

/// Words of the text, one after the other, with their line.
class Words {
 public:
  Words(std::string_view text, const std::string& file) : text_(text), file_(file) {}

  /// Next word as written, "" at the end.
  std::string_view next() {
    while (place_ < text_.size() && k_blank.find(text_[place_]) != std::string_view::npos)
      line_ += text_[place_++] == '\n';
    const std::size_t start = place_;
    while (place_ < text_.size() && k_blank.find(text_[place_]) == std::string_view::npos) ++place_;
    return text_.substr(start, place_ - start);
  }
  /// Next word in small letters: writers disagree on the case of keywords.
  std::string next_keyword() {
    std::string word(next());
    std::transform(word.begin(), word.end(), word.begin(),
                   [](char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c; });
    return word;
  }
  void expect(const std::string& keyword) {
    const std::string word = next_keyword();
    if (word != keyword) fail(keyword, word);
  }
  double number() {
    const std::string_view word = next();
    const std::string_view digits = word.substr(!word.empty() && word.front() == '+' ? 1 : 0);
    double x = 0;
    const auto [end, error] = std::from_chars(digits.data(), digits.data() + digits.size(), x);
    if (error == std::errc::invalid_argument || end != digits.data() + digits.size()) fail("a number", word);
    if (error != std::errc() || !std::isfinite(x)) fail("a finite number", word);
    return x;
  }
  void skip_line() { place_ = std::min(text_.find('\n', place_), text_.size()); }
  [[noreturn]] void fail(const std::string& expected, std::string_view found) const {
    throw InputError(file_ + ":" + std::to_string(line_) + ": expected " + expected + ", found " +
                     (found.empty() ? "the end of the file: it is cut short" : "'" + std::string(found) + "'"));
  }

 private:
  std::string_view text_;
  const std::string& file_;
  std::size_t place_ = 0;
  int line_ = 1;
};

/// After the word facet: normal, three vertices, endfacet. The normal is not used, so need not be a number.
std::array<Vec3, 3> read_facet(Words& words) {
  words.expect("normal");
  for (int i = 0; i < 3; ++i) words.next();
  words.expect("outer");
  words.expect("loop");
  std::array<Vec3, 3> corners;
  for (auto& corner : corners) {
    words.expect("vertex");
    for (int i = 0; i < 3; ++i) corner[i] = words.number();
  }
  words.expect("endloop");
  words.expect("endfacet");
  return corners;
}

}  // namespace

bool looks_like_stl_text(const std::string& bytes) {
  Words words(bytes, bytes);
  return words.next_keyword() == "solid" && bytes.find('\0') == std::string::npos;
}

TriangleMesh parse_stl_text(const std::string& text, const std::string& file) {
  Weld weld;
  Words words(text, file);
  for (std::string word = words.next_keyword(); !word.empty(); word = words.next_keyword()) {
    if (word != "solid") words.fail("solid", word);
    words.skip_line();  // the rest is a free name
    for (word = words.next_keyword(); word != "endsolid"; word = words.next_keyword()) {
      if (word != "facet") words.fail("facet or endsolid", word);
      weld.add(read_facet(words));
    }
    words.skip_line();
  }
  return weld.take();
}

}  // namespace nilas
