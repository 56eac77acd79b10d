#pragma once
/// Counts the thin plates that fly and spin through fixed thin plates.
#include <fmt/format.h>

#include <string>
#include <vector>

#include "core/base/error.h"
#include "core/base/random.h"
#include "core/scene/read/read_scene.h"
#include "core/sim/simulation.h"
#include "tests/support/random_vectors.h"
#include "tests/support/scratch_folder.h"

namespace nilas::plates {

constexpr double k_thickness = 0.004;  ///< Thickness of both plates [m].
constexpr double k_half_target = 1.0;  ///< Half the side of a fixed plate [m].
constexpr double k_apart = 12;         ///< Distance between the middles of two pairs, too large for them to meet [m].
constexpr double k_speed = 40;         ///< Speed: 100 thicknesses in a step of 0.01 s [m/s].

struct Flight {
  Vec3 p = Vec3::Zero(), v = Vec3::Zero(), w = Vec3::Zero();
  Quat q = Quat::Identity();
};

/// Draws a flight at any attitude, within half a radian or so of the target's normal, with up to 20 rad/s about each
/// axis.
inline Flight draw(RandomStream& random) {
  Flight flight;
  const double reach = 0.2;  // The plate's corners lie within this distance of its centre [m].
  flight.p = Vec3(-reach - random.uniform(0, 0.4), random.uniform(-0.4, 0.4), random.uniform(-0.4, 0.4));
  flight.v = k_speed * Vec3(1, random.uniform(-0.5, 0.5), random.uniform(-0.5, 0.5)).normalized();
  for (int i = 0; i < 3; ++i) flight.w[i] = random.uniform(-20, 20);
  flight.q = test::random_attitude(random);
  return flight;
}

inline std::string scene(const std::vector<Flight>& flights, const std::string& contact) {
  std::string text = "<scene version='1'><time step='0.01' end='1'/><gravity value='0 0 0'/><contact " + contact +
                     "><friction between='* *' kinetic='0.1'/></contact>";
  double y = 0;
  for (const Flight& f : flights) {
    text += fmt::format("<body shape='box' size='{} 2 2' position='0 {} 0' fixed='true'/>", k_thickness, y);
    const Vec3 ypr = f.q.toRotationMatrix().eulerAngles(2, 1, 0) * 180 / k_pi;
    text += fmt::format(
        "<body shape='box' size='0.3 0.2 {}' mass='1' position='{:.17g} {:.17g} {:.17g}' "
        "rotation_deg='{:.17g} {:.17g} {:.17g}' velocity='{:.17g} {:.17g} {:.17g}' "
        "angular_velocity='{:.17g} {:.17g} {:.17g}'/>",
        k_thickness, f.p.x(), f.p.y() + y, f.p.z(), ypr.x(), ypr.y(), ypr.z(), f.v.x(), f.v.y(), f.v.z(), f.w.x(),
        f.w.y(), f.w.z());
    y += k_apart;
  }
  return text + "</scene>";
}

struct Tally {
  long flights = 0;
  long passed = 0;    ///< Plates that got through their target.
  long refused = 0;   ///< Plates in scenes that stopped with a SimulationError.
  long warnings = 0;  ///< Steps with impacts that were not resolved.
  long parts = 0;     ///< Substeps of all steps and scenes.
  Tally& operator+=(const Tally& o) {
    for (const auto count : {&Tally::flights, &Tally::passed, &Tally::refused, &Tally::warnings, &Tally::parts})
      this->*count += o.*count;
    return *this;
  }
};

/// Runs the flights for four steps, in which each reaches its target. Plates behind the target and within its rim have
/// passed.
inline Tally fly(const std::vector<Flight>& flights, const std::string& contact) {
  const test::ScratchFolder folder;
  WarningCounts warnings{make_logger("off", "")};
  sim::Simulation simulation(scene::read_scene(folder.write("scene.xml", scene(flights, contact))), 1, warnings);
  Tally tally{static_cast<long>(flights.size())};
  try {
    for (int step = 0; step < 4; ++step) tally.parts += simulation.step().parts;
  } catch (const SimulationError&) {
    tally.refused = tally.flights;
    return tally;
  }
  for (std::size_t k = 0; k < flights.size(); ++k) {
    Vec3 p = simulation.bodies().p_GB[2 * k + 1];
    p.y() -= static_cast<double>(k) * k_apart;
    tally.passed += p.x() > 0 && p.tail<2>().cwiseAbs().maxCoeff() < k_half_target;
  }
  for (const auto& [what, count] : warnings.counts())
    tally.warnings += what.starts_with("steps with impacts") ? count : 0;
  return tally;
}

}  // namespace nilas::plates
