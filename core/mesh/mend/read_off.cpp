/// Object file format: a line of counts, a line per vertex, a line per face; normals and colours are passed over.
#include <algorithm>

#include "core/geometry/mesh_words.h"
#include "core/mesh/mend/soup_formats.h"

namespace nilas::mesh {

namespace {

/// Counts are only promises: each element takes at least two bytes, so a file cannot hold more than its size.
std::size_t count(const geometry::MeshWords& words, std::string_view word, const std::string& text) {
  const long long n = words.integer(word);
  if (n < 0 || static_cast<unsigned long long>(n) > text.size())
    words.fail("a count that a file of " + std::to_string(text.size()) + " bytes can hold", word);
  return static_cast<std::size_t>(n);
}

/// The word after the keyword, which may be left out.
std::string_view after_header(geometry::MeshWords& words) {
  const std::string_view word = words.next();
  if (!word.empty() && word.find_first_not_of("0123456789") == std::string_view::npos) return word;
  // coordinates come first whatever follows them
  constexpr std::string_view k_known[] = {"OFF", "COFF", "NOFF", "CNOFF", "STOFF", "STCOFF", "STNOFF", "STCNOFF"};
  if (std::find(std::begin(k_known), std::end(k_known), word) == std::end(k_known)) words.fail("OFF", word);
  const std::string_view first = words.next();
  if (first == "BINARY") words.fail("the text form of OFF", first);
  return first;
}

void read_off_face(geometry::MeshWords& words, PolygonSoup& soup) {
  const auto corners = words.next();
  const long long n = words.integer(corners);
  if (n < 3) words.fail("at least three corners of a face", corners);
  auto& loop = soup.polygons.emplace_back();
  for (long long k = 0; k < n; ++k) {
    const auto word = words.next_on_line();
    const long long index = words.integer(word);
    if (index < 0 || index >= static_cast<long long>(soup.points.size()))
      words.fail("the number of a vertex, 0 to " + std::to_string(soup.points.size() - 1), word);
    loop.push_back(static_cast<int>(index));
  }
  words.skip_line();
}

}  // namespace

PolygonSoup parse_off(const std::string& text, const std::string& file) {
  PolygonSoup soup;
  geometry::MeshWords words(text, file, {.comment = '#'});
  const std::size_t vertices = count(words, after_header(words), text), faces = count(words, words.next(), text);
  words.integer();  // edges, which nobody needs
  for (std::size_t v = 0; v < vertices; ++v) {
    Vec3 p;
    p[0] = words.number();
    for (int k = 1; k < 3; ++k) p[k] = words.number(words.next_on_line());
    soup.points.push_back(p);
    words.skip_line();
  }
  for (std::size_t f = 0; f < faces; ++f) read_off_face(words, soup);
  return soup;
}

}  // namespace nilas::mesh
