#include "core/output/tables/structure_channels.h"

namespace nilas::output {

const std::vector<std::string>& structure_load_names() {
  static const std::vector<std::string> names{"contact_fx_N",  "contact_fy_N",  "contact_fz_N",     "contact_mx_Nm",
                                              "contact_my_Nm", "contact_mz_Nm", "ice_resistance_N", "ice_side_N"};
  return names;
}

std::vector<double> structure_loads(const sim::StructureRecord& record, const Vec2& course) {
  const Vec3 &f = record.contact.force, &m = record.contact.torque;
  const Vec2 horizontal = record.ice.head<2>();
  return {f.x(), f.y(), f.z(), m.x(), m.y(), m.z(), -horizontal.dot(course), horizontal.dot(sim::to_port(course))};
}

std::vector<std::string> structure_columns(const sim::RunInfo& info) {
  std::vector<std::string> columns{"time_s"};
  for (const sim::StructureInfo& structure : info.structures) {
    for (const std::string& load : structure_load_names()) columns.push_back(structure.name + "_" + load);
  }
  return columns;
}

}  // namespace nilas::output
