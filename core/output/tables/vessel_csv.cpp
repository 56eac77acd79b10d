#include "core/output/tables/vessel_csv.h"

namespace nilas::output {

VesselCsv::VesselCsv(const std::filesystem::path& path, const VesselChannels& channels,
                     std::optional<std::int64_t> keep)
    : file_(path, "", keep) {
  if (keep) return;
  std::vector<std::string> names{"time_s"};
  names.insert(names.end(), channels.names().begin(), channels.names().end());
  file_.append(csv_header(names));
}

void VesselCsv::row(double t, const std::vector<double>& values) {
  row_.clear();
  row_.fixed(t);
  for (const double x : values) row_.fixed(x);
  file_.append(row_.line());
}

}  // namespace nilas::output
