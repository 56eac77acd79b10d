#include "core/output/vtk/trajectory.h"

#include <gtest/gtest.h>
#include <tinyxml2.h>

#include <algorithm>
#include <cstring>

#include "core/base/error.h"
#include "core/output/vtk/vtp_array.h"
#include "tests/core/output/sample_run.h"

namespace nilas::output {
namespace trajectory_test {

using test::sample_bodies;
using test::ScratchFolder;

/// An entry of the list.
struct Listed {
  double t = 0;
  int part = 0;
  std::string name, file;
  bool operator==(const Listed&) const = default;
};

std::vector<Listed> listed(const std::filesystem::path& pvd) {
  tinyxml2::XMLDocument document;
  EXPECT_EQ(document.LoadFile(pvd.c_str()), tinyxml2::XML_SUCCESS);
  std::vector<Listed> entries;
  const auto* collection = document.FirstChildElement("VTKFile")->FirstChildElement("Collection");
  for (const auto* set = collection->FirstChildElement("DataSet"); set; set = set->NextSiblingElement("DataSet"))
    entries.push_back(
        {set->DoubleAttribute("timestep"), set->IntAttribute("part"), set->Attribute("name"), set->Attribute("file")});
  return entries;
}

/// A .vtp file as its reader sees it.
class Document {
 public:
  explicit Document(const std::filesystem::path& file) {
    EXPECT_EQ(document_.LoadFile(file.c_str()), tinyxml2::XML_SUCCESS) << file;
    data_ = document_.FirstChildElement("VTKFile")->FirstChildElement("PolyData");
    piece_ = data_->FirstChildElement("Piece");
  }
  int points() const { return piece_->IntAttribute("NumberOfPoints"); }
  int polygons() const { return piece_->IntAttribute("NumberOfPolys"); }
  int vertices() const { return piece_->IntAttribute("NumberOfVerts"); }
  std::vector<std::string> names(const char* section) const {
    std::vector<std::string> names;
    const auto* array = piece_->FirstChildElement(section)->FirstChildElement("DataArray");
    for (; array; array = array->NextSiblingElement("DataArray")) names.emplace_back(array->Attribute("Name"));
    return names;
  }
  template <class Number>
  std::vector<Number> values(const char* section, const std::string& name) const {
    const auto* array = piece_->FirstChildElement(section)->FirstChildElement("DataArray");
    while (array != nullptr && name != array->Attribute("Name")) array = array->NextSiblingElement("DataArray");
    if (array == nullptr) throw std::runtime_error("no array " + name);
    const std::string bytes = array_bytes(array->GetText());
    std::vector<Number> values(bytes.size() / sizeof(Number));
    std::memcpy(values.data(), bytes.data(), bytes.size());
    return values;
  }
  std::string body_names() const {
    std::string names = array_bytes(data_->FirstChildElement("FieldData")->FirstChildElement("Array")->GetText());
    std::replace(names.begin(), names.end(), '\0', ';');
    return names;
  }

 private:
  tinyxml2::XMLDocument document_;
  const tinyxml2::XMLElement *data_ = nullptr, *piece_ = nullptr;
};

scene::Scene sample_scene() {
  scene::Scene scene;
  scene.ice.emplace();
  scene.vessel.emplace();
  return scene;
}

TEST(Trajectory, TheListIsClosedAfterEveryFrame) {
  const ScratchFolder folder;
  Trajectory trajectory(folder.path(), sample_scene(), false);
  EXPECT_TRUE(listed(folder / "trajectory.pvd").empty());
  const bodies::Bodies bodies = sample_bodies();
  trajectory.frame(0, 0, bodies);
  EXPECT_EQ(listed(folder / "trajectory.pvd").size(), 2u);
  trajectory.frame(0.1, 10, bodies);
  const auto entries = listed(folder / "trajectory.pvd");
  ASSERT_EQ(entries.size(), 4u);
  EXPECT_EQ(entries[2], (Listed{0.1, 0, "ice floes", "trajectory/step-000010-ice.vtp"}));
  EXPECT_EQ(entries[3], (Listed{0.1, 1, "vessel", "trajectory/step-000010-vessel.vtp"}));
  for (const auto& entry : entries) EXPECT_TRUE(std::filesystem::exists(folder / entry.file));
}

TEST(Trajectory, HasThePartsThatTheSceneHas) {
  const auto parts = [](const scene::Scene& scene, bool has_forces) {
    const ScratchFolder folder;
    Trajectory trajectory(folder.path(), scene, has_forces);
    trajectory.frame(0, 0, sample_bodies());
    trajectory.frame(0.1, 10, sample_bodies());
    std::vector<std::string> names;
    for (const auto& entry : listed(folder / "trajectory.pvd")) {
      EXPECT_TRUE(std::filesystem::exists(folder / entry.file));
      if (entry.t == 0) continue;
      EXPECT_EQ(entry.part, static_cast<int>(names.size()));
      names.push_back(entry.name);
    }
    return names;
  };
  EXPECT_TRUE(parts({}, false).empty());
  scene::Scene scene = sample_scene();
  scene.bodies.emplace_back();
  scene.water.emplace();
  scene.tank.emplace();
  EXPECT_EQ(parts(scene, true),
            (std::vector<std::string>{"ice floes", "vessel", "bodies", "contact forces", "water surface"}));
  scene.output.tank_walls = true;
  EXPECT_EQ(parts(scene, true).back(), "tank walls");
}

TEST(Trajectory, EveryPartHoldsItsKindAndItsNames) {
  const ScratchFolder folder;
  Trajectory trajectory(folder.path(), sample_scene(), false);
  trajectory.frame(0, 0, sample_bodies());
  const Document ice(folder / "trajectory/step-000000-ice.vtp"), vessel(folder / "trajectory/step-000000-vessel.vtp");
  EXPECT_EQ(ice.points(), 6 + 6);
  EXPECT_EQ(ice.polygons(), 5 + 5);
  EXPECT_EQ(ice.names("CellData"),
            (std::vector<std::string>{"id", "kind", "thickness_m", "speed_m_s", "velocity_m_s"}));
  EXPECT_EQ(ice.values<std::int64_t>("CellData", "id"), (std::vector<std::int64_t>{1, 1, 1, 1, 1, 2, 2, 2, 2, 2}));
  EXPECT_EQ(ice.values<float>("CellData", "thickness_m"), std::vector<float>(10, 0.2F));
  EXPECT_FLOAT_EQ(ice.values<float>("CellData", "speed_m_s").at(4), 0.5F);
  EXPECT_EQ(ice.body_names(), "floe-1;floe-2;");
  EXPECT_EQ(vessel.polygons(), 4);
  EXPECT_EQ(vessel.values<std::uint8_t>("CellData", "kind"), std::vector<std::uint8_t>(4, 1));
  EXPECT_EQ(vessel.values<float>("CellData", "thickness_m"), std::vector<float>(4, 0));
  EXPECT_EQ(vessel.body_names(), "hull;");
}

TEST(Trajectory, FloesHaveTheirDamageWhereTheSceneHasIt) {
  const ScratchFolder folder;
  scene::Scene scene = sample_scene();
  scene.fracture.emplace().damage.emplace();
  Trajectory trajectory(folder.path(), scene, false);
  trajectory.frame(0, 0, sample_bodies());
  trajectory.frame(0.1, 10, sample_bodies(),
                   {{}, 0.01, [](std::int64_t id) { return 0.25 * static_cast<double>(id); }});
  EXPECT_EQ(Document(folder / "trajectory/step-000000-ice.vtp").values<float>("CellData", "damage"),
            std::vector<float>(10, 0));
  const Document ice(folder / "trajectory/step-000010-ice.vtp"), vessel(folder / "trajectory/step-000010-vessel.vtp");
  const auto damage = ice.values<float>("CellData", "damage");
  EXPECT_EQ(damage.front(), 0.25F);
  EXPECT_EQ(damage.back(), 0.5F);
  EXPECT_THROW(vessel.values<float>("CellData", "damage"), std::runtime_error);
}

TEST(Trajectory, ContactForcesAreVectorsOnPoints) {
  const ScratchFolder folder;
  Trajectory trajectory(folder.path(), sample_scene(), true);
  trajectory.frame(0, 0, sample_bodies());
  ContactRow open, pressing;
  open.body = pressing.body = 3;
  pressing.other = 1;
  pressing.p_G = Vec3(1, 2, 0.5);
  pressing.impulse = Vec3(-0.2, 0.1, 0);
  pressing.gap = -0.25;
  trajectory.frame(0.1, 10, sample_bodies(), {{open, pressing}, 0.01, {}});
  EXPECT_EQ(Document(folder / "trajectory/step-000000-forces.vtp").points(), 0);
  const Document forces(folder / "trajectory/step-000010-forces.vtp");
  EXPECT_EQ(forces.points(), 1) << "an open contact has no arrow";
  EXPECT_EQ(forces.vertices(), 1);
  EXPECT_EQ(forces.values<float>("Points", "Points"), (std::vector<float>{1, 2, 0.5F}));
  EXPECT_EQ(forces.values<float>("PointData", "force_N"), (std::vector<float>{-20, 10, 0}));
  EXPECT_EQ(forces.values<float>("PointData", "gap_m"), std::vector<float>{-0.25F});
  EXPECT_EQ(forces.values<std::int64_t>("PointData", "body"), std::vector<std::int64_t>{3});
  EXPECT_EQ(forces.values<std::int64_t>("PointData", "other"), std::vector<std::int64_t>{1});
}

TEST(Trajectory, TheWaterCoversTheTankOrAllBodies) {
  const auto corners = [](const scene::Scene& scene) {
    const ScratchFolder folder;
    Trajectory trajectory(folder.path(), scene, false);
    trajectory.frame(0, 0, sample_bodies());
    return Document(folder / "trajectory/water.vtp").values<double>("Points", "Points");
  };
  scene::Scene scene = sample_scene();
  scene.water.emplace().level = 0.5;
  // bodies reach from -3 to 5 and 0 to 6; a tenth of 8 m around them
  const std::vector<double> around{-3.8, -0.8, 0.5, 5.8, -0.8, 0.5, 5.8, 6.8, 0.5, -3.8, 6.8, 0.5};
  const auto found = corners(scene);
  ASSERT_EQ(found.size(), around.size());
  for (std::size_t k = 0; k < around.size(); ++k) EXPECT_NEAR(found[k], around[k], 1e-12) << k;
  scene.tank.emplace();
  EXPECT_EQ(corners(scene), (std::vector<double>{0, -2.5, 0.5, 10, -2.5, 0.5, 10, 2.5, 0.5, 0, 2.5, 0.5}));
}

TEST(Trajectory, FollowsBodiesThatComeAndChange) {
  const ScratchFolder folder;
  Trajectory trajectory(folder.path(), sample_scene(), false);
  bodies::Bodies bodies = sample_bodies();
  trajectory.frame(0, 0, bodies);
  bodies.shape[1] = std::make_shared<const geometry::Shape>(test::tetrahedron());
  test::add_body(bodies, "piece", bodies::BodyKind::floe, bodies::Motion::free, test::triangle_floe(), 1, Vec3::Zero());
  trajectory.frame(0.1, 10, bodies);
  const Document ice(folder / "trajectory/step-000010-ice.vtp");
  EXPECT_EQ(ice.polygons(), 5 + 4 + 5);
  EXPECT_EQ(ice.body_names(), "floe-1;floe-2;piece;");
}

TEST(Trajectory, AFolderThatCannotBeMadeIsAFileError) {
  const ScratchFolder folder;
  std::ofstream(folder / "trajectory") << "a file in its place";
  EXPECT_THROW(Trajectory(folder.path(), sample_scene(), false), FileError);
}

}  // namespace trajectory_test
}  // namespace nilas::output
