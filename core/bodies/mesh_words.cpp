#include "core/bodies/mesh_words.h"

#include <algorithm>
#include <charconv>
#include <cmath>

#include "core/base/error.h"

namespace nilas {

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

void MeshWords::skip_blanks(bool within_line) {
  while (place_ < text_.size()) {
    if (comment_ != 0 && text_[place_] == comment_) skip_line();
    if (place_ >= text_.size() || !blank(text_[place_]) || (within_line && text_[place_] == '\n')) return;
    line_ += text_[place_++] == '\n';
  }
}

std::string_view MeshWords::word() {
  const std::size_t start = place_;
  while (place_ < text_.size() && !blank(text_[place_]) && (comment_ == 0 || text_[place_] != comment_)) ++place_;
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

void MeshWords::fail(const std::string& expected, std::string_view found) const {
  throw InputError(file_ + ":" + std::to_string(line_) + ": expected " + expected + ", found " +
                   (found.empty()
                        ? (place_ >= text_.size() ? "the end of the file: it is cut short" : "the end of the line")
                        : "'" + printable(found) + "'"));
}

}  // namespace nilas
