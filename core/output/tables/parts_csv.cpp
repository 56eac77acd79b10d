#include "core/output/tables/parts_csv.h"

#include "core/base/error.h"

namespace nilas::output {

namespace {

std::vector<std::string> coordinate_columns(JointKind joint) {
  switch (joint) {
    case JointKind::hinge:
      return {"angle_deg", "rate_deg_s"};
    case JointKind::slider:
      return {"travel_m", "speed_m_s"};
    case JointKind::ball:
      return {"turn_x_deg", "turn_y_deg", "turn_z_deg", "rate_x_deg_s", "rate_y_deg_s", "rate_z_deg_s"};
    case JointKind::free:
    case JointKind::weld:
      break;
  }
  return {};
}

}  // namespace

std::vector<std::string> part_columns(const std::vector<sim::PartInfo>& parts, const std::vector<std::string>& rods) {
  std::vector<std::string> columns{"time_s"};
  for (const sim::PartInfo& part : parts) {
    const auto add = [&](const std::string& column) { columns.push_back(part.name + "_" + column); };
    for (const char* source : {"joint", "contact"}) {
      for (const char* axis : {"x", "y", "z"}) add(std::string(source) + "_f" + axis + "_N");
      for (const char* axis : {"x", "y", "z"}) add(std::string(source) + "_m" + axis + "_Nm");
    }
    for (const std::string& column : coordinate_columns(part.joint)) add(column);
    add("unbalanced_force_N");
    add("unbalanced_torque_Nm");
  }
  for (const std::string& rod : rods) columns.push_back("rod_" + rod + "_N");
  return columns;
}

PartsCsv::PartsCsv(const std::filesystem::path& path, const sim::RunInfo& info, std::optional<std::int64_t> keep)
    : file_(path, "", keep), parts_(info.parts), rods_(static_cast<Eigen::Index>(info.rods.size())) {
  if (!keep) file_.append(csv_header(part_columns(parts_, info.rods)));
}

void PartsCsv::row(double t, const sim::VesselRecord& vessel) {
  const std::vector<sim::PartRecord>& parts = vessel.parts;
  NILAS_DEMAND(parts.size() == parts_.size() && vessel.rods.size() == rods_);
  row_.clear();
  row_.fixed(t);
  for (std::size_t k = 0; k < parts.size(); ++k) {
    const sim::PartRecord& part = parts[k];
    for (const Wrench& load : {part.joint, part.contact}) {
      for (const double x : load.force) row_.fixed(x);
      for (const double x : load.torque) row_.fixed(x);
    }
    const double unit = parts_[k].joint == JointKind::slider ? 1 : k_deg;
    for (const double x : part.coordinates) row_.fixed(x / unit);
    for (const double x : part.rates) row_.fixed(x / unit);
    row_.fixed(part.unbalanced_force);
    row_.fixed(part.unbalanced_torque);
  }
  for (const double tension : vessel.rods) row_.fixed(tension);
  file_.append(row_.line());
}

}  // namespace nilas::output
