/// A floe that a controller holds in a current, with a snapshot to look ahead.
#include <iostream>

#include "nilas/simulation.h"

constexpr const char* k_scene = R"(
<scene version="1" name="held-floe">
  <time step="0.02" end="4"/>
  <water density="1005"><current velocity="0.2 0 0"/></water>
  <hydro><buoyancy/><drag form="1.0" skin="0.005"/></hydro>
  <body name="plate" shape="box" size="1 1 0.2" density="900" position="0 0 -0.08"/>
</scene>)";

double hold_a_floe() {
  nilas::Simulation simulation(nilas::Scene::parse(k_scene, "held-floe.xml"), {.applied_loads = true});
  const auto push_back = [&simulation] {
    const nilas::BodyStates bodies = simulation.bodies();
    simulation.apply(0, {-100 * bodies.position[0] - 200 * bodies.velocity[0], 0, 0});
  };
  while (simulation.time() < 2) {
    push_back();
    simulation.step();
  }
  const nilas::Snapshot now = simulation.snapshot();
  while (!simulation.is_done()) simulation.step();
  std::cout << "let go, the floe drifts to x = " << simulation.bodies().position[0] << " m\n";
  simulation.restore(now);
  while (!simulation.is_done()) {
    push_back();
    simulation.step();
  }
  std::cout << "held, it stays at x = " << simulation.bodies().position[0] << " m\n";
  return simulation.bodies().position[0];
}
