#include "core/geometry/mesh_words.h"

#include <algorithm>
#include <charconv>
#include <cmath>

#include "core/base/error.h"

namespace nilas::geometry {

namespace {

constexpr std::string_view k_blank = " \t\r\n\v\f";

bool blank(char c) { return k_blank.find(c) != std::string_view::npos; }

/// Random bytes must not turn a terminal upside down.
std::string printable(std::string_view found) {
  constexpr std::size_t k_longest = 40;
  std::string text(found.substr(0, k_longest));
  for (char& c : text)
    if (c < ' ' || c > '~') c = '?';
  return text + (found.size() > k_longest ? "..." : "");
}

}  // namespace

MeshWords::MeshWords(std::string_view text, const std::string& file, const WordRules& rules)
    : text_(text), file_(file), rules_(rules), line_(rules.first_line) {
  constexpr std::string_view k_mark = "\xEF\xBB\xBF";  // Windows programs put it before UTF-8
  if (line_ == 1 && text_.starts_with(k_mark)) place_ = k_mark.size();
}

std::size_t MeshWords::joint() const {
  if (!rules_.joined || text_[place_] != '\\') return 0;
  const std::string_view rest = text_.substr(place_ + 1);
  return rest.starts_with('\n') ? 2 : rest.starts_with("\r\n") ? 3 : 0;
}

void MeshWords::skip_blanks(bool within_line) {
  while (place_ < text_.size()) {
    if (rules_.comment != 0 && text_[place_] == rules_.comment) skip_line();
    if (place_ >= text_.size()) return;
    if (const std::size_t bytes = joint(); bytes > 0) {
      place_ += bytes;
      ++line_;
    } else if (!blank(text_[place_]) || (within_line && text_[place_] == '\n')) {
      return;
    } else {
      line_ += text_[place_++] == '\n';
    }
  }
}

std::string_view MeshWords::word() {
  const std::size_t start = place_;
  const auto goes_on = [&](char c) { return !blank(c) && (rules_.comment == 0 || c != rules_.comment); };
  while (place_ < text_.size() && goes_on(text_[place_]) && joint() == 0) ++place_;
  return text_.substr(start, place_ - start);
}

std::string_view MeshWords::next() {
  skip_blanks(false);
  return word();
}

std::string_view MeshWords::next_on_line() {
  skip_blanks(true);
  return word();
}

std::string MeshWords::next_keyword() {
  std::string text(next());
  std::transform(text.begin(), text.end(), text.begin(),
                 [](char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c; });
  return text;
}

void MeshWords::expect(const std::string& keyword) {
  const std::string found = next_keyword();
  if (found != keyword) fail(keyword, found);
}

double MeshWords::number(std::string_view text) const {
  const std::string_view digits = text.substr(!text.empty() && text.front() == '+' ? 1 : 0);
  double x = 0;
  const auto [end, error] = std::from_chars(digits.data(), digits.data() + digits.size(), x);
  if (error == std::errc::invalid_argument || end != digits.data() + digits.size()) fail("a number", text);
  if (error != std::errc() || !std::isfinite(x)) fail("a finite number", text);
  return x;
}

long long MeshWords::integer(std::string_view text) const {
  long long n = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), n);
  if (error != std::errc() || end != text.data() + text.size()) fail("a whole number", text);
  return n;
}

void MeshWords::skip_line() { place_ = std::min(text_.find('\n', place_), text_.size()); }

void MeshWords::skip_joined_lines() {
  while (!next_on_line().empty()) {
  }
}

void MeshWords::fail(const std::string& expected, std::string_view found) const {
  throw InputError(file_ + ":" + std::to_string(line_) + ": expected " + expected + ", found " +
                   (found.empty()
                        ? (place_ >= text_.size() ? "the end of the file: it is cut short" : "the end of the line")
                        : "'" + printable(found) + "'"));
}

}  // namespace nilas::geometry
