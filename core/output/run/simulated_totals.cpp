#include "core/output/run/simulated_totals.h"

namespace nilas::output {

void add_totals(const sim::Simulation& simulation, SummaryInput& input) {
  input.brash_mass = simulation.total(bodies::k_brash_mass);
  input.crushed_mass = simulation.total(bodies::k_crushed_mass);
  input.extruded_mass = simulation.total(bodies::k_extruded_mass);
  input.figures = simulation.figures();
}

}  // namespace nilas::output
