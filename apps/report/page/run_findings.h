#pragma once
/// Everything about one run from which the sections of its report are made.
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "apps/report/floe_outlines.h"
#include "apps/report/run/hull_contacts.h"
#include "apps/report/run/load_figures.h"
#include "apps/report/run/peak_cause.h"
#include "apps/report/run/run_data.h"
#include "apps/report/run/run_shapes.h"

namespace nilas::report {

struct RunFindings {
  RunData run;
  std::optional<RunShapes> shapes;  ///< empty where the scene cannot be built again
  std::vector<BodyLoad> loads;
  const BodyLoad* load = nullptr;        ///< of `loads`: what the report is about; null where nothing bears a load
  const RunBody* body = nullptr;         ///< its shape; null: not known
  std::optional<HullContacts> contacts;  ///< empty where contacts.h5 is missing or cannot be read
  std::optional<PeakCause> cause;        ///< of the largest load of one step
  bool floe_made_peak = false;           ///< whether its body is known to be ice
  std::vector<IceFrameFile> frames;      ///< stored frames of the ice

  /// The name of the vessel in the scene, or "vessel".
  std::string vessel_name() const;
  /// The vessel, or a fixed body by its name, as a sentence has it.
  std::string subject() const;
};

/// The stored frame of the ice that is nearest to t [s]; null without frames.
const IceFrameFile* frame_near(const RunFindings& found, double t);

/// Reads a run folder. `body`: the body that the report is about; empty: the vessel, or the fixed body with the largest
/// mean load. Throws as read_run() and subject_of() do; whatever else cannot be read becomes a gap.
std::unique_ptr<RunFindings> examine_run(const std::filesystem::path& folder, const std::string& body);

}  // namespace nilas::report
