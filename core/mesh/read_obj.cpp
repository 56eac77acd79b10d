/// Wavefront OBJ: vertices and polygon faces; groups, materials, normals, texture and lines are passed over.
#include <algorithm>
#include <array>

#include "core/bodies/mesh_words.h"
#include "core/mesh/soup_formats.h"

namespace nilas {

namespace {

constexpr std::array<std::string_view, 13> k_passed_over{"vn", "vt", "vp",     "g",      "o",   "s",     "mg",
                                                         "l",  "p",  "usemtl", "mtllib", "lod", "usemap"};

/// A corner such as 7, 7/1, 7//3 or -1 (the newest vertex). Counts from 1.
int corner(const MeshWords& words, std::string_view text, std::size_t points) {
  const long long index = words.integer(text.substr(0, text.find('/')));
  const long long count = static_cast<long long>(points);
  const long long place = index < 0 ? count + index : index - 1;
  if (index == 0 || place < 0 || place >= count)
    words.fail("the number of one of the " + std::to_string(count) + " vertices so far", text);
  return static_cast<int>(place);
}

/// The backslash at the end of a line joins it to the next; lines keep their count as the break becomes a blank.
std::string with_joined_lines(std::string text) {
  for (std::size_t at = text.find('\\'); at != std::string::npos; at = text.find('\\', at + 1)) {
    const std::size_t next = at + 1 < text.size() && text[at + 1] == '\r' ? at + 2 : at + 1;
    if (next < text.size() && text[next] == '\n')
      std::fill(text.begin() + static_cast<std::ptrdiff_t>(at), text.begin() + static_cast<std::ptrdiff_t>(next) + 1,
                ' ');
  }
  return text;
}

void read_face(MeshWords& words, PolygonSoup& soup) {
  auto& loop = soup.polygons.emplace_back();
  for (auto word = words.next_on_line(); !word.empty(); word = words.next_on_line())
    loop.push_back(corner(words, word, soup.points.size()));
  if (loop.size() < 3) words.fail("at least three corners of a face", std::to_string(loop.size()));
}

}  // namespace

PolygonSoup parse_obj(const std::string& text, const std::string& file) {
  PolygonSoup soup;
  const std::string joined = with_joined_lines(text);
  MeshWords words(joined, file, '#');
  for (auto word = words.next(); !word.empty(); word = words.next()) {
    if (word == "v") {
      Vec3 p;
      for (double& x : p) x = words.number(words.next_on_line());
      soup.points.push_back(p);
      words.skip_line();  // a weight or a colour may follow
    } else if (word == "f" || word == "fo") {
      read_face(words, soup);
    } else if (std::find(k_passed_over.begin(), k_passed_over.end(), word) != k_passed_over.end()) {
      words.skip_line();
    } else {
      words.fail("a statement of a polygon mesh (v, f, vn, vt, g, o, s, l, p, usemtl, mtllib)", word);
    }
  }
  return soup;
}

}  // namespace nilas
