/// A floe pushed against, and sliding along, a body of several convex parts feels no seam.
#include <gtest/gtest.h>

#include <cmath>
#include <sstream>
#include <tuple>
#include <vector>

#include "core/scene/read/read_scene.h"
#include "core/sim/simulation.h"
#include "tests/core/sim/stl_text.h"
#include "tests/support/scratch_folder.h"

namespace seam_slide_test {

using namespace nilas;
using namespace nilas::sim;

/// Triangles of a box as an STL solid; the faces toward +y and +z in `cells` stretches of x.
std::string box_stl(const Vec3& low, const Vec3& high, int cells) {
  std::vector<Vec3> vertices;
  std::vector<std::vector<int>> faces;
  const auto quad = [&](const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d) {
    const int first = static_cast<int>(vertices.size());
    vertices.insert(vertices.end(), {a, b, c, d});
    faces.push_back({first, first + 1, first + 2, first + 3});
  };
  for (int k = 0; k < cells; ++k) {
    const auto station = [&](int i) { return i == cells ? high.x() : low.x() + (high.x() - low.x()) * i / cells; };
    const double x0 = station(k), x1 = station(k + 1);
    quad({x0, high.y(), low.z()}, {x0, high.y(), high.z()}, {x1, high.y(), high.z()}, {x1, high.y(), low.z()});
    quad({x0, low.y(), low.z()}, {x1, low.y(), low.z()}, {x1, low.y(), high.z()}, {x0, low.y(), high.z()});
    quad({x0, low.y(), high.z()}, {x1, low.y(), high.z()}, {x1, high.y(), high.z()}, {x0, high.y(), high.z()});
    quad({x0, low.y(), low.z()}, {x0, high.y(), low.z()}, {x1, high.y(), low.z()}, {x1, low.y(), low.z()});
  }
  quad({low.x(), low.y(), low.z()}, {low.x(), low.y(), high.z()}, {low.x(), high.y(), high.z()},
       {low.x(), high.y(), low.z()});
  quad({high.x(), low.y(), low.z()}, {high.x(), high.y(), low.z()}, {high.x(), high.y(), high.z()},
       {high.x(), low.y(), high.z()});
  return test::stl(vertices, faces);
}

/// A barge along x from -3 to 3, y from -1 to 0, z from -0.5 to 0.5.
struct Barge {
  const char* name;
  int facets;
  std::vector<std::pair<double, double>> stretches;
};

void PrintTo(const Barge& barge, std::ostream* out) { *out << barge.name; }

/// Direction in which the floe is pushed against the barge, and its start.
struct Push {
  const char* name;
  Vec3 into, start;
};

void PrintTo(const Push& push, std::ostream* out) { *out << push.name; }

struct Course {
  double mean = 0, noise = 0;  ///< Mean force along the push, and its largest deviation [N].
  double across = 0;           ///< largest force across it [N]
  double turning = 0;          ///< largest angular velocity [rad/s]
  double way = 0;              ///< Distance along the barge [m].
};

constexpr double k_h = 0.01, k_mass = 2, k_push = 3;  // [s], [kg], [m/s^2]

std::string scene_text(const Push& push, const std::string& stabilisation) {
  std::ostringstream text;
  const Vec3 g = k_push * push.into;
  const auto vector = [](const Vec3& v) {
    return std::to_string(v.x()) + " " + std::to_string(v.y()) + " " + std::to_string(v.z());
  };
  text << "<scene version='1'><time step='" << k_h << "' end='20'/><gravity value='" << vector(g)
       << "'/><contact law='coulomb' solver='nsgs' tolerance='1e-12' max_iterations='20000' stabilisation='"
       << stabilisation << "'/><vessel name='barge' hull='hull' position='0 0 0'><mass value='1000'/><fixed/></vessel>"
       << "<body name='floe' shape='box' material='ice' size='0.8 0.6 0.3' mass='" << k_mass << "' position='"
       << vector(push.start) << "' velocity='0.37 0 0'/></scene>";
  return text.str();
}

Course slide(const Barge& barge, const Push& push, const std::string& stabilisation) {
  const test::ScratchFolder folder;
  folder.write("hull/hull.json", "{\"name\": \"barge\"}");
  folder.write("hull/fluid.stl", box_stl({-3, -1, -0.5}, {3, 0, 0.5}, 1));
  for (std::size_t k = 0; k < barge.stretches.size(); ++k) {
    const auto& [from, to] = barge.stretches[k];
    folder.write("hull/part-0" + std::to_string(k + 1) + ".stl", box_stl({from, -1, -0.5}, {to, 0, 0.5}, barge.facets));
  }
  const scene::Scene scene = scene::read_scene(folder.write("scene.xml", scene_text(push, stabilisation)));
  WarningCounts warnings{make_logger("off", "")};
  Simulation simulation(scene, 1, warnings);
  const auto floe = static_cast<std::size_t>(1 - simulation.vessel_index());
  std::vector<double> forces;
  Course course;
  constexpr int k_steps = 1000, k_settling = 5;
  for (int k = 0; k < k_steps; ++k) {
    const Vec3 before = simulation.bodies().v_GB[floe];
    simulation.step();
    const Vec3 force = k_mass * ((simulation.bodies().v_GB[floe] - before) / k_h - k_push * push.into);
    if (k < k_settling) continue;
    forces.push_back(-push.into.dot(force));
    course.across = std::max(course.across, (force - push.into * push.into.dot(force)).norm());
    course.turning = std::max(course.turning, simulation.bodies().w_GB[floe].norm());
  }
  for (const double f : forces) course.mean += f / static_cast<double>(forces.size());
  for (const double f : forces) course.noise = std::max(course.noise, std::abs(f - course.mean));
  course.way = simulation.bodies().p_GB[floe].x() - push.start.x();
  return course;
}

const std::vector<Barge> k_barges{{"OnePart", 1, {{-3, 3}}},
                                  {"OnePartOfManyFacets", 12, {{-3, 3}}},
                                  {"SideBySide", 3, {{-3, -0.7}, {-0.7, 0.45}, {0.45, 3}}},
                                  {"Overlapping", 2, {{-3, 0.1}, {-0.3, 0.9}, {0.5, 3}}}};
const std::vector<Push> k_pushes{{"AtTheSide", -Vec3::UnitY(), {-1.8, 0.3, 0.07}},
                                 {"OnTop", -Vec3::UnitZ(), {-1.8, -0.45, 0.65}},
                                 {"Below", Vec3::UnitZ(), {-1.8, -0.45, -0.65}},
                                 {"OverTheEdge", -Vec3::UnitY(), {-1.8, 0.3, 0.4}}};

class SlidesAlong : public ::testing::TestWithParam<std::tuple<Barge, Push>> {};

TEST_P(SlidesAlong, WithoutABump) {
  const auto& [barge, push] = GetParam();
  for (const std::string stabilisation : {"none", "projection"}) {
    const Course course = slide(barge, push, stabilisation);
    EXPECT_NEAR(course.mean, k_mass * k_push, 1e-6 * k_mass * k_push) << stabilisation;
    EXPECT_LT(course.noise, 1e-6 * course.mean) << stabilisation;
    EXPECT_LT(course.across, 1e-6 * course.mean) << stabilisation;
    EXPECT_LT(course.turning, 1e-7) << stabilisation;
    EXPECT_NEAR(course.way, 3.7, 1e-7) << stabilisation;
  }
}

INSTANTIATE_TEST_SUITE_P(All, SlidesAlong,
                         ::testing::Combine(::testing::ValuesIn(k_barges), ::testing::ValuesIn(k_pushes)),
                         [](const auto& instance) {
                           return std::string(std::get<0>(instance.param).name) + std::get<1>(instance.param).name;
                         });

}  // namespace seam_slide_test
