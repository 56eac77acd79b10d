#pragma once
/// What summary.json says of a simulation's end.
#include "core/output/run/summary_json.h"
#include "core/sim/simulation.h"

namespace nilas::output {

/// Sets the masses of lost ice and the figures of the modules.
void add_totals(const sim::Simulation& simulation, SummaryInput& input);

}  // namespace nilas::output
