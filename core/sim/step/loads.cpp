#include "core/sim/step/loads.h"

#include "core/base/error.h"
#include "core/sim/step/vessel_step.h"

namespace nilas::sim {

static Wrench hull_water_load(const World& world) {
  const auto hull = static_cast<std::size_t>(world.parts.vessel_index);
  const bodies::Bodies& bodies = world.parts.bodies;
  const Vec3 flow = world.parts.water ? world.parts.water->current : Vec3(Vec3::Zero());
  return quadratic_water_load(bodies::turned(world.parts.hull_water->added_B, bodies.R_GB[hull]),
                              bodies.v_GB[hull] - flow, bodies.w_GB[hull]);
}

Loads evaluate_loads(World& world, double t, double h) {
  const bodies::Bodies& bodies = world.parts.bodies;
  Loads loads{world.weight, {}};
  for (bodies::Module* module : world.parts.forces) {
    bodies::Wrenches& own = loads.by_module.emplace_back(world.size());
    module->add_forces(bodies, t + (1 - world.model.theta) * h, own);
    module->limit(bodies, h, own);
    if (world.parts.hull_water && world.parts.hull_water->force == loads.by_module.size() - 1)
      own[world.parts.vessel_index] += hull_water_load(world);
    for (std::size_t b = 0; b < world.size(); ++b) loads.total[b] += own[b];
  }
  for (std::size_t b = 0; b < world.size(); ++b)
    if (!(loads.total[b].force.allFinite() && loads.total[b].torque.allFinite()))
      throw SimulationError("at " + std::to_string(t) + " s the loads on body '" + bodies.name[b] +
                            "' left finite numbers; try a smaller <time step>");
  return loads;
}

}  // namespace nilas::sim
