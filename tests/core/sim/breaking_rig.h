#pragma once
/// A bow driven into floes that break.
#include <gtest/gtest.h>

#include <string>

#include "tests/core/sim/scene_rig.h"
#include "tests/core/sim/stl_text.h"

namespace nilas::test {

/// Its edge leans forward by 45 degrees; the half angle of its waterlines is atan 1/4.
inline std::string bow_hull() {
  return stl({Vec3(-1, 0, -1), Vec3(1, 0, 1), Vec3(-3, -1, 1), Vec3(-3, 1, 1)},
             {{0, 1, 2}, {0, 3, 1}, {1, 3, 2}, {0, 2, 3}});
}

struct BreakingRig : SceneRig {
  explicit BreakingRig(const std::string& content, double step = 0.01, int threads = 1, const std::string& contact = "")
      : SceneRig("<time step='" + text(step) +
                     "' end='1000'/><contact solver='nsgs' tolerance='1e-9' max_iterations='20000' " + contact +
                     ">"
                     "<friction between='ice ice' static='0.3'/></contact><water "
                     "density='1000'/><hydro><buoyancy/></hydro>" +
                     content,
                 threads, {{"bow.stl", bow_hull()}}) {}

  /// Steps until ice breaks, and returns that step's record.
  sim::StepRecord until_broken(int most = 2000) {
    for (int k = 0; k < most; ++k)
      if (sim::StepRecord record = simulation.step(); !record.broken.empty()) return record;
    ADD_FAILURE() << "nothing breaks";
    return {};
  }
};

/// A bow at 0.3 m/s towards a fixed sheet from x = 0 on.
inline std::string bow(const std::string& sheet = "fixed='true' outline='0 -5 9 -5 9 5 0 5'", double speed = 0.3) {
  return "<vessel hull='bow.stl' position='-0.02 0 0'><mass value='1000'/><carriage speed='" + text(speed) +
         "'/></vessel><ice thickness='0.05' density='900' youngs_modulus='1e8'><floe breakable='true' " + sheet +
         "/></ice>";
}

inline std::string breaking_ice(const std::string& models = "<bending/>", const std::string& more = "") {
  return "<fracture flexural_strength='5e4' compressive_strength='2e5' min_area='1e-4' " + more +
         "><crushing model='explicit'/>" + models + "</fracture>";
}

}  // namespace nilas::test
