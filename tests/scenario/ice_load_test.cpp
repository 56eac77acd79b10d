/// The ice load that a run states is the mean over the rows that it names, by another program that sees only the rows.
#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>
#include <nlohmann/json.hpp>
#include <sstream>

#include "core/geometry/mesh.h"
#include "tests/support/program.h"

namespace ice_load_test {

using namespace nilas_test;
using Json = nlohmann::json;

struct Means {
  double along = 0, across = 0;
  long rows = 0;
};

/// Results of mean_ice_load.awk for a file. `settings`: its variables as NAME=VALUE words.
Means means_by_awk(const fs::path& csv, const std::vector<std::string>& settings) {
  std::string command = "awk";
  for (const auto& setting : settings) command += " -v '" + setting + "'";
  command += " -f '" NILAS_SOURCE_DIR "/tests/scenario/mean_ice_load.awk' '" + csv.string() + "'";
  FILE* pipe = popen(command.c_str(), "r");
  Means means;
  EXPECT_EQ(fscanf(pipe, "%lf %lf %ld", &means.along, &means.across, &means.rows), 3) << command;
  EXPECT_EQ(pclose(pipe), 0);
  return means;
}

/// The load behind a label at the start of a line, in newtons; negative where it is told as forward.
double printed_newtons(const std::string& text, const std::string& label) {
  const auto at = text.find("\n" + label);
  if (at == std::string::npos) return std::nan("");
  std::istringstream in(text.substr(at + 1 + label.size()));
  double value = 0;
  std::string unit, rest;
  in >> value >> unit;
  std::getline(in, rest, ',');
  if (rest.ends_with(" forward")) value = -value;
  if (unit.rfind("MN", 0) == 0) return 1e6 * value;
  if (unit.rfind("kN", 0) == 0) return 1e3 * value;
  return value;
}

class IceLoad : public ::testing::Test {
 protected:
  /// Runs the program and compares the vessel's load in summary.json and on the console with the rows of vessel.csv.
  Json expect_as_in_rows(const std::string& arguments, const std::vector<std::string>& settings) {
    const auto result = run_nilas("run " + arguments + " --out run", folder_.path());
    EXPECT_EQ(result.exit_code, 0) << result.err;
    const Json summary = Json::parse(read_text(folder_ / "run/summary.json"));
    const Means means = means_by_awk(folder_ / "run/vessel.csv", settings);
    const Json& load = summary.at("ice_load");
    EXPECT_EQ(summary.at("window").at("steps"), means.rows);
    const double scale = std::abs(means.along) + std::abs(means.across);
    EXPECT_GT(scale, 0);
    EXPECT_NEAR(load.at("along").at("mean_N"), means.along, 1e-6 * scale);
    EXPECT_NEAR(load.at("across").at("mean_N"), means.across, 1e-6 * scale);
    constexpr double k_printed = 1e-3;  // The console prints four digits.
    EXPECT_NEAR(printed_newtons(result.out, "ice load"), means.along, k_printed * std::abs(means.along) + 1e-9 * scale)
        << result.out;
    EXPECT_NEAR(summary.at("loads").at("ice_resistance_N").at("mean"), means.along, 1e-6 * scale);
    EXPECT_NEAR(summary.at("load_error").at("mean_N"), means.along, 1e-6 * scale) << "the same window";
    return summary;
  }

  /// Writes a cone frustum of eight sides that stands through the waterline, as a hull file in V or a body's mesh.
  void write_cone() const {
    constexpr int k_sides = 8;
    const auto corner = [](int k, double radius, double z) {
      const double angle = 2 * 3.14159265358979323846 * k / k_sides;
      return nilas::Vec3(radius * std::cos(angle), radius * std::sin(angle), z);
    };
    nilas::geometry::TriangleMesh cone;
    for (int k = 0; k < k_sides; ++k) cone.vertices.push_back(corner(k, 1.0, -0.5));
    for (int k = 0; k < k_sides; ++k) cone.vertices.push_back(corner(k, 0.4, 0.5));
    for (int k = 0; k < k_sides; ++k) {
      const int next = (k + 1) % k_sides;
      cone.triangles.push_back({k, next, k_sides + next});
      cone.triangles.push_back({k, k_sides + next, k_sides + k});
    }
    for (int k = 1; k + 1 < k_sides; ++k) {
      cone.triangles.push_back({0, k + 1, k});
      cone.triangles.push_back({k_sides, k_sides + k, k_sides + k + 1});
    }
    nilas::geometry::write_stl(cone, folder_ / "cone.stl");
  }

  /// Writes a scene of ice that drifts towards +x against a structure at the origin.
  void write_drift(const std::string& structure) const {
    folder_.write("drift.xml", R"(<scene version="1" name="drift"><time step="0.02" end="6"/>
  <contact solver="nsgs" tolerance="1e-4"><friction between="* *" kinetic="0.2"/></contact>
  <water density="1005"><current velocity="0.4 0.1 0"/></water><hydro><buoyancy/><drag/></hydro>)" +
                                   structure + R"(<ice thickness="0.04">
  <field region="-5 -2 -1.6 2" concentration="0.6" velocity="0.4 0.1 0">
  <size distribution="uniform" min="0.3" max="0.6"/></field></ice></scene>)");
  }

  ScratchFolder folder_;
};

TEST_F(IceLoad, OfTheDemo) {
  const Json summary =
      expect_as_in_rows(shipped_scene("towing.xml").string() + " --until 6", {"h=0.01", "ramp=2", "course_deg=0"});
  EXPECT_EQ(summary.at("window").at("reason"), "from the end of the ramp");
  const Json& tow = summary.at("tow_force");
  EXPECT_NEAR(tow.at("mean_N").get<double>(),
              tow.at("ice_N").get<double>() + tow.at("water_N").get<double>() + tow.at("inertia_N").get<double>(),
              1e-6);
}

TEST_F(IceLoad, OfAnObliqueTow) {
  expect_as_in_rows(shipped_scene("oblique-towing.xml").string() + " --until 4 --set vessel/carriage/@heading_deg=10",
                    {"h=0.01", "ramp=2", "course_deg=10"});
}

TEST_F(IceLoad, WithARampThatOutlastsTheRun) {
  const Json summary =
      expect_as_in_rows(shipped_scene("towing.xml").string() +
                            " --until 6 --set vessel/carriage/@ramp=8 --set \"vessel/@position=1.5 0\"",
                        {"h=0.01", "ramp=", "course_deg=0"});
  EXPECT_NE(summary.at("window").at("reason").get<std::string>().find("the ramp lasts until 8 s"), std::string::npos);
}

TEST_F(IceLoad, OverTheWindowAskedFor) {
  expect_as_in_rows(shipped_scene("towing.xml").string() + " --until 6 --statistics 3.5:5.25",
                    {"h=0.01", "course_deg=0", "from=3.5", "to=5.25"});
}

TEST_F(IceLoad, OfAFixedCone) {
  write_cone();
  write_drift("<vessel hull='cone.stl' position='0 0 0'><mass value='100'/><fixed/></vessel>");
  // The line points against the drift of (0.4, 0.1) m/s.
  expect_as_in_rows("drift.xml",
                    {"h=0.02", "course_deg=" + std::to_string(180 + std::atan2(0.1, 0.4) * 180 / 3.14159265358979)});
}

TEST_F(IceLoad, OfAFreeVessel) {
  write_drift(
      "<vessel position='-1 0' heading_deg='150'><hull length='1.6'/><mass "
      "draught='0.08'/></vessel>");
  expect_as_in_rows("drift.xml", {"h=0.02", "course_deg=heading"});
}

TEST_F(IceLoad, OfFixedBodies) {
  write_cone();
  write_drift(
      "<body name='cone' shape='mesh' mesh='cone.stl' fixed='true'/>"
      "<body name='pile' shape='cylinder' radius='0.3' height='1.5' position='0.5 1.4 0' fixed='true'/>");
  const auto result = run_nilas("run drift.xml --out run", folder_.path());
  ASSERT_EQ(result.exit_code, 0) << result.err;
  const Json summary = Json::parse(read_text(folder_ / "run/summary.json"));
  ASSERT_EQ(summary.at("structures").size(), 2u);
  for (const Json& structure : summary.at("structures")) {
    const std::string name = structure.at("name");
    const Means means =
        means_by_awk(folder_ / "run/structures.csv",
                     {"h=0.02", "body=" + name + "_",
                      "course_deg=" + std::to_string(180 + std::atan2(0.1, 0.4) * 180 / 3.14159265358979)});
    const Json& loads = structure.at("loads");
    EXPECT_EQ(structure.at("window").at("steps"), means.rows) << name;
    EXPECT_NEAR(loads.at("ice_resistance_N").at("mean_N"), means.along, 1e-6 * std::abs(means.along)) << name;
    EXPECT_NEAR(printed_newtons(result.out, "load on '" + name + "'"), means.along, 1e-3 * std::abs(means.along));
    EXPECT_GT(means.along, 0) << "the drift presses on '" << name << "'";
  }
}

}  // namespace ice_load_test
