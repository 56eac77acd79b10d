#include <gtest/gtest.h>

#include <cstring>
#include <filesystem>
#include <limits>
#include <sstream>

#include "core/base/error.h"
#include "core/geometry/mesh.h"
#include "core/geometry/shape.h"
#include "tests/core/bodies/solids.h"
#include "tests/support/file_text.h"
#include "tests/support/refusal.h"
#include "tests/support/scratch_folder.h"
#include "tests/support/tetrahedron.h"

namespace nilas::geometry {
namespace stl_test {

namespace fs = std::filesystem;

class Stl : public testing::Test {
 protected:
  fs::path write(const std::string& bytes) const { return folder_.write("mesh.stl", bytes); }
  std::string binary(const TriangleMesh& mesh) const {
    write_stl(mesh, folder_ / "source.stl");
    return test::read_text(folder_ / "source.stl");
  }
  std::string fault(const std::string& bytes) const {
    return test::refusal([&] { read_stl(write(bytes)); });
  }

  test::ScratchFolder folder_;
};

std::string text_of(const TriangleMesh& mesh) {
  std::ostringstream out;
  out.precision(17);
  out << "solid a solid of facet and vertex\n";
  for (const auto& t : mesh.triangles) {
    out << "  facet normal nan 0 0\n    outer loop\n";
    for (const int v : t) out << "      vertex " << mesh.vertices[v].transpose() << "\r\n";
    out << "    endloop\n  endfacet\n";
  }
  out << "endsolid a solid of facet and vertex\n";
  return out.str();
}

/// Same triangles at the same places, whatever the numbering of the vertices.
void expect_same(const TriangleMesh& a, const TriangleMesh& b) {
  ASSERT_EQ(a.triangles.size(), b.triangles.size());
  EXPECT_EQ(a.vertices.size(), b.vertices.size());
  for (std::size_t t = 0; t < a.triangles.size(); ++t)
    for (std::size_t k = 0; k < 3; ++k) EXPECT_EQ(a.vertices[a.triangles[t][k]], b.vertices[b.triangles[t][k]]);
}

TEST_F(Stl, BinaryRoundTripGivesTheRoundedMesh) {
  const TriangleMesh mesh = bodies::moved(bodies::sphere_mesh(1.7, 3), Mat3::Identity(), {0.1, 0.2, 0.3});
  const std::string bytes = binary(mesh);
  EXPECT_EQ(bytes.size(), 84 + 50 * mesh.triangles.size());
  const TriangleMesh read = read_stl(write(bytes));
  expect_same(read, rounded_to_float(mesh));
  EXPECT_TRUE(find_defects(read).sound());
  EXPECT_TRUE(binary(read) == bytes);
}

TEST_F(Stl, WrittenNormalsAreThoseOfTheWinding) {
  const std::string bytes = binary(test::tetrahedron({0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}));
  std::array<float, 3> normal{};
  std::memcpy(normal.data(), bytes.data() + 84, sizeof normal);
  EXPECT_EQ(normal, (std::array<float, 3>{0, 0, -1}));
}

TEST_F(Stl, TextKeepsDoublePrecision) {
  const TriangleMesh mesh = bodies::moved(bodies::sphere_mesh(1.7, 2), Mat3::Identity(), {0.1, 0.2, 0.3});
  expect_same(read_stl(write(text_of(mesh))), mesh);
}

TEST_F(Stl, TextMayUseCapitalsPlusSignsAndSeveralSolids) {
  const std::string upper =
      "SOLID\nFACET NORMAL 0 0 1\nOUTER LOOP\nVERTEX +0 0 0\nVERTEX 1e0 0 0\nVERTEX 0 +1.0E+0 0\nENDLOOP\nENDFACET\n"
      "ENDSOLID\nsolid two\nfacet normal 0 0 1 outer loop vertex 0 0 0 vertex 0 1 0 vertex -1 0 0 endloop endfacet\n"
      "endsolid two";
  const TriangleMesh mesh = read_stl(write(upper));
  EXPECT_EQ(mesh.triangles.size(), 2u);
  EXPECT_EQ(mesh.vertices.size(), 4u);
}

TEST_F(Stl, ABinaryFileMayBeginWithTheWordSolid) {
  const TriangleMesh mesh = box_shape({1, 2, 3}).surface;
  std::string bytes = binary(mesh);
  std::memcpy(bytes.data(), "solid part", 10);
  expect_same(read_stl(write(bytes)), mesh);
}

TEST_F(Stl, MinusZeroIsZero) {
  TriangleMesh mesh = test::tetrahedron({0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1});
  // a corner of its own for the last triangle, at minus zero
  mesh.vertices.emplace_back(-0.0, -0.0, -0.0);
  for (int& v : mesh.triangles[3])
    if (v == 0) v = 4;
  EXPECT_FALSE(find_defects(mesh).closed());
  const TriangleMesh read = read_stl(write(binary(mesh)));
  EXPECT_EQ(read.vertices.size(), 4u);
  EXPECT_TRUE(find_defects(read).sound());
}

TEST_F(Stl, ATriangleThatWeldsToALineIsKeptAndReported) {
  TriangleMesh mesh = test::tetrahedron({0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1});
  mesh.vertices.emplace_back(1e-60, 0, 0);  // the origin in float32
  mesh.triangles.push_back({0, 4, 1});
  const TriangleMesh read = read_stl(write(binary(mesh)));
  EXPECT_EQ(read.triangles.size(), 5u);
  EXPECT_EQ(find_defects(read).degenerate_triangles, 1);
}

TEST_F(Stl, ACutFileNamesBothSizes) {
  const std::string bytes = binary(box_shape({1, 2, 3}).surface);
  ASSERT_EQ(bytes.size(), 684u);
  for (const std::string& wrong : {bytes.substr(0, 683), bytes.substr(0, 84), bytes + "x"}) {
    const std::string text = fault(wrong);
    EXPECT_NE(text.find("684 bytes"), std::string::npos) << text;
    EXPECT_NE(text.find("found " + std::to_string(wrong.size())), std::string::npos) << text;
    EXPECT_NE(text.find("mesh.stl"), std::string::npos) << text;
  }
  std::string named = bytes.substr(0, 600);
  std::memcpy(named.data(), "solid part", 10);
  EXPECT_NE(fault(named).find("found 600"), std::string::npos);
}

TEST_F(Stl, AWrongCountIsFound) {
  std::string bytes = binary(box_shape({1, 2, 3}).surface);
  for (const std::uint32_t count : {0u, 11u, 13u, 0xffffffffu}) {
    std::memcpy(bytes.data() + 80, &count, 4);
    EXPECT_NE(fault(bytes).find("promises " + std::to_string(count) + " triangles"), std::string::npos) << count;
  }
}

TEST_F(Stl, SomethingElseIsNotAnStl) {
  EXPECT_NE(fault("").find("0 bytes"), std::string::npos);
  EXPECT_NE(fault("<nilas/>").find("not an STL"), std::string::npos);
  EXPECT_NE(fault(std::string(84, '\0')).find("no triangles"), std::string::npos);
  EXPECT_NE(fault("solid empty\nendsolid empty\n").find("no triangles"), std::string::npos);
}

TEST_F(Stl, CoordinatesMustBeFinite) {
  const std::string bytes = binary(box_shape({1, 2, 3}).surface);
  for (const float bad : {std::numeric_limits<float>::quiet_NaN(), std::numeric_limits<float>::infinity()}) {
    std::string wrong = bytes;
    std::memcpy(wrong.data() + 84 + 50 * 4 + 12 + 8, &bad, 4);
    EXPECT_NE(fault(wrong).find("triangle 5 has a coordinate that is not finite"), std::string::npos) << fault(wrong);
  }
  for (const char* bad : {"nan", "inf", "1e999"}) {
    const std::string text = std::string("solid\nfacet normal 0 0 1\nouter loop\nvertex 0 0 ") + bad + "\n";
    EXPECT_NE(fault(text).find(":4: expected a finite number, found '"), std::string::npos) << fault(text);
  }
}

TEST_F(Stl, FaultsOfTextNameTheLine) {
  const std::string whole = text_of(test::tetrahedron({0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}));
  EXPECT_NE(fault("solid\nfacet normal 0 0 1\nouter loop\nvertex 0 0\nvertex 1 0 0\n").find(":5: expected a number"),
            std::string::npos);
  EXPECT_NE(fault("solid\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0x1\n").find(":4: expected a number, found '0x1'"),
            std::string::npos);
  // cut anywhere after the name, the text must not pass for a whole file
  for (std::size_t size = 40; size + 40 < whole.size(); size += 7)
    EXPECT_NE(fault(whole.substr(0, size)).find("expected"), std::string::npos) << size;
}

TEST_F(Stl, FilesThatCannotBeOpened) {
  EXPECT_THROW(read_stl(folder_ / "absent.stl"), FileError);
  EXPECT_THROW(read_stl(folder_.path()), FileError);
  EXPECT_THROW(write_stl(bodies::octahedron(), folder_ / "absent" / "mesh.stl"), FileError);
  EXPECT_THROW(write_stl(bodies::octahedron(), "/dev/full"), FileError);
}

TEST_F(Stl, CoordinatesBeyondFloatAreNotWritten) {
  EXPECT_THROW(
      write_stl(bodies::moved(bodies::octahedron(), 1e39 * Mat3::Identity(), Vec3::Zero()), folder_ / "big.stl"),
      InputError);
}

}  // namespace stl_test
}  // namespace nilas::geometry
