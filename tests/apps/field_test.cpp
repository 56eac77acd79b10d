/// `nilas field`: its report, its file and its picture.
#include <gtest/gtest.h>

#include <cmath>
#include <nlohmann/json.hpp>

#include "tests/support/mentions.h"
#include "tests/support/program.h"

namespace field_test {

using namespace nilas_test;

const std::string k_ice = R"(<?xml version="1.0"?>
<scene version="1" name="two fields">
  <time step="0.01" end="0.02"/>
  <seed value="5"/>
  <water density="1025"/><hydro><buoyancy/></hydro>
  <vessel name="ship" position="1 0 -0.2">
    <hull generate="icebreaker" length="3" beam="0.6" depth="0.4" triangles="500"/>
    <fixed/>
  </vessel>
  <ice thickness="0.04">
    <field kind="packed" region="0 -4 12 4" concentration="0.6">
      <size distribution="lognormal" mean="0.4" sd="0.12" min="0.2" max="0.8"/>
    </field>
    <field kind="grid" region="13 -4 18 4" rows="4" columns="3" gap="0.05" thickness="0.08"/>
    <vary property="thickness" distribution="normal" cov="0.1"/>
    <vary property="flexural_strength" distribution="lognormal" cov="0.2" with="thickness" correlation="0.5"/>
  </ice>
</scene>
)";

nlohmann::json field_json(const ScratchFolder& folder, const std::string& arguments) {
  const auto made = run_nilas("field " + arguments + " --json", folder.path());
  EXPECT_EQ(made.exit_code, 0) << made.err;
  return nlohmann::json::parse(made.out, nullptr, false);
}

TEST(Field, ReportsWhatWasAskedAndObtainedPerField) {
  const ScratchFolder folder;
  folder.write("ice.xml", k_ice);
  const auto json = field_json(folder, "ice.xml --no-picture");
  ASSERT_EQ(json["fields"].size(), 2u);
  const auto &packed = json["fields"][0], &grid = json["fields"][1];
  const double n = packed["floes"];
  EXPECT_EQ(json["floes"], packed["floes"].get<int>() + grid["floes"].get<int>());
  EXPECT_EQ(packed["concentration_asked"], 0.6);
  EXPECT_NEAR(packed["concentration"], 0.6, 0.01);
  EXPECT_EQ(packed["worst_overlap_m"], 0);
  EXPECT_GT(packed["seconds"], 0);
  const auto& size = packed["size_m"];
  EXPECT_LT(size["ks_distance"], 1.63 / std::sqrt(n));
  EXPECT_NEAR(size["obtained"]["mean"], size["asked"]["mean"], 4 * 0.12 / std::sqrt(n));
  EXPECT_GE(size["obtained"]["min"], 0.2 - 1e-9);
  const auto& thickness = packed["thickness_m"];
  EXPECT_NEAR(thickness["asked"]["mean"], 0.04, 1e-9);
  EXPECT_NEAR(thickness["asked"]["sd"], 0.004, 1e-8);
  EXPECT_NEAR(thickness["obtained"]["sd"], 0.004, 4 * 0.004 / std::sqrt(2 * n));
  EXPECT_LT(thickness["ks_distance"], 1.63 / std::sqrt(n));
  EXPECT_NEAR(packed["flexural_strength_Pa"]["obtained"]["mean"], 4e4, 4 * 8e3 / std::sqrt(n));
  EXPECT_EQ(packed["correlations"][0]["asked"], 0.5);
  EXPECT_NEAR(packed["correlations"][0]["obtained"], 0.5, 4 * 0.75 / std::sqrt(n));
  EXPECT_EQ(packed["density_kg_m3"]["obtained"]["sd"], 0);
  EXPECT_EQ(grid["floes"], 12);
  EXPECT_FALSE(grid["size_m"].contains("asked"));
  EXPECT_NEAR(grid["thickness_m"]["asked"]["mean"], 0.08, 1e-9);
  EXPECT_TRUE(mentions(json["notes"].dump(), "flexural_strength has no effect in a run without <fracture>"));
  EXPECT_FALSE(fs::exists(folder.path() / "field.png"));
}

TEST(Field, TheTableFitsATerminal) {
  const ScratchFolder folder;
  folder.write("ice.xml", k_ice);
  const auto made = run_nilas("field ice.xml --no-picture", folder.path());
  ASSERT_EQ(made.exit_code, 0) << made.err;
  std::istringstream lines(made.out);
  for (std::string line; std::getline(lines, line) && line.rfind("note:", 0) != 0;) EXPECT_LE(line.size(), 80u) << line;
  for (const char* part : {"field 1: packed", "field 2: grid", "size_m: lognormal, mean 0.4", "Kolmogorov-Smirnov",
                           "thickness_m: normal, mean 0.04, cov 0.1", "correlation", "written: field.geojson"})
    EXPECT_TRUE(mentions(made.out, part)) << part << "\n" << made.out;
}

/// The written field as a scene of its own: the same ice to the bit, the ship left out.
TEST(Field, TheFileReadsBackToTheSameIce) {
  const ScratchFolder folder;
  folder.write("ice.xml", k_ice);
  field_json(folder, "ice.xml --no-picture --out first.geojson");
  folder.write("again.xml",
               "<scene version='1'><ice density='800'><field kind='file' file='first.geojson'/>"
               "<vary property='thickness' cov='0.3'/></ice></scene>");
  const auto json = field_json(folder, "again.xml --no-picture --out second.geojson");
  EXPECT_EQ(read_text(folder.path() / "first.geojson"), read_text(folder.path() / "second.geojson"));
  EXPECT_FALSE(json["fields"][0]["thickness_m"].contains("asked"));
  const auto feature = nlohmann::json::parse(read_text(folder.path() / "first.geojson"))["features"][0];
  for (const char* property : {"thickness_m", "density_kg_m3", "flexural_strength_Pa"})
    EXPECT_GT(feature["properties"][property], 0) << property;
}

TEST(Field, ThreadsChangeNothing) {
  const ScratchFolder folder;
  folder.write("ice.xml", k_ice);
  field_json(folder, "ice.xml --no-picture --threads 1 --out one.geojson");
  field_json(folder, "ice.xml --no-picture --threads 3 --out three.geojson");
  EXPECT_EQ(read_text(folder.path() / "one.geojson"), read_text(folder.path() / "three.geojson"));
}

/// Four bytes of a file, the first most significant.
unsigned word_at(const std::string& bytes, std::size_t place) {
  unsigned word = 0;
  for (std::size_t k = 0; k < 4; ++k) word = 256 * word + static_cast<unsigned char>(bytes.at(place + k));
  return word;
}

TEST(Field, ThePictureIsAPngOfTheRightSize) {
  const ScratchFolder folder;
  folder.write("ice.xml", k_ice);
  const auto json = field_json(folder, "ice.xml --picture \"it's.png\"");
  EXPECT_EQ(json["picture"], "it's.png");
  const std::string png = read_text(folder.path() / "it's.png");
  ASSERT_GT(png.size(), 1000u);
  EXPECT_EQ(png.substr(0, 8), "\x89PNG\r\n\x1a\n");
  EXPECT_EQ(png.substr(12, 4), "IHDR");
  EXPECT_EQ(word_at(png, 16), 1600u);
  EXPECT_EQ(word_at(png, 20), 600u) << "two histograms of 300";
  EXPECT_EQ(png.substr(png.size() - 8, 4), "IEND");
}

TEST(Field, CheckAndRunTakeVariedIce) {
  const ScratchFolder folder;
  folder.write("ice.xml", k_ice);
  const auto check = run_nilas("check ice.xml --json", folder.path());
  ASSERT_EQ(check.exit_code, 0) << check.err;
  const auto modules = nlohmann::json::parse(check.out)["modules"];
  EXPECT_EQ(modules["vary thickness"], "<ice><vary>: normal, cov 0.1, one value per floe");
  EXPECT_TRUE(modules.contains("vary flexural_strength"));
  const auto run = run_nilas("run ice.xml --out run --json", folder.path());
  ASSERT_EQ(run.exit_code, 0) << run.err;
  EXPECT_TRUE(mentions(read_text(folder.path() / "run/nilas.log"), "no effect in a run without <fracture>"));
}

TEST(Field, FaultsOfVaryNameTheLine) {
  const ScratchFolder folder;
  folder.write("ice.xml", k_ice);
  const auto result = run_nilas("check ice.xml --set \"ice/vary[2]/@with=density\"", folder.path());
  EXPECT_EQ(result.exit_code, 2);
  EXPECT_TRUE(mentions(result.err, "'density' does not vary")) << result.err;
}

}  // namespace field_test
