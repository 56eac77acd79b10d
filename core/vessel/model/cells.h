#pragma once
/// The matrices of a force balance with six uniaxial load cells. Wrenches and displacements here are (torque; force)
/// and (rotation; translation) at the joint, in the carriage's frame.
#include <array>
#include <vector>

#include "core/base/math.h"
#include "core/vessel/model/vessel_model.h"

namespace nilas::vessel {

/// The matrix whose column k is the wrench on the vessel from one newton of tension in cell k, so that readings =
/// matrix^-1 wrench.
Mat6 cell_wrenches(const std::array<LoadCell, 6>& cells);

/// The reading of each cell [N] when the joint transmits `about_joint` (frame G) with the carriage at `yaw` [rad].
/// `layout`: factorised cell_wrenches().
std::array<double, 6> cell_readings(const Eigen::PartialPivLU<Mat6>& layout, const Wrench& about_joint, double yaw);

/// Condition number of cell_wrenches with lengths divided by the farthest cell's distance from the joint.
double layout_condition(const std::array<LoadCell, 6>& cells);
constexpr double k_max_layout_condition = 1e8;  ///< limit above which half of the digits of a reading are lost

/// The matrix B. Row k holds the shortening of cell k per unit of each coordinate of the joint. A massless platform
/// between cells and joint yields along the entries `free` (0..5), whose columns are exactly zero: B = A^T (1 - S (S^T
/// A A^T S)^-1 S^T A A^T), with A = cell_wrenches and S the unit columns of these entries. B^T maps the cells' tensions
/// to the generalised forces of the coordinates.
Mat6 cell_shortenings(const Mat6& cell_wrenches, const std::vector<int>& free);

/// The stiffness of the cells at the joint: K = stiffness B^T B, which is K6 - K6 S (S^T K6 S)^-1 S^T K6 with K6 =
/// stiffness A A^T. Rows and columns of `free` are exactly zero. `stiffness`: that of each cell [N/m].
Mat6 condensed_stiffness(const Mat6& cell_wrenches, double stiffness, const std::vector<int>& free);

}  // namespace nilas::vessel
