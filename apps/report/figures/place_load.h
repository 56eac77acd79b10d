#pragma once
/// The ice load by place on a hull or structure. docs/theory/report.md
#include <vector>

#include "apps/report/figures/waterline_outline.h"
#include "apps/report/run/hull_contacts.h"

namespace nilas::report {

/// A cell of the unrolled surface that carried a load.
struct PlaceCell {
  double along = 0, height = 0;  ///< middle of the cell: along the outline, and in the mesh's frame [m]
  Vec3 place = Vec3::Zero();     ///< mean place of its contacts, weighted by impulse, in the mesh's frame [m]
  double impulse = 0;            ///< sum of the sizes of all impulses [N s]
  double peak = 0;               ///< largest sum of forces in one step, by size [N]
};

struct PlaceLoad {
  double width = 0;  ///< side of a cell [m]
  std::vector<PlaceCell> cells;
  double impulse = 0;  ///< of all cells [N s]
};

/// The impulses of contacts summed over square cells, 160 around the outline. Contacts without a force are left out.
PlaceLoad place_load(const HullContacts& contacts, const WaterlineOutline& outline);

/// The largest mean pressure on square panels of the unrolled surface.
struct PanelPressure {
  double area = 0;      ///< of a panel [m^2]
  double pressure = 0;  ///< largest normal force in one step over the area [Pa]
  double time = 0;      ///< of that step [s]
};

/// For panels of sides that double from `least` [m] to a quarter of the outline, the largest pressure of all steps and
/// of four layouts of panels that are half a panel apart. Normal forces count, as compressions.
std::vector<PanelPressure> panel_pressures(const HullContacts& contacts, const WaterlineOutline& outline, double least);

}  // namespace nilas::report
