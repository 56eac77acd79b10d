#include "core/sim/step/loads.h"

#include "core/base/error.h"

namespace nilas::sim {

Loads evaluate_loads(World& world, double t, double h) {
  const bodies::Bodies& bodies = world.parts.bodies;
  Loads loads{world.weight, {}};
  for (bodies::Module* module : world.parts.forces) {
    bodies::Wrenches& own = loads.by_module.emplace_back(world.size());
    module->add_forces(bodies, t + (1 - world.model.theta) * h, own);
    module->limit(bodies, h, own);
    for (std::size_t b = 0; b < world.size(); ++b) loads.total[b] += own[b];
  }
  for (std::size_t b = 0; b < world.size(); ++b)
    if (!(loads.total[b].force.allFinite() && loads.total[b].torque.allFinite()))
      throw SimulationError("at " + std::to_string(t) + " s the loads on body '" + bodies.name[b] +
                            "' left finite numbers; try a smaller <time step>");
  return loads;
}

}  // namespace nilas::sim
