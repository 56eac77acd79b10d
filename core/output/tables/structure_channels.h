#pragma once
/// Loads on the bodies that a scene holds fixed: names and values, for structures.csv and the summary.
#include <string>
#include <vector>

#include "core/sim/account/step_record.h"

namespace nilas::output {

/// Names of the loads on a structure, without its name: contact_fx_N .. contact_mz_Nm, ice_resistance_N, ice_side_N.
const std::vector<std::string>& structure_load_names();

/// Values in that order. `course`: unit vector, as for a fixed vessel.
std::vector<double> structure_loads(const sim::StructureRecord& record, const Vec2& course);

/// The columns: time_s, then those of each structure with its name in front, as pier_contact_fx_N.
std::vector<std::string> structure_columns(const sim::RunInfo& info);

}  // namespace nilas::output
