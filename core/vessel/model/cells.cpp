#include "core/vessel/model/cells.h"

#include <algorithm>

#include "core/base/csv.h"
#include "core/base/error.h"

namespace nilas::vessel {

std::array<LoadCell, 6> default_cells(double arm) {
  NILAS_DEMAND(arm > 0);
  std::array<LoadCell, 6> cells;
  cells[0] = {Vec3::Zero(), Vec3::UnitX()};
  cells[1] = {{arm, 0, 0}, Vec3::UnitY()};
  cells[2] = {{-arm, 0, 0}, Vec3::UnitY()};
  // The joint is the centre of the vertical cells, so that the stiffness does not couple the axes.
  cells[3] = {{arm, 0, 0}, Vec3::UnitZ()};
  cells[4] = {{-0.5 * arm, 0.5 * arm, 0}, Vec3::UnitZ()};
  cells[5] = {{-0.5 * arm, -0.5 * arm, 0}, Vec3::UnitZ()};
  return cells;
}

Mat6 cell_wrenches(const std::array<LoadCell, 6>& cells) {
  Mat6 A;
  for (int i = 0; i < 6; ++i) {
    const LoadCell& cell = cells[i];
    A.col(i) << cell.point.cross(cell.axis), cell.axis;
  }
  return A;
}

std::array<double, 6> cell_readings(const Eigen::PartialPivLU<Mat6>& layout, const Wrench& about_joint, double yaw) {
  const Quat to_carriage(Eigen::AngleAxisd(-yaw, Vec3::UnitZ()));
  Vec6 transmitted;
  transmitted << to_carriage * about_joint.torque, to_carriage * about_joint.force;
  std::array<double, 6> readings{};
  Eigen::Map<Vec6>(readings.data()) = layout.solve(transmitted);
  return readings;
}

double layout_condition(const std::array<LoadCell, 6>& cells) {
  double reach = 0;
  for (const auto& cell : cells) reach = std::max(reach, cell.point.norm());
  Mat6 A = cell_wrenches(cells);
  if (reach > 0) A.topRows<3>() /= reach;
  const Vec6 values = Eigen::JacobiSVD<Mat6>(A).singularValues();
  return values[0] / values[5];
}

std::array<LoadCell, 6> read_cells(const std::string& csv_file, double scale) {
  const CsvTable table = read_csv(csv_file, {"x_m", "y_m", "z_m", "ax", "ay", "az"});
  std::array<LoadCell, 6> cells;
  if (table.rows.size() != cells.size())
    throw InputError(csv_file + ": found " + std::to_string(table.rows.size()) +
                     " load cells; a force balance has exactly 6");
  for (std::size_t i = 0; i < cells.size(); ++i) {
    const auto& row = table.rows[i];
    const Vec3 axis(row[3], row[4], row[5]);
    const double length = axis.stableNorm();
    if (!(length > 0))
      throw InputError(csv_file + ":" + std::to_string(table.lines[i]) + ": the cell's axis ax,ay,az has no length");
    cells[i] = {scale * Vec3(row[0], row[1], row[2]), axis / length};
  }
  if (!(layout_condition(cells) <= k_max_layout_condition))
    throw InputError(csv_file +
                     ": the six cells do not hold all six directions, so their loads cannot be told apart: " +
                     "no axis may be a combination of the others, as three parallel axes in one plane are");
  return cells;
}

Mat6 cell_shortenings(const Mat6& cell_wrenches, const std::vector<int>& free) {
  std::vector<int> held;
  for (int i = 0; i < 6; ++i)
    if (std::find(free.begin(), free.end(), i) == free.end()) held.push_back(i);
  Mat6 B = Mat6::Zero();
  if (held.empty()) return B;
  // The platform yields so that the sum of squared tensions, which is the energy, is smallest.
  const Mat6 rigid = cell_wrenches.transpose();
  MatX left = rigid(Eigen::all, held);
  if (!free.empty()) {
    const MatX given = rigid(Eigen::all, free);
    left -= given * MatX(given.householderQr().solve(left));
  }
  B(Eigen::all, held) = left;
  return B;
}

Mat6 condensed_stiffness(const Mat6& cell_wrenches, double stiffness, const std::vector<int>& free) {
  const Mat6 B = cell_shortenings(cell_wrenches, free);
  Mat6 K = Mat6::Zero();
  K.selfadjointView<Eigen::Lower>().rankUpdate(B.transpose(), stiffness);
  return K.selfadjointView<Eigen::Lower>();
}

}  // namespace nilas::vessel
