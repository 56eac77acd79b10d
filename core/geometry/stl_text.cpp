#include "core/geometry/stl_text.h"

#include "core/geometry/mesh_words.h"
#include "core/geometry/weld.h"

namespace nilas::geometry {

namespace {

/// Reads the rest of a facet after that word: normal, three vertices, endfacet. The normal is not used, so it need not
/// be a number.
std::array<Vec3, 3> read_facet(MeshWords& words) {
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
  MeshWords words(bytes, bytes);
  return words.next_keyword() == "solid" && bytes.find('\0') == std::string::npos;
}

TriangleMesh parse_stl_text(const std::string& text, const std::string& file) {
  Weld weld;
  MeshWords words(text, file);
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

}  // namespace nilas::geometry
