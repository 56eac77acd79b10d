#pragma once
/// The force balance of six uniaxial load cells as matrices. Wrenches and displacements here are (torque; force) and
/// (rotation; translation) at the joint, in the carriage's frame.
#include <array>
#include <vector>

#include "core/base/math.h"
#include "core/vessel/vessel_system.h"

namespace nilas {

/// Columns: the wrench on the vessel from one newton of tension in each cell, so that readings = matrix^-1 wrench.
Mat6 cell_wrenches(const std::array<LoadCell, 6>& cells);

/// Condition number of cell_wrenches with lengths divided by the farthest cell's distance from the joint.
double layout_condition(const std::array<LoadCell, 6>& cells);
constexpr double k_max_layout_condition = 1e8;  ///< beyond it, half of the digits of a reading are lost

/// K = K6 - K6 S (S^T K6 S)^-1 S^T K6 with K6 = stiffness A A^T: what the joint transmits to the cells through a
/// massless platform when it is free along the unit columns S, the entries `free` (0..5). Rows and columns of these are
/// exactly zero. stiffness: of each cell [N/m].
Mat6 condensed_stiffness(const Mat6& cell_wrenches, double stiffness, const std::vector<int>& free);

}  // namespace nilas
