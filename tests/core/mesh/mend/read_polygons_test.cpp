/// Mesh files of every format: read right, and refused with the line when broken.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cstring>

#include "core/base/error.h"
#include "core/base/random.h"
#include "core/mesh/mend/polygon_soup.h"
#include "tests/core/mesh/hull_shapes.h"
#include "tests/support/scratch_folder.h"

namespace nilas::mesh {
namespace read_polygons_test {

using test::ScratchFolder;

template <class T>
void append(std::string& bytes, T value, bool swapped = false) {
  std::array<char, sizeof value> raw{};
  std::memcpy(raw.data(), &value, sizeof value);
  if (swapped) std::reverse(raw.begin(), raw.end());
  bytes.append(raw.data(), raw.size());
}

std::string obj_text(const PolygonSoup& soup) {
  std::string text = "# a hull\nmtllib x.mtl\no hull\n";
  for (const auto& p : soup.points) text += fmt::format("v {:.9g} {:.9g} {:.9g}\n", p.x(), p.y(), p.z());
  text += "vn 0 0 1\nusemtl steel\n";
  for (const auto& loop : soup.polygons) {
    text += "f";
    for (const int v : loop) text += fmt::format(" {}//1", v + 1);
    text += "\n";
  }
  return text;
}

std::string off_text(const PolygonSoup& soup) {
  std::string text = fmt::format("OFF\n# a hull\n{} {} 0\n", soup.points.size(), soup.polygons.size());
  for (const auto& p : soup.points) text += fmt::format("{:.9g} {:.9g} {:.9g}\n", p.x(), p.y(), p.z());
  for (const auto& loop : soup.polygons) {
    text += std::to_string(loop.size());
    for (const int v : loop) text += " " + std::to_string(v);
    text += " 255 0 0\n";
  }
  return text;
}

std::string stl_text(const PolygonSoup& soup) {
  std::string text = "solid hull\n";
  for (const auto& t : soup.polygons) {
    text += "facet normal 0 0 0\nouter loop\n";
    for (const int v : t) {
      const Vec3& p = soup.points[v];
      text += fmt::format("vertex {:.9g} {:.9g} {:.9g}\n", p.x(), p.y(), p.z());
    }
    text += "endloop\nendfacet\n";
  }
  return text + "endsolid hull\n";
}

std::string ply_header(const PolygonSoup& soup, const std::string& format) {
  return fmt::format(
      "ply\nformat {} 1.0\ncomment a hull\nelement vertex {}\nproperty double x\nproperty double y\nproperty double z\n"
      "property uchar red\nelement face {}\nproperty list uchar int vertex_indices\nend_header\n",
      format, soup.points.size(), soup.polygons.size());
}

std::string ply_text(const PolygonSoup& soup) {
  std::string text = ply_header(soup, "ascii");
  for (const auto& p : soup.points) text += fmt::format("{:.9g} {:.9g} {:.9g} 7\n", p.x(), p.y(), p.z());
  for (const auto& loop : soup.polygons) {
    text += std::to_string(loop.size());
    for (const int v : loop) text += " " + std::to_string(v);
    text += "\n";
  }
  return text;
}

std::string ply_binary(const PolygonSoup& soup, bool big) {
  std::string bytes = ply_header(soup, big ? "binary_big_endian" : "binary_little_endian");
  for (const auto& p : soup.points) {
    for (const double x : p) append(bytes, x, big);
    append(bytes, std::uint8_t{7});
  }
  for (const auto& loop : soup.polygons) {
    append(bytes, static_cast<std::uint8_t>(loop.size()));
    for (const int v : loop) append(bytes, v, big);
  }
  return bytes;
}

std::string stl_binary(const PolygonSoup& soup) {
  std::string bytes(80, ' ');
  append(bytes, static_cast<std::uint32_t>(soup.polygons.size()));
  for (const auto& t : soup.polygons) {
    for (int k = 0; k < 3; ++k) append(bytes, 0.0f);
    for (const int v : t)
      for (const double x : soup.points[v]) append(bytes, static_cast<float>(x));
    append(bytes, std::uint16_t{0});
  }
  return bytes;
}

struct Sample {
  std::string name, bytes;
};

std::vector<Sample> samples() {
  const PolygonSoup soup = soup_of({moonpool_mesh()});
  return {{"a.obj", obj_text(soup)},          {"a.off", off_text(soup)},    {"text.stl", stl_text(soup)},
          {"binary.stl", stl_binary(soup)},   {"text.ply", ply_text(soup)}, {"little.ply", ply_binary(soup, false)},
          {"big.PLY", ply_binary(soup, true)}};
}

/// "" where the file is taken, else the message of the InputError; any other error fails the test.
std::string refusal(const ScratchFolder& folder, const std::string& name, const std::string& bytes) {
  const auto file = folder.write(name, bytes);
  try {
    const PolygonSoup soup = read_polygons(file);
    for (const auto& p : soup.points) EXPECT_TRUE(p.allFinite()) << name;
    for (const auto& loop : soup.polygons)
      for (const int v : loop) EXPECT_TRUE(v >= 0 && static_cast<std::size_t>(v) < soup.points.size()) << name;
    return "";
  } catch (const InputError& e) {
    EXPECT_NE(std::string(e.what()).find(file.string()), std::string::npos) << e.what();
    return e.what();
  }
}

TEST(ReadPolygons, EveryFormatGivesTheSameSolid) {
  const ScratchFolder folder;
  for (const auto& sample : samples()) {
    const PolygonSoup soup = read_polygons(folder.write(sample.name, sample.bytes));
    geometry::TriangleMesh mesh{soup.points, {}};
    for (const auto& t : soup.polygons) mesh.triangles.push_back({t.at(0), t.at(1), t.at(2)});
    EXPECT_EQ(mesh.triangles.size(), moonpool_mesh().triangles.size()) << sample.name;
    EXPECT_NEAR(geometry::signed_volume(mesh), k_moonpool_volume, 1e-7) << sample.name;
  }
}

TEST(ReadPolygons, FacesOfManyCornersAndObjsOwnWays) {
  const ScratchFolder folder;
  const auto soup = read_polygons(folder.write("q.obj",
                                               "v 0 0 0 1.0\nv 1 0 0\nv 1 1 0 # corner\nv 0 1 0\n"
                                               "f 1/1/1 2 3 \\\n 4\nf -4 -3 -2\ns off\nl 1 2\n"));
  ASSERT_EQ(soup.polygons.size(), 2u);
  EXPECT_EQ(soup.polygons[0], (std::vector<int>{0, 1, 2, 3}));
  EXPECT_EQ(soup.polygons[1], (std::vector<int>{0, 1, 2}));
}

TEST(ReadPolygons, BackslashesJoinStatementsOnly) {
  const ScratchFolder folder;
  const std::string corners = "v 0 0 0\nv 1 0 0\nv 0 1 0\n";
  for (const char* line :
       {"# C:\\models\\\n", "g C:\\models\\\n", "usemtl steel\\\n", "l 1 2 \\\n 3\n", "vn 0\\\r\n0 1\n"})
    EXPECT_EQ(read_polygons(folder.write("q.obj", corners + line + "f 1 2 3\nf 3 2 \\\n1\n")).polygons.size(), 2u)
        << line;
  const std::string text = refusal(folder, "line.obj", corners + "f 1 2 \\\n3\nf 1 2 9\n");
  EXPECT_NE(text.find("line.obj:6: "), std::string::npos) << text;
}

TEST(ReadPolygons, WhatOtherProgramsWriteIsTaken) {
  const ScratchFolder folder;
  const std::string corners = "v 0 0 0\nv 1 0 0\nv 0 1 0\n", face = "f 1 2 3\n";
  const std::string ply =
      "element vertex 3\nproperty float x\nproperty float y\nproperty float z\nelement face 1\n"
      "property list uchar int vertex_index\nend_header\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n";
  const std::string off = "3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n", mark = "\xEF\xBB\xBF";
  for (const auto& [name, bytes] : std::vector<Sample>{
           {"mark.obj", mark + corners + face},
           {"mark.off", mark + "OFF\n" + off},
           {"more.obj", "maplib x\nbevel on\nc_interp off\nparm u 0 1 \\\n 2 3\n" + corners + face},
           {"none.off", off},
           {"comment.ply", "ply\nformat ascii 1.0\ncomment end_header is below\nobj_info\nend_headers\n" + ply}}) {
    if (name == "comment.ply") {
      EXPECT_NE(refusal(folder, name, bytes).find("comment.ply:5: "), std::string::npos);
      EXPECT_EQ(refusal(folder, name, std::string(bytes).erase(bytes.find("end_headers\n"), 12)), "");
    } else {
      EXPECT_EQ(refusal(folder, name, bytes), "");
    }
  }
  EXPECT_NE(refusal(folder, "form.ply", "ply\n" + ply).find("expected format"), std::string::npos);
  EXPECT_NE(refusal(folder, "form.off", "OFF BINARY\n" + off).find("the text form of OFF"), std::string::npos);
}

TEST(ReadPolygons, FaultsOfBinaryFilesNameTheElement) {
  const ScratchFolder folder;
  std::string bytes = ply_binary(soup_of({moonpool_mesh()}), false);
  const std::string cut = refusal(folder, "cut.ply", bytes.substr(0, bytes.size() - 1));
  const std::size_t last = moonpool_mesh().triangles.size() - 1;
  EXPECT_NE(cut.find(fmt::format("face {} (from 0), byte ", last)), std::string::npos) << cut;
}

TEST(ReadPolygons, FaultsAreNamedWithTheirLine) {
  const ScratchFolder folder;
  const auto expect = [&](const std::string& name, const std::string& bytes, const std::string& part) {
    const std::string text = refusal(folder, name, bytes);
    EXPECT_NE(text.find(part), std::string::npos) << name << ": " << text;
  };
  expect("index.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 4\n", ".obj:4: ");
  expect("zero.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 0 1 2\n", ".obj:4: ");
  expect("before.obj", "v 0 0 0\nf -2 -1 -1\n", ".obj:2: ");
  expect("nan.obj", "v 0 nan 0\n", ".obj:1: expected a finite number, found 'nan'");
  expect("none.obj", "v 0 0 0\n", "holds no polygons");
  expect("edge.obj", "v 0 0 0\nv 1 0 0\nf 1 2\n", "three corners");
  expect("index.off", "OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 3\n", ".off:6: ");
  expect("minus.off", "OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 -1\n", ".off:6: ");
  expect("count.off", "OFF\n4000000000 1 0\n0 0 0\n", ".off:2: ");
  expect("corners.off", "OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n4000000000 0 1 2\n", "end of the line");
  expect("inf.off", "OFF\n3 1 0\n0 0 inf\n", ".off:3: ");
  const std::string head = "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\n";
  expect("flat.ply", head + "element face 1\nproperty list uchar int vertex_indices\nend_header\n", "property z");
  const std::string full =
      head + "property float z\nelement face 1\nproperty list uchar int vertex_index\nend_header\n";
  expect("index.ply", full + "0 0 0\n1 0 0\n0 1 0\n3 0 1 3\n", ".ply:13: ");
  expect("nan.ply", full + "0 0 nan\n", ".ply:10: ");
  std::string many = ply_binary(soup_of({moonpool_mesh()}), false);
  many.replace(many.find("vertex 16"), 9, "vertex 4000000000");
  expect("many.ply", many, "cut short");
  expect("many.stl", stl_binary(soup_of({moonpool_mesh()})).replace(80, 4, "\xff\xff\xff\xee"), "4009754623");
  expect("ship.step", "ISO-10303-21;", "allowed: .stl, .obj, .off, .ply");
  EXPECT_THROW(read_polygons(folder / "absent.obj"), FileError);
  EXPECT_THROW(read_polygons(folder / "absent.stl"), FileError);
}

TEST(ReadPolygons, FilesCutShortAnywhereAreRefusedOrWhole) {
  const ScratchFolder folder;
  for (const auto& sample : samples()) {
    const std::size_t stride = 1 + sample.bytes.size() / 150;
    for (std::size_t length = 0; length < sample.bytes.size(); length += stride) {
      const std::string text = refusal(folder, sample.name, sample.bytes.substr(0, length));
      // an OBJ has no counts: any of its lines may be the last, and any digit; so may an STL's last line break
      if (sample.name != "a.obj" && length + 12 < sample.bytes.size()) {
        EXPECT_NE(text, "") << sample.name << " of " << length << " bytes";
      }
    }
  }
}

TEST(ReadPolygons, ChangedAndRandomBytesNeverPassUnseen) {
  const ScratchFolder folder;
  RandomStream random(20261122, "broken mesh files");
  int refused = 0;
  for (const auto& sample : samples())
    for (int k = 0; k < 120; ++k) {
      std::string bytes = sample.bytes;
      const int changes = 1 + static_cast<int>(random.uniform(0, 20));
      for (int c = 0; c < changes; ++c)
        bytes[static_cast<std::size_t>(random.uniform(0, static_cast<double>(bytes.size())))] =
            static_cast<char>(random.uniform(0, 256));
      if (k % 10 == 0)
        for (char& c : bytes) c = static_cast<char>(random.uniform(0, 256));
      const bool no = !refusal(folder, sample.name, bytes).empty();
      refused += no;
      EXPECT_TRUE(no || k % 10 != 0) << sample.name << ": random bytes were taken for a mesh";
    }
  EXPECT_GT(refused, 300);
}

}  // namespace read_polygons_test
}  // namespace nilas::mesh
