#pragma once
/// Ice loads, tow force and loads on structures in summary.json. Keys: docs/reference/outputs.md.
#include <nlohmann/json.hpp>

#include "core/output/loads/ice_load.h"
#include "core/sim/account/step_record.h"

namespace nilas::output {

nlohmann::ordered_json window_json(const LoadWindow& window);
/// Ice load of the vessel. `course`: how the course was determined.
nlohmann::ordered_json ice_load_json(const IceLoad& load, sim::CourseKind course);
nlohmann::ordered_json tow_force_json(const TowForce& tow);
nlohmann::ordered_json structures_json(const std::vector<StructureLoad>& structures);

}  // namespace nilas::output
