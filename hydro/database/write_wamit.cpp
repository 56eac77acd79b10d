#include <fmt/format.h>

#include <cmath>
#include <fstream>
#include <functional>

#include "core/base/error.h"
#include "hydro/database/wamit.h"

namespace nilas::hydro {

namespace fs = std::filesystem;

namespace {

constexpr int k_written_modes = 6;

int rotations(int mode) { return mode > 2 ? 1 : 0; }

/// One of the files of a stem, for rows of text.
class WamitFile {
 public:
  WamitFile(const fs::path& stem, const char* ending) : path_(stem.string() + ending), out_(path_, std::ios::trunc) {
    if (!out_) throw FileError(path_.string() + ": cannot be written");
  }
  void row(const std::string& text) { out_ << text << '\n'; }
  void close() {
    out_.close();
    if (!out_) throw FileError(path_.string() + ": cannot be written");
  }

 private:
  fs::path path_;
  std::ofstream out_;
};

/// A row of .1; `damping` is left out for the limits.
std::string radiation_row(double period, int i, int j, double mass, const double* damping) {
  std::string row = fmt::format("{:14.6E}{:6d}{:6d}{:14.6E}", period, i + 1, j + 1, mass);
  if (damping != nullptr) row += fmt::format("{:14.6E}", *damping);
  return row;
}

void write_radiation(const Database& database, const fs::path& stem, const WamitScale& scale) {
  constexpr int k_power = 3;  // of the length in an added mass of translation
  constexpr double k_infinite_period = -1, k_period_zero = 0;
  WamitFile file(stem, ".1");
  const auto write = [&](double period, const Mat6& mass, const Mat6* damping, double frequency) {
    for (int i = 0; i < k_written_modes; ++i)
      for (int j = 0; j < k_written_modes; ++j) {
        const double unit = scale.density * std::pow(scale.length, k_power + rotations(i) + rotations(j));
        const double b = damping != nullptr ? (*damping)(i, j) / (unit * frequency) : 0;
        file.row(radiation_row(period, i, j, mass(i, j) / unit, damping != nullptr ? &b : nullptr));
      }
  };
  if (database.added_mass_zero) write(k_infinite_period, *database.added_mass_zero, nullptr, 0);
  if (database.added_mass_infinite) write(k_period_zero, *database.added_mass_infinite, nullptr, 0);
  for (std::size_t k = 0; k < database.frequency.size(); ++k)
    write(2 * k_pi / database.frequency[k], database.added_mass[k], &database.damping[k], database.frequency[k]);
  file.close();
}

/// Writes rows for all frequencies, headings and modes; `pairs` repeats the heading, as .9 does.
void write_waves(const Database& database, const fs::path& stem, const char* ending, bool pairs,
                 const std::function<std::complex<double>(std::size_t k, std::size_t h, int mode)>& value) {
  WamitFile file(stem, ending);
  for (std::size_t k = 0; k < database.frequency.size(); ++k)
    for (std::size_t h = 0; h < database.heading.size(); ++h)
      for (int i = 0; i < k_written_modes; ++i) {
        const std::complex<double> x = value(k, h, i);
        const std::string heading = fmt::format("{:14.6E}", database.heading[h] / k_deg);
        file.row(fmt::format("{:14.6E}{}{}{:6d}{:14.6E}{:14.6E}{:14.6E}{:14.6E}", 2 * k_pi / database.frequency[k],
                             heading, pairs ? heading : "", i + 1, std::abs(x), std::arg(x) / k_deg, x.real(),
                             x.imag()));
      }
  file.close();
}

void write_hydrostatics(const Mat6& restoring, const fs::path& stem, const WamitScale& scale) {
  WamitFile file(stem, ".hst");
  for (int i = 0; i < k_written_modes; ++i)
    for (int j = 0; j < k_written_modes; ++j) {
      const double unit = scale.density * scale.gravity * std::pow(scale.length, 2 + rotations(i) + rotations(j));
      file.row(fmt::format("{:6d}{:6d}{:14.6E}", i + 1, j + 1, restoring(i, j) / unit));
    }
  file.close();
}

}  // namespace

void write_wamit(const Database& database, const fs::path& stem, const WamitScale& scale) {
  const double load = scale.density * scale.gravity;
  write_radiation(database, stem, scale);
  if (!database.excitation.empty())
    write_waves(database, stem, ".3", false, [&](std::size_t k, std::size_t h, int i) {
      return database.excitation[k][h][i] / (load * std::pow(scale.length, 2 + rotations(i)));
    });
  if (!database.motion.empty())
    write_waves(database, stem, ".4", false, [&](std::size_t k, std::size_t h, int i) {
      return database.motion[k][h][i] * std::pow(scale.length, rotations(i));
    });
  if (!database.drift.empty())
    write_waves(database, stem, ".9", true, [&](std::size_t k, std::size_t h, int i) {
      return std::complex<double>(database.drift[k][h][i] / (load * std::pow(scale.length, 1 + rotations(i))));
    });
  if (database.restoring) write_hydrostatics(*database.restoring, stem, scale);
}

}  // namespace nilas::hydro
