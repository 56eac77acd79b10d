#include "core/output/tables/events_csv.h"

#include "core/output/file/csv_row.h"

namespace nilas::output {

EventsCsv::EventsCsv(const std::filesystem::path& path, std::optional<std::int64_t> keep) : file_(path, "", keep) {
  if (keep) return;
  file_.append(csv_header({"time_s", "kind", "floe_id", "x_m", "y_m", "z_m", "energy_J", "length_m", "pieces",
                           "radius_m", "load_ratio", "brash_kg", "extruded_kg"}));
}

void EventsCsv::rows(const std::vector<fracture::FractureEvent>& events) {
  std::string block;
  CsvRow row;
  for (const fracture::FractureEvent& event : events) {
    std::string pieces;
    for (const std::int64_t id : event.pieces) pieces += (pieces.empty() ? "" : ";") + std::to_string(id);
    row.clear();
    row.shortest(event.t).text(event.kind).integer(event.floe);
    for (const double x : {event.p_G.x(), event.p_G.y(), event.p_G.z(), event.energy, event.length}) row.shortest(x);
    row.text(pieces).shortest(event.radius).shortest(event.ratio).shortest(event.brash).shortest(event.extruded);
    block += row.line();
  }
  if (!block.empty()) file_.append(block);
}

}  // namespace nilas::output
