#include "contact/fclib/fclib_rolling.h"

#include <algorithm>

#include "core/base/error.h"

namespace nilas::contact {

namespace {

/// Calls work(row in the file, row in the ContactProblem, length) for every pair of rows; length 1 for forces.
template <class Work>
void for_each_row(const RollingRows& rows, const Work& work) {
  for (int p = 0; p < rows.num_points(); ++p) {
    for (int i = 0; i < 3; ++i) work(k_rolling_rows * p + i, 3 * rows.contact[p] + i, 1.0);
    if (rows.moment[p] < 0) continue;
    for (int i = 1; i < 3; ++i) work(k_rolling_rows * p + 2 + i, 3 * rows.moment[p] + i, rows.length[p]);
  }
}

/// Entries with their columns moved and scaled; those without a place are dropped.
std::vector<MatrixEntry> moved(const std::vector<MatrixEntry>& entries, const std::vector<int>& column,
                               const std::vector<double>& factor) {
  std::vector<MatrixEntry> out;
  out.reserve(entries.size());
  for (const MatrixEntry& entry : entries)
    if (column[entry.column] >= 0) out.push_back({entry.row, column[entry.column], factor[entry.column] * entry.value});
  return out;
}

}  // namespace

void RollingRows::number() {
  int next = num_points();
  for (int c = 0; c < num_points(); ++c) {
    contact.push_back(c);
    moment.push_back(length[c] > 0 ? next++ : -1);
  }
}

RollingRows RollingRows::of(const ContactProblem& problem) {
  RollingRows rows;
  for (int c = 0; c < problem.num_contacts(); ++c) {
    if (problem.is_moment(c)) {
      for (const auto& jacobian : {problem.jacobian_a(c), problem.jacobian_b(c)})
        if (!jacobian.row(0).isZero(0)) throw InputError("FCLIB's form of a problem has no row for spinning friction");
      continue;
    }
    const int m = problem.moment_of(c);
    rows.contact.push_back(c);
    rows.moment.push_back(m);
    rows.length.push_back(m < 0 ? 0 : problem.moments[m].rolling);
  }
  return rows;
}

int RollingRows::num_rows() const {
  return num_points() + static_cast<int>(std::count_if(moment.begin(), moment.end(), [](int m) { return m >= 0; }));
}

std::vector<MatrixEntry> RollingRows::jacobian(const std::vector<MatrixEntry>& of_file) const {
  std::vector<int> column(k_rolling_rows * num_points(), -1);
  std::vector<double> factor(column.size(), 0);
  for_each_row(*this, [&](int file, int ours, double l) {
    column[file] = ours;
    factor[file] = l;
  });
  return moved(of_file, column, factor);
}

VecX RollingRows::velocities(const VecX& of_file) const {
  VecX out = VecX::Zero(3 * num_rows());
  for_each_row(*this, [&](int file, int ours, double l) { out[ours] = l * of_file[file]; });
  return out;
}

VecX RollingRows::impulses(const VecX& of_file) const {
  VecX out = VecX::Zero(3 * num_rows());
  for_each_row(*this, [&](int file, int ours, double l) { out[ours] = of_file[file] / l; });
  return out;
}

std::vector<MatrixEntry> RollingRows::jacobian_for_file(const std::vector<MatrixEntry>& ours) const {
  std::vector<int> column(3 * num_rows(), -1);
  std::vector<double> factor(column.size(), 0);
  for_each_row(*this, [&](int file, int own, double l) {
    column[own] = file;
    factor[own] = 1 / l;
  });
  return moved(ours, column, factor);
}

VecX RollingRows::velocities_for_file(const VecX& ours) const {
  VecX out = VecX::Zero(k_rolling_rows * num_points());
  for_each_row(*this, [&](int file, int own, double l) { out[file] = ours[own] / l; });
  return out;
}

VecX RollingRows::impulses_for_file(const VecX& ours) const {
  VecX out = VecX::Zero(k_rolling_rows * num_points());
  for_each_row(*this, [&](int file, int own, double l) { out[file] = l * ours[own]; });
  return out;
}

}  // namespace nilas::contact
