/// Wavefront OBJ: vertices and polygon faces; groups, materials, normals, texture, lines and whatever else are passed
/// over.
#include <algorithm>
#include <array>

#include "core/geometry/mesh_words.h"
#include "core/mesh/mend/soup_formats.h"

namespace nilas::mesh {

namespace {

/// Statements with free text, in which a backslash means itself.
constexpr std::array<std::string_view, 8> k_named{"g", "o", "usemtl", "mtllib", "usemap", "maplib", "call", "csh"};

bool is_keyword(std::string_view word) {
  return std::all_of(word.begin(), word.end(),
                     [](char c) {
                       return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '_';
                     }) &&
         !(word.front() >= '0' && word.front() <= '9');
}

/// Other statements say nothing about polygons, and no list of them is complete.
void pass_over(geometry::MeshWords& words, std::string_view keyword) {
  if (!is_keyword(keyword)) words.fail("a statement such as v or f", keyword);
  if (std::find(k_named.begin(), k_named.end(), keyword) != k_named.end())
    words.skip_line();
  else
    words.skip_joined_lines();
}

/// A corner such as 7, 7/1, 7//3 or -1 (the newest vertex). Counts from 1.
int corner(const geometry::MeshWords& words, std::string_view text, std::size_t points) {
  const long long index = words.integer(text.substr(0, text.find('/')));
  const long long count = static_cast<long long>(points);
  const long long place = index < 0 ? count + index : index - 1;
  if (index == 0 || place < 0 || place >= count)
    words.fail("the number of one of the " + std::to_string(count) + " vertices so far", text);
  return static_cast<int>(place);
}

void read_obj_face(geometry::MeshWords& words, PolygonSoup& soup) {
  auto& loop = soup.polygons.emplace_back();
  for (auto word = words.next_on_line(); !word.empty(); word = words.next_on_line())
    loop.push_back(corner(words, word, soup.points.size()));
  if (loop.size() < 3) words.fail("at least three corners of a face", std::to_string(loop.size()));
}

}  // namespace

PolygonSoup parse_obj(const std::string& text, const std::string& file) {
  PolygonSoup soup;
  geometry::MeshWords words(text, file, {.comment = '#', .joined = true});
  for (auto word = words.next(); !word.empty(); word = words.next()) {
    if (word == "v") {
      Vec3 p;
      for (double& x : p) x = words.number(words.next_on_line());
      soup.points.push_back(p);
      words.skip_joined_lines();  // a weight or a colour may follow
    } else if (word == "f" || word == "fo") {
      read_obj_face(words, soup);
    } else {
      pass_over(words, word);
    }
  }
  return soup;
}

}  // namespace nilas::mesh
