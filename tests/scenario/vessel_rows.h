#pragma once
/// Vectors and attitudes in the rows of a table such as vessel.csv, without the program's own code.
#include <Eigen/Dense>
#include <cstddef>
#include <string>

#include "tests/support/csv_table.h"

namespace nilas_test {

/// The vector of the columns START x UNIT, START y UNIT and START z UNIT, such as "contact_f" and "_N".
inline Eigen::Vector3d vector_in_row(const nilas::test::Table& t, const std::string& start, const std::string& unit,
                                     std::size_t row) {
  return {t[start + "x" + unit][row], t[start + "y" + unit][row], t[start + "z" + unit][row]};
}

/// The attitude of the vessel: yaw about z, then pitch about y, then roll about x.
inline Eigen::Matrix3d attitude(const nilas::test::Table& t, std::size_t row) {
  constexpr double k_deg = 3.14159265358979323846 / 180;
  return (Eigen::AngleAxisd(t["yaw_deg"][row] * k_deg, Eigen::Vector3d::UnitZ()) *
          Eigen::AngleAxisd(t["pitch_deg"][row] * k_deg, Eigen::Vector3d::UnitY()) *
          Eigen::AngleAxisd(t["roll_deg"][row] * k_deg, Eigen::Vector3d::UnitX()))
      .toRotationMatrix();
}

}  // namespace nilas_test
