#pragma once
/// The text form of STL.
#include <string>

#include "core/geometry/mesh.h"

namespace nilas::geometry {

/// Starts with the word solid and holds no zero byte.
bool looks_like_stl_text(const std::string& bytes);
/// One or more solids in one mesh, vertices welded. Throws InputError naming `file` and the line.
TriangleMesh parse_stl_text(const std::string& text, const std::string& file);

}  // namespace nilas::geometry
