#pragma once
/// A bow driven into floes that break.
#include <gtest/gtest.h>

#include <memory>
#include <sstream>
#include <string>

#include "core/scene/read/read_scene.h"
#include "core/sim/simulation.h"
#include "tests/support/scratch_folder.h"

namespace nilas::test {

/// Its edge leans forward by 45 degrees; the half angle of its waterlines is atan 1/4.
inline constexpr const char* k_bow =
    "solid bow\n"
    "facet normal 0 0 0\nouter loop\nvertex -1 0 -1\nvertex 1 0 1\nvertex -3 -1 1\nendloop\nendfacet\n"
    "facet normal 0 0 0\nouter loop\nvertex -1 0 -1\nvertex -3 1 1\nvertex 1 0 1\nendloop\nendfacet\n"
    "facet normal 0 0 0\nouter loop\nvertex 1 0 1\nvertex -3 1 1\nvertex -3 -1 1\nendloop\nendfacet\n"
    "facet normal 0 0 0\nouter loop\nvertex -1 0 -1\nvertex -3 -1 1\nvertex -3 1 1\nendloop\nendfacet\n"
    "endsolid bow\n";

inline std::string text(double x) {
  std::ostringstream out;
  out.precision(17);
  out << x;
  return out.str();
}

struct BreakingRig {
  explicit BreakingRig(const std::string& content, double step = 0.01, int threads = 1, const std::string& contact = "")
      : scene([&] {
          folder.write("bow.stl", k_bow);
          return read_scene(folder.write(
              "scene.xml", "<scene version='1'><time step='" + text(step) +
                               "' end='1000'/><contact solver='nsgs' tolerance='1e-9' max_iterations='20000' " +
                               contact +
                               ">"
                               "<friction between='ice ice' static='0.3'/></contact><water "
                               "density='1000'/><hydro><buoyancy/></hydro>" +
                               content + "</scene>"));
        }()),
        simulation(std::make_unique<Simulation>(scene, threads, warnings)) {}

  /// Steps until ice breaks, and returns that step's record.
  StepRecord until_broken(int most = 2000) {
    for (int k = 0; k < most; ++k)
      if (StepRecord record = simulation->step(); !record.broken.empty()) return record;
    ADD_FAILURE() << "nothing breaks";
    return {};
  }
  const Bodies& bodies() const { return simulation->bodies(); }

  ScratchFolder folder;
  WarningCounts warnings{make_logger("off", "")};
  Scene scene;
  std::unique_ptr<Simulation> simulation;
};

/// A bow at 0.3 m/s towards a fixed sheet from x = 0 on.
inline std::string bow(const std::string& sheet = "fixed='true' outline='0 -5 9 -5 9 5 0 5'", double speed = 0.3) {
  return "<vessel hull='bow.stl' position='-0.02 0 0'><mass value='1000'/><carriage speed='" + text(speed) +
         "'/></vessel><ice thickness='0.05' density='900' youngs_modulus='1e8'><floe breakable='true' " + sheet +
         "/></ice>";
}

inline std::string fracture(const std::string& models = "<bending/>", const std::string& more = "") {
  return "<fracture flexural_strength='5e4' compressive_strength='2e5' min_area='1e-4' " + more +
         "><crushing model='explicit'/>" + models + "</fracture>";
}

}  // namespace nilas::test
