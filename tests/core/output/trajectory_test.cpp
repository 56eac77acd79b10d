#include "core/output/trajectory.h"

#include <gtest/gtest.h>
#include <tinyxml2.h>

#include "core/base/error.h"
#include "tests/core/output/sample_run.h"

namespace nilas {
namespace {

using test::sample_bodies;
using test::ScratchFolder;

/// Files that the list names, in order, with their times.
std::vector<std::pair<double, std::string>> listed(const std::filesystem::path& pvd) {
  tinyxml2::XMLDocument document;
  EXPECT_EQ(document.LoadFile(pvd.c_str()), tinyxml2::XML_SUCCESS);
  std::vector<std::pair<double, std::string>> frames;
  const auto* collection = document.FirstChildElement("VTKFile")->FirstChildElement("Collection");
  for (const auto* set = collection->FirstChildElement("DataSet"); set; set = set->NextSiblingElement("DataSet"))
    frames.emplace_back(set->DoubleAttribute("timestep"), set->Attribute("file"));
  return frames;
}

TEST(Trajectory, TheListIsClosedAfterEveryFrame) {
  const ScratchFolder folder;
  Trajectory trajectory(folder.path());
  EXPECT_TRUE(listed(folder / "trajectory.pvd").empty());
  const Bodies bodies = sample_bodies();
  trajectory.frame(0, 0, bodies);
  EXPECT_EQ(listed(folder / "trajectory.pvd").size(), 1u);
  trajectory.frame(0.1, 10, bodies);
  const auto frames = listed(folder / "trajectory.pvd");
  ASSERT_EQ(frames.size(), 2u);
  EXPECT_EQ(frames[1], std::make_pair(0.1, std::string("trajectory/step-000010.vtp")));
  for (const auto& [t, file] : frames) EXPECT_TRUE(std::filesystem::exists(folder / file));
}

TEST(Trajectory, AFrameHoldsAllBodiesButPlanes) {
  const ScratchFolder folder;
  Trajectory trajectory(folder.path());
  trajectory.frame(0, 0, sample_bodies());
  tinyxml2::XMLDocument document;
  ASSERT_EQ(document.LoadFile((folder / "trajectory/step-000000.vtp").c_str()), tinyxml2::XML_SUCCESS);
  const auto* piece = document.FirstChildElement("VTKFile")->FirstChildElement("PolyData")->FirstChildElement("Piece");
  EXPECT_EQ(piece->IntAttribute("NumberOfPoints"), 6 + 6 + 4);
  EXPECT_EQ(piece->IntAttribute("NumberOfPolys"), 5 + 5 + 4);
  std::vector<std::string> names;
  const auto* array = piece->FirstChildElement("CellData")->FirstChildElement("DataArray");
  for (; array; array = array->NextSiblingElement("DataArray")) names.emplace_back(array->Attribute("Name"));
  EXPECT_EQ(names, (std::vector<std::string>{"id", "kind", "speed_m_s", "velocity_m_s"}));
}

TEST(Trajectory, FollowsBodiesThatComeAndChange) {
  const ScratchFolder folder;
  Trajectory trajectory(folder.path());
  Bodies bodies = sample_bodies();
  trajectory.frame(0, 0, bodies);
  bodies.shape[1] = std::make_shared<const Shape>(test::tetrahedron());
  test::add_body(bodies, "piece", BodyKind::floe, Motion::free, test::triangle_floe(), 1, Vec3::Zero());
  trajectory.frame(0.1, 10, bodies);
  tinyxml2::XMLDocument document;
  ASSERT_EQ(document.LoadFile((folder / "trajectory/step-000010.vtp").c_str()), tinyxml2::XML_SUCCESS);
  const auto* piece = document.FirstChildElement("VTKFile")->FirstChildElement("PolyData")->FirstChildElement("Piece");
  EXPECT_EQ(piece->IntAttribute("NumberOfPolys"), 5 + 4 + 4 + 5);
}

TEST(Trajectory, AFolderThatCannotBeMadeIsAFileError) {
  const ScratchFolder folder;
  std::ofstream(folder / "trajectory") << "a file in its place";
  EXPECT_THROW(Trajectory(folder.path()), FileError);
}

}  // namespace
}  // namespace nilas
