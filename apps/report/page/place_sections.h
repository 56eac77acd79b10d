#pragma once
/// The sections of a report on where the ice pressed: load by place, and pressure over area.
#include <nlohmann/json.hpp>

#include "apps/report/figures/place_load.h"
#include "apps/report/page/run_findings.h"
#include "apps/report/page/section.h"

namespace nilas::report {

/// Load by place, with the surface that it lies on.
struct HullPicture {
  PlaceLoad load;
  const geometry::TriangleMesh* mesh = nullptr;
  double outline = 0, water = 0;  ///< length around; height of the water in the frame of the mesh [m]
  bool is_vessel = false;
  double peak_along = 0;  ///< where the largest load of one step acted, as PlaceCell::along [m]; without a cause 0
  const PeakCause* cause = nullptr;  ///< of that load; null: not known
  bool is_floe = false;              ///< whether its body is known to be ice
};

/// Empty without contacts or without a shape.
std::optional<HullPicture> hull_picture(const RunFindings& found);

/// The picture for the page's script, with lengths in metres and impulses in N s.
nlohmann::ordered_json hull_json(const HullPicture& picture);

Section place_section(const RunFindings& found, const std::optional<HullPicture>& picture);
Section pressure_section(const RunFindings& found);

}  // namespace nilas::report
