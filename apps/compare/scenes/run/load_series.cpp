#include "apps/compare/scenes/run/load_series.h"

#include <algorithm>

#include "apps/compare/workshop/special_numbers.h"
#include "core/base/csv.h"
#include "core/output/file/csv_row.h"
#include "core/output/file/output_file.h"

namespace nilas::compare {

namespace {

constexpr const char* k_load_file = "ice_load.csv";

std::vector<std::string> kept_columns() {
  std::vector<std::string> names{"time_s"};
  names.insert(names.end(), k_course_channels.begin(), k_course_channels.end());
  return names;
}

/// Whether a file holds anything. A run that was ended while it began leaves a file without its header.
bool holds_rows(const std::filesystem::path& file) {
  return std::filesystem::exists(file) && std::filesystem::file_size(file) > 0;
}

}  // namespace

void keep_load_series(const std::filesystem::path& run_folder) {
  if (!holds_rows(run_folder / "vessel.csv")) return;
  const auto read = csv_columns(run_folder / "vessel.csv", kept_columns());
  std::string text = output::csv_header(kept_columns());
  output::CsvRow row;
  for (std::size_t k = 0; k < read.front().size(); ++k) {
    row.clear();
    for (const auto& column : read) row.shortest(column[k]);
    text += row.line();
  }
  output::write_whole(run_folder / k_load_file, text);
}

LoadSeries read_load_series(const std::filesystem::path& run_folder, double start) {
  LoadSeries series;
  series.start = start;
  if (!holds_rows(run_folder / k_load_file)) return series;
  auto read = csv_columns(run_folder / k_load_file, kept_columns());
  series.end = std::move(read[0]);
  for (std::size_t c = 0; c < series.loads.size(); ++c) series.loads[c] = std::move(read[c + 1]);
  return series;
}

output::LoadStatistics statistics_over(const LoadSeries& series, std::size_t channel, double from, double to) {
  std::vector<double> inside;
  double impulse = 0, length = 0, begin = series.start;
  for (std::size_t k = 0; k < series.end.size(); ++k) {
    const double end = series.end[k], load = series.loads[channel][k];
    const double within = std::max(0.0, std::min(end, to) - std::max(begin, from));
    impulse += load * within;
    length += within;
    if (2 * within > end - begin) inside.push_back(load);
    begin = end;
  }
  if (inside.empty()) return {k_unknown, k_unknown, k_unknown, k_unknown};
  output::LoadStatistics statistics = output::load_statistics(inside);
  statistics.mean = impulse / length;
  return statistics;
}

}  // namespace nilas::compare
