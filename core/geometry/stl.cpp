/// STL files: which of the two forms a file has, binary in and out. The text form is in stl_text.cpp.
#include <bit>
#include <cstdint>
#include <cstring>
#include <fstream>

#include "core/base/error.h"
#include "core/base/file_bytes.h"
#include "core/geometry/mesh.h"
#include "core/geometry/stl_text.h"
#include "core/geometry/weld.h"

namespace nilas::geometry {

namespace {

static_assert(std::endian::native == std::endian::little, "binary STL is little-endian, and is copied as it stands");

// 80 bytes of free text and the triangle count; per triangle a normal, three vertices and two spare bytes.
constexpr std::size_t k_text_bytes = 80, k_header_bytes = 84, k_triangle_bytes = 50, k_point_bytes = 12;

TriangleMesh parse_binary(const std::string& bytes, std::size_t count, const std::string& file) {
  Weld weld;
  for (std::size_t k = 0; k < count; ++k) {
    const char* triangle = bytes.data() + k_header_bytes + k * k_triangle_bytes;
    std::array<Vec3, 3> corners;
    for (std::size_t c = 0; c < 3; ++c) {
      Eigen::Vector3f x;
      std::memcpy(x.data(), triangle + k_point_bytes * (c + 1), k_point_bytes);
      if (!x.allFinite())
        throw InputError(file + ": triangle " + std::to_string(k + 1) + " has a coordinate that is not finite");
      corners[c] = x.cast<double>();
    }
    weld.add(corners);
  }
  return weld.take();
}

std::string wrong_size(const std::string& file, std::size_t found, std::uint32_t count) {
  if (found < k_header_bytes)
    return file + ": not an STL file: " + std::to_string(found) + " bytes, a binary STL has at least " +
           std::to_string(k_header_bytes);
  const std::size_t expected = k_header_bytes + k_triangle_bytes * std::size_t{count};
  return file + ": cut short or not an STL file: its header promises " + std::to_string(count) + " triangles, so " +
         std::to_string(expected) + " bytes, found " + std::to_string(found);
}

}  // namespace

TriangleMesh read_stl(const std::filesystem::path& file) {
  const std::string bytes = file_bytes(file);
  std::uint32_t count = 0;
  if (bytes.size() >= k_header_bytes) std::memcpy(&count, bytes.data() + k_text_bytes, sizeof count);
  TriangleMesh mesh;
  // The size decides: a binary file may begin with the word solid as well.
  if (bytes.size() >= k_header_bytes && bytes.size() == k_header_bytes + k_triangle_bytes * std::size_t{count})
    mesh = parse_binary(bytes, count, file.string());
  else if (looks_like_stl_text(bytes))
    mesh = parse_stl_text(bytes, file.string());
  else
    throw InputError(wrong_size(file.string(), bytes.size(), count));
  if (mesh.triangles.empty()) throw InputError(file.string() + ": holds no triangles");
  return mesh;
}

void write_stl(const TriangleMesh& mesh, const std::filesystem::path& file) {
  const auto count = static_cast<std::uint32_t>(mesh.triangles.size());
  std::string bytes(k_header_bytes, ' ');
  bytes.reserve(k_header_bytes + k_triangle_bytes * mesh.triangles.size());
  std::memcpy(bytes.data() + k_text_bytes, &count, sizeof count);
  const auto append = [&](const Vec3& p) {
    const Eigen::Vector3f x = p.cast<float>();
    if (!x.allFinite()) throw InputError(file.string() + ": a coordinate is too large for an STL file");
    std::array<char, k_point_bytes> raw{};
    std::memcpy(raw.data(), x.data(), k_point_bytes);
    bytes.append(raw.data(), k_point_bytes);
  };
  const TriangleMesh stored = rounded_to_float(mesh);  // normals of what the file holds, so that copies are equal
  for (const auto& t : stored.triangles) {
    const auto corner = [&](std::size_t k) -> const Vec3& { return stored.vertices[t[k]]; };
    append((corner(1) - corner(0)).cross(corner(2) - corner(0)).normalized());
    for (std::size_t k = 0; k < 3; ++k) append(corner(k));
    bytes.append(2, '\0');
  }
  std::ofstream out(file, std::ios::binary);
  if (!out) throw FileError(file.string() + ": cannot be opened for writing");
  out.write(bytes.data(), static_cast<std::streamsize>(bytes.size()));
  out.close();
  if (!out) throw FileError(file.string() + ": cannot be written completely");
}

}  // namespace nilas::geometry
