#include <algorithm>
#include <cmath>
#include <functional>
#include <map>
#include <set>
#include <sstream>
#include <tuple>
#include <utility>

#include "core/base/error.h"
#include "core/base/file_bytes.h"
#include "core/choices/database_files.h"
#include "hydro/database/wamit.h"
#include "hydro/database/wamit_rows.h"

namespace nilas::hydro {

namespace fs = std::filesystem;

namespace {

std::string shown(double value) {
  std::ostringstream text;
  text << value;
  return text.str();
}

/// 1 for a mode of rotation, whose loads and motions have one more length.
int rotation(int mode) { return mode > 2 ? 1 : 0; }

/// The rows of .1 for one period.
struct RadiationGroup {
  int line = 0;  ///< of its first row
  Mat6 added_mass = Mat6::Zero(), damping = Mat6::Zero();
  std::map<std::pair<int, int>, int> entries;  ///< (i, j) and the line
};

constexpr double k_infinite_period = -1;  ///< code of WAMIT for w = 0; period zero is 0

std::map<double, RadiationGroup> radiation_groups(const WamitRows& file, const WamitScale& scale) {
  constexpr int k_columns_with_damping = 5;
  constexpr int k_power = 3;  // of the length in an added mass of translation
  std::map<double, RadiationGroup> groups;
  for (const WamitRow& row : file.rows()) {
    const double period = row.values[0] < 0 ? k_infinite_period : row.values[0];
    const int i = file.mode(row, 1), j = file.mode(row, 2);
    RadiationGroup& group = groups[period];
    if (group.line == 0) group.line = row.line;
    const auto [known, is_new] = group.entries.emplace(std::pair{i, j}, row.line);
    if (!is_new) file.refuse(row.line, "repeats period and modes of line " + std::to_string(known->second));
    if (period > 0 && static_cast<int>(row.values.size()) < k_columns_with_damping)
      file.refuse(row.line, "has no damping; allowed: period, two modes, added mass, damping");
    const double unit = scale.density * std::pow(scale.length, k_power + rotation(i) + rotation(j));
    group.added_mass(i, j) = unit * row.values[3];
    if (period > 0) group.damping(i, j) = unit * 2 * k_pi / period * row.values[4];
  }
  return groups;
}

/// Every period must have the same pairs of modes: a row that is missing would read as zero.
void demand_same_entries(const WamitRows& file, const std::map<double, RadiationGroup>& groups) {
  const RadiationGroup& first = groups.begin()->second;
  for (const auto& [period, group] : groups)
    for (const auto* each : {&first, &group})
      for (const auto& [modes, line] : each->entries) {
        const RadiationGroup& other = each == &first ? group : first;
        if (other.entries.count(modes) == 0)
          file.refuse(other.line, "the period that begins here has no row for modes " +
                                      std::to_string(modes.first + 1) + " " + std::to_string(modes.second + 1) +
                                      ", which line " + std::to_string(line) + " has for another period");
      }
}

/// Periods above zero from the longest to the shortest, as they stand in the file.
using Periods = std::vector<double>;

Periods take_radiation(const fs::path& path, const WamitScale& scale, Database& database) {
  const WamitRows file(path, {4, 5});
  const auto groups = radiation_groups(file, scale);
  demand_same_entries(file, groups);
  Periods periods;
  for (auto group = groups.rbegin(); group != groups.rend(); ++group) {
    const auto& [period, matrices] = *group;
    if (period < 0) database.added_mass_zero = matrices.added_mass;
    if (period == 0) database.added_mass_infinite = matrices.added_mass;
    if (period <= 0) continue;
    periods.push_back(period);
    database.frequency.push_back(2 * k_pi / period);
    database.added_mass.push_back(matrices.added_mass);
    database.damping.push_back(matrices.damping);
  }
  if (periods.empty()) throw InputError(path.string() + ": has no period above 0");
  return periods;
}

/// Six values for each period and heading, as a file of waves has them.
using WaveTable = std::map<std::pair<double, double>, ComplexVec6>;

struct WaveColumns {
  int mode = 2;   ///< column of the mode
  int value = 5;  ///< column of the real part; the imaginary part follows, modulus and phase stand before
};

/// The largest modulus of each mode in a file of waves.
Vec6 largest_moduli(const WamitRows& file, const WaveColumns& columns) {
  Vec6 largest = Vec6::Zero();
  for (const WamitRow& row : file.rows()) {
    if (row.values[columns.mode] < 0) continue;
    double& of_mode = largest[file.mode(row, columns.mode)];
    of_mode = std::max(of_mode, std::abs(row.values[columns.value - 2]));
  }
  return largest;
}

/// Refuses a row whose modulus and phase contradict real and imaginary part. Values that symmetry makes zero are noise,
/// whose parts need not fit.
void check_modulus(const WamitRows& file, const WamitRow& row, const WaveColumns& columns, double largest) {
  constexpr double k_agreement = 1e-4;  // share of the modulus; phases have seven digits of up to 180 degrees
  constexpr double k_noise = 1e-6;      // share of the largest modulus of the mode
  const double modulus = row.values[columns.value - 2], phase = row.values[columns.value - 1] * k_deg;
  const std::complex<double> stated(modulus * std::cos(phase), modulus * std::sin(phase));
  const std::complex<double> parts(row.values[columns.value], row.values[columns.value + 1]);
  if (std::abs(stated - parts) > k_agreement * std::abs(modulus) + k_noise * largest)
    file.refuse(row.line, "modulus " + shown(modulus) + " and phase " + shown(row.values[columns.value - 1]) +
                              " do not fit real part " + shown(parts.real()) + " and imaginary part " +
                              shown(parts.imag()));
}

/// Reads a file of waves; `keep` says which rows count, and unit(mode) what a value is multiplied by.
WaveTable wave_table(const WamitRows& file, const WaveColumns& columns,
                     const std::function<bool(const WamitRow&)>& keep, const std::function<double(int)>& unit) {
  WaveTable table;
  const Vec6 largest = largest_moduli(file, columns);
  std::map<std::tuple<double, double, int>, int> lines;
  for (const WamitRow& row : file.rows()) {
    if (row.values[0] <= 0 || !keep(row)) continue;
    const int mode = file.mode(row, columns.mode);
    check_modulus(file, row, columns, largest[mode]);
    const auto [known, is_new] = lines.emplace(std::tuple{row.values[0], row.values[1], mode}, row.line);
    if (!is_new) file.refuse(row.line, "repeats period, heading and mode of line " + std::to_string(known->second));
    auto [entry, unused] = table.emplace(std::pair{row.values[0], row.values[1]}, ComplexVec6::Zero());
    entry->second[mode] = unit(mode) * std::complex<double>(row.values[columns.value], row.values[columns.value + 1]);
  }
  return table;
}

std::vector<double> headings_of(const WaveTable& table) {
  std::set<double> headings;
  for (const auto& [key, unused] : table) headings.insert(key.second);
  return {headings.begin(), headings.end()};
}

/// The table in the order of the periods and headings. Refuses a period or heading that is missing or that only this
/// file has.
std::vector<std::vector<ComplexVec6>> ordered(const fs::path& path, const WaveTable& table, const Periods& periods,
                                              const std::vector<double>& headings) {
  for (const auto& [key, unused] : table)
    if (std::find(periods.begin(), periods.end(), key.first) == periods.end())
      throw InputError(path.string() + ": has the period " + shown(key.first) + ", which the file .1 has not");
  std::vector<std::vector<ComplexVec6>> values;
  for (const double period : periods) {
    values.emplace_back();
    for (const double heading : headings) {
      const auto found = table.find({period, heading});
      if (found == table.end())
        throw InputError(path.string() + ": has no rows for period " + shown(period) + " and heading " +
                         shown(heading));
      values.back().push_back(found->second);
    }
  }
  if (headings_of(table) != headings) throw InputError(path.string() + ": has other headings than the excitation");
  return values;
}

/// The files of a stem by their ending.
class Stem {
 public:
  explicit Stem(const fs::path& file_or_stem) {
    const fs::path any = is_wamit_file(file_or_stem) ? file_or_stem : fs::path(file_or_stem.string() + ".1");
    for (const fs::path& file : database_files(any)) files_.push_back(file);
    missing_ = fs::path(any).replace_extension(".1");
  }
  /// The file with this ending, which may be in capitals; nothing where there is none.
  const fs::path* find(const std::string& ending) const {
    for (const fs::path& file : files_) {
      std::string written = file.extension().string();
      std::transform(written.begin(), written.end(), written.begin(),
                     [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
      if (written == ending) return &file;
    }
    return nullptr;
  }
  const fs::path& radiation() const {
    const fs::path* file = find(".1");
    if (file == nullptr) throw nothing_there(missing_, "file of added mass and damping");
    return *file;
  }
  /// The first of these that is there.
  const fs::path* first_of(std::initializer_list<const char*> endings) const {
    for (const char* ending : endings)
      if (const fs::path* file = find(ending)) return file;
    return nullptr;
  }

 private:
  std::vector<fs::path> files_;
  fs::path missing_;
};

void take_excitation(const Stem& stem, const WamitScale& scale, const Periods& periods, Database& database,
                     std::vector<double>& headings) {
  const fs::path* path = stem.first_of({".3", ".2"});
  if (path == nullptr) {
    database.notes.push_back("There is no file .3 or .2, so the database has no wave excitation.");
    return;
  }
  const WaveTable table = wave_table(
      WamitRows(*path, {7}), {}, [](const WamitRow&) { return true; },
      [&](int i) { return scale.density * scale.gravity * std::pow(scale.length, 2 + rotation(i)); });
  headings = headings_of(table);
  if (headings.empty()) throw InputError(path->string() + ": has no period above 0");
  database.excitation = ordered(*path, table, periods, headings);
}

void take_motion(const Stem& stem, const WamitScale& scale, const Periods& periods, Database& database,
                 const std::vector<double>& headings) {
  const fs::path* path = stem.find(".4");
  if (path == nullptr || headings.empty()) return;
  const WaveTable table = wave_table(
      WamitRows(*path, {7}), {}, [](const WamitRow&) { return true; },
      [&](int i) { return 1 / std::pow(scale.length, rotation(i)); });
  database.motion = ordered(*path, table, periods, headings);
}

void take_drift(const Stem& stem, const WamitScale& scale, const Periods& periods, Database& database,
                const std::vector<double>& headings) {
  const fs::path* path = stem.first_of({".9", ".8"});
  if (path == nullptr || headings.empty()) return;
  constexpr WaveColumns k_drift_columns{3, 6};
  // Modes below zero are moments about the axes of the moving body. Pairs of headings need a directional sea.
  const auto keep = [](const WamitRow& row) { return row.values[1] == row.values[2] && row.values[3] > 0; };
  const WaveTable table = wave_table(WamitRows(*path, {8}), k_drift_columns, keep, [&](int i) {
    return scale.density * scale.gravity * std::pow(scale.length, 1 + rotation(i));
  });
  for (const auto& of_period : ordered(*path, table, periods, headings)) {
    database.drift.emplace_back();
    for (const ComplexVec6& load : of_period) database.drift.back().push_back(load.real());
  }
  if (path == stem.find(".8"))
    database.notes.push_back("Mean drift comes from the file .8, so it has the modes surge, sway and yaw only.");
}

void take_hydrostatics(const Stem& stem, const WamitScale& scale, Database& database) {
  const fs::path* path = stem.find(".hst");
  if (path == nullptr) {
    database.notes.push_back("There is no file .hst, so the database has no hydrostatic stiffness.");
    return;
  }
  const WamitRows file(*path, {3});
  Mat6 restoring = Mat6::Zero();
  std::map<std::pair<int, int>, int> lines;
  for (const WamitRow& row : file.rows()) {
    const int i = file.mode(row, 0), j = file.mode(row, 1);
    const auto [known, is_new] = lines.emplace(std::pair{i, j}, row.line);
    if (!is_new) file.refuse(row.line, "repeats the modes of line " + std::to_string(known->second));
    restoring(i, j) =
        scale.density * scale.gravity * std::pow(scale.length, 2 + rotation(i) + rotation(j)) * row.values[2];
  }
  database.restoring = restoring;
}

}  // namespace

Database read_wamit(const fs::path& file_or_stem, const WamitScale& scale) {
  const Stem stem(file_or_stem);
  Database database;
  database.source = stem.radiation().string();
  database.density = scale.density;
  database.gravity = scale.gravity;
  const Periods periods = take_radiation(stem.radiation(), scale, database);
  std::vector<double> headings;
  take_excitation(stem, scale, periods, database, headings);
  take_motion(stem, scale, periods, database, headings);
  take_drift(stem, scale, periods, database, headings);
  take_hydrostatics(stem, scale, database);
  for (const double heading : headings) database.heading.push_back(heading * k_deg);
  return database;
}

WamitScale wamit_geometry_scale(const fs::path& file) {
  std::istringstream text(file_bytes(file, k_most_text_bytes));
  std::string line;
  std::getline(text, line);  // a title
  WamitScale scale;
  if (!std::getline(text, line) || !(std::istringstream(line) >> scale.length >> scale.gravity) || scale.length <= 0 ||
      scale.gravity <= 0)
    throw InputError(file.string() + ":2: found '" + line + "'; allowed: two numbers above 0, ULEN and GRAV");
  return scale;
}

}  // namespace nilas::hydro
