#pragma once
/// The figures of the ice load that a report states: those of summary.json, or without it the same computed from the
/// tables.
#include <optional>
#include <string>
#include <vector>

#include "apps/report/run/run_data.h"
#include "apps/report/run/run_shapes.h"
#include "core/output/loads/ice_load.h"

namespace nilas::report {

/// The load on a vessel or on a body that the scene holds fixed.
struct BodyLoad {
  std::string name;  ///< of a fixed body; empty: the vessel
  output::LoadWindow window;
  output::ComponentLoad along, across;
  bool touched = false;
  bool error_at_least = false;                    ///< the error of the mean is a lower bound
  bool told = false;                              ///< the figures are those of summary.json
  bool chance_alone = false;                      ///< the error of the mean holds the effect of chance alone
  std::string peak_depends;                       ///< what the peak of one step depends on; empty: not known
  std::optional<output::StepDependence> on_step;  ///< of the load along the course; empty: not known
  std::vector<double> series;                     ///< load along the course of every step [N]

  bool is_vessel() const { return name.empty(); }
  /// Whether the means over the halves of the window differ by more than their errors.
  bool is_unsteady() const { return along.halves && along.halves->differ(); }
};

/// The loads on the vessel and on all fixed bodies, the vessel first. `shapes`: lengths and the carriage's ramp, used
/// where there is no summary; null: not known.
std::vector<BodyLoad> body_loads(RunData& run, const RunShapes* shapes);

/// The body that the report is about: that of this name, else the vessel, else the fixed body with the largest mean;
/// null where there is none. Throws InputError for a name that no body has.
const BodyLoad* subject_of(const std::vector<BodyLoad>& loads, const std::string& name, const std::string& vessel);

}  // namespace nilas::report
