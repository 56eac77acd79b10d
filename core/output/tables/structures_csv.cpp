#include "core/output/tables/structures_csv.h"

#include "core/output/tables/structure_channels.h"

namespace nilas::output {

StructuresCsv::StructuresCsv(const std::filesystem::path& path, const sim::RunInfo& info,
                             std::optional<std::int64_t> keep)
    : file_(path, "", keep), course_(info.drift_course) {
  if (!keep) file_.append(csv_header(structure_columns(info)));
}

void StructuresCsv::row(const sim::StepRecord& record) {
  row_.clear();
  row_.fixed(record.t);
  for (const sim::StructureRecord& structure : record.structures)
    for (const double load : structure_loads(structure, course_)) row_.fixed(load);
  file_.append(row_.line());
}

}  // namespace nilas::output
