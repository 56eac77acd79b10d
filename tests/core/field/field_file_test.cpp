#include <gtest/gtest.h>

#include <filesystem>

#include "core/base/error.h"
#include "core/field/field.h"
#include "core/field/sizes/floe_property.h"
#include "tests/support/mentions.h"
#include "tests/support/refusal.h"
#include "tests/support/scratch_folder.h"

namespace nilas::field {
namespace field_file_test {

namespace fs = std::filesystem;

class FieldFile : public testing::Test {
 protected:
  fs::path written(const std::string& text) const { return folder_.write("field.json", text); }
  /// A file whose second feature has the given geometry and properties.
  fs::path with_second(const std::string& geometry, const std::string& properties = "{}") const {
    const std::string square = R"({"type":"Polygon","coordinates":[[[0,0],[1,0],[1,1],[0,1],[0,0]]]})";
    return written(R"({"type":"FeatureCollection","features":[{"type":"Feature","properties":{},"geometry":)" + square +
                   R"(},{"type":"Feature","properties":)" + properties + R"(,"geometry":)" + geometry + "}]}");
  }
  static std::string refusal(const fs::path& file) {
    return test::refusal([&] { read_field(file); });
  }

  test::ScratchFolder folder_;
};

using test::mentions;

TEST_F(FieldFile, RoundTripKeepsEveryBit) {
  PackedSpec spec;
  spec.high = {9, 7};
  spec.concentration = 0.7;
  FieldResult field = pack_field(spec);
  field.floes[0].thickness = 0.1 + 0.2;
  field.floes[1].density = 917.3;
  field.floes[2].flexural_strength = 4e4 / 3;
  field.floes[2].compressive_strength = 1e5 / 7;
  field.floes[3].fracture_toughness = 3e3 / 11;
  write_field(field, folder_ / "f.json");
  const FieldResult read = read_field(folder_ / "f.json");
  ASSERT_EQ(read.floes.size(), field.floes.size());
  for (std::size_t i = 0; i < field.floes.size(); ++i) {
    EXPECT_EQ(read.floes[i].outline, field.floes[i].outline);
    for (const FloeProperty property : k_floe_properties)
      EXPECT_EQ(value_of(read.floes[i], property), value_of(field.floes[i], property)) << name_of(property);
  }
  EXPECT_EQ(read.concentration, field.concentration);
  EXPECT_EQ(read.worst_overlap, 0);
}

TEST_F(FieldFile, WeakLinesGoRoundAndAreChecked) {
  PackedSpec spec;
  spec.high = {6, 5};
  const FieldResult field = frozen_field(spec, -Vec2::UnitX(), 0.1 + 0.2);
  ASSERT_FALSE(field.weak_lines.empty());
  write_field(field, folder_ / "f.json");
  const FieldResult read = read_field(folder_ / "f.json");
  ASSERT_EQ(read.weak_lines.size(), field.weak_lines.size());
  for (std::size_t i = 0; i < field.weak_lines.size(); ++i) {
    EXPECT_EQ(read.weak_lines[i].points, field.weak_lines[i].points);
    EXPECT_EQ(read.weak_lines[i].strength, field.weak_lines[i].strength);
  }
  ASSERT_EQ(read.floes.size(), 1u);
  const std::string line = R"({"type":"LineString","coordinates":[[0,0],[1,1]]})";
  EXPECT_EQ(refusal(with_second(line, R"({"strength":0.5})")), "accepted");
  EXPECT_TRUE(mentions(refusal(with_second(line)), "feature 2: strength of a weak line"));
  EXPECT_TRUE(mentions(refusal(with_second(line, R"({"strength":1.5})")), "> 0 and <= 1"));
  EXPECT_TRUE(mentions(refusal(with_second(R"({"type":"LineString","coordinates":[[0,0]]})", R"({"strength":1})")),
                       "two points or more"));
}

TEST_F(FieldFile, ClockwiseRingsAreTurned) {
  const auto field = read_field(with_second(R"({"type":"Polygon","coordinates":[[[3,0],[3,1],[4,1],[4,0],[3,0]]]})"));
  const auto& outline = field.floes[1].outline;
  ASSERT_EQ(outline.size(), 4u);
  const Vec2 a = outline[1] - outline[0], b = outline[2] - outline[1];
  EXPECT_GT(a.x() * b.y() - a.y() * b.x(), 0);
}

/// The second square overlaps the first by 0.25 m; a concave floe that wraps around a square does not.
TEST_F(FieldFile, OverlapIsMeasured) {
  const std::string shifted = R"({"type":"Polygon","coordinates":[[[0.75,0],[1.75,0],[1.75,1],[0.75,1],[0.75,0]]]})";
  EXPECT_DOUBLE_EQ(read_field(with_second(shifted)).worst_overlap, 0.25);
  const std::string wrapped = R"({"type":"Polygon","coordinates":[[[-1,-1],[2,-1],[2,2],[1.5,2],[1.5,-0.5],)"
                              R"([-0.5,-0.5],[-0.5,2],[-1,2],[-1,-1]]]})";
  EXPECT_EQ(read_field(with_second(wrapped)).worst_overlap, 0);
}

TEST_F(FieldFile, FaultsNameFileAndFeature) {
  const auto wrong = [&](const std::string& geometry, const std::string& properties = "{}") {
    return refusal(with_second(geometry, properties));
  };
  const std::string good = R"({"type":"Polygon","coordinates":[[[3,0],[4,0],[4,1],[3,0]]]})";
  EXPECT_EQ(wrong(good), "accepted");
  EXPECT_PRED2(mentions, wrong(R"({"type":"Point","coordinates":[1,2]})"),
               "field.json: feature 2: geometry type: found \"Point\"");
  EXPECT_PRED2(mentions, wrong(R"({"type":"Polygon","coordinates":[[[3,0],[4,0],[4,1]]]})"),
               "feature 2: found 3 points");
  EXPECT_PRED2(mentions, wrong(R"({"type":"Polygon","coordinates":[[[3,0],[4,0],[4,1],[3,1]]]})"), "not closed");
  EXPECT_PRED2(mentions, wrong(R"({"type":"Polygon","coordinates":[[[3,0],[4,1],[4,0],[3,1],[3,0]]]})"), "crosses");
  EXPECT_PRED2(mentions, wrong(R"({"type":"Polygon","coordinates":[[[3,0],["x",0],[4,1],[3,0]]]})"),
               "point 2: found [\"x\",0]");
  EXPECT_PRED2(mentions, wrong(R"({"type":"Polygon","coordinates":[[],[]]})"), "found 2 rings");
  EXPECT_PRED2(mentions, wrong(good, R"({"thickness_m":-0.1})"), "feature 2: thickness_m: found -0.1");
  EXPECT_PRED2(mentions, wrong(good, R"({"density_kg_m3":"heavy"})"), "density_kg_m3: found \"heavy\"");
  EXPECT_PRED2(mentions, wrong(good, R"({"flexural_strength_Pa":-1})"), "flexural_strength_Pa: found -1");
}

TEST_F(FieldFile, FaultsOfTheWholeFile) {
  EXPECT_PRED2(mentions, refusal(written("{\"type\": \"FeatureColl")), "not JSON");
  EXPECT_PRED2(mentions, refusal(written("[1, 2]")), "FeatureCollection");
  EXPECT_PRED2(mentions, refusal(written("{\"type\": \"FeatureCollection\"}")), "features");
  EXPECT_THROW(read_field(folder_ / "missing.json"), FileError);
  EXPECT_THROW(write_field({}, folder_ / "no_such_folder" / "f.json"), FileError);
}

}  // namespace field_file_test
}  // namespace nilas::field
