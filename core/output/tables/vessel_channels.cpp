#include "core/output/tables/vessel_channels.h"

#include "core/base/error.h"
#include "core/output/tables/attitude.h"

namespace nilas::output {

namespace {

void add(const Vec3& x, std::vector<double>& values) { values.insert(values.end(), x.data(), x.data() + x.size()); }

void add(const Wrench& wrench, std::vector<double>& values) {
  add(wrench.force, values);
  add(wrench.torque, values);
}

}  // namespace

VesselChannels::VesselChannels(const sim::RunInfo& info)
    : num_modules_(info.vessel_loads.size()),
      has_carriage_(info.has_carriage),
      has_cells_(info.has_cells),
      has_hydro_(info.has_hydro) {
  name_wrench("contact");
  if (has_carriage_) {
    name_wrench("carriage");
    name_wrench("hull");
  }
  first_cell_ = names_.size();
  if (has_cells_) {
    for (const char* kind : {"_N", "_tared_N"})
      for (int cell = 1; cell <= k_num_cells; ++cell) names_.push_back("cell" + std::to_string(cell) + kind);
  }
  if (info.tare) tare_ = info.tare->cells;
  if (has_hydro_) name_wrench("hydro");
  for (const std::string& module : info.vessel_loads) name_wrench(module);
  num_global_loads_ = names_.size();
  for (const char* name : {"x_m", "y_m", "z_m", "yaw_deg", "pitch_deg", "roll_deg", "vx_m_s", "vy_m_s", "vz_m_s",
                           "roll_rate_deg_s", "pitch_rate_deg_s", "yaw_rate_deg_s", "wx_rad_s", "wy_rad_s", "wz_rad_s"})
    names_.emplace_back(name);
  for (const char* name : {"ice_resistance_N", "ice_side_N"}) names_.emplace_back(name);
}

template <class Value>
std::vector<Value> VesselChannels::loads_among(const std::vector<Value>& channels) const {
  NILAS_DEMAND(channels.size() == names_.size());
  const auto at = [&](std::size_t k) { return channels.begin() + static_cast<std::ptrdiff_t>(k); };
  std::vector<Value> loads(channels.begin(), at(first_cell_));
  // The tared cells, without their raw readings.
  loads.insert(loads.end(), at(first_cell_ + (has_cells_ ? k_num_cells : 0)), at(num_global_loads_));
  loads.insert(loads.end(), channels.end() - k_num_course_loads, channels.end());
  return loads;
}

std::vector<std::string> VesselChannels::load_names() const { return loads_among(names_); }
std::vector<double> VesselChannels::loads(const std::vector<double>& values) const { return loads_among(values); }

void VesselChannels::name_wrench(const std::string& source) {
  for (const char* axis : {"x", "y", "z"}) names_.push_back(source + "_f" + axis + "_N");
  for (const char* axis : {"x", "y", "z"}) names_.push_back(source + "_m" + axis + "_Nm");
}

bool VesselChannels::read(const sim::VesselRecord& record, std::vector<double>& values) const {
  NILAS_DEMAND(record.carriage.has_value() || !(has_carriage_ || has_cells_));
  NILAS_DEMAND(record.hydro.has_value() || !has_hydro_);
  NILAS_DEMAND(record.module_loads.size() == num_modules_);
  values.clear();
  add(record.contact, values);
  if (has_carriage_) {
    add(record.carriage->about_joint, values);
    add(record.carriage->about_com, values);
  }
  if (has_cells_) {
    const auto& cells = record.carriage->cells;
    values.insert(values.end(), cells.begin(), cells.end());
    for (std::size_t k = 0; k < cells.size(); ++k) values.push_back(cells[k] - tare_[k]);
  }
  if (has_hydro_) add(*record.hydro, values);
  for (const Wrench& load : record.module_loads) add(load, values);

  const vessel::VesselState& state = record.state;
  const EulerAngles angles = euler_angles(state.pose.q);
  const EulerRates rates = euler_rates(state.pose.q, state.w);
  add(state.pose.p, values);
  add(Vec3(angles.yaw, angles.pitch, angles.roll) / k_deg, values);
  add(state.v, values);
  add(Vec3(rates.roll, rates.pitch, rates.yaw) / k_deg, values);
  add(state.w, values);
  values.push_back(-record.ice.head<2>().dot(record.course));
  values.push_back(record.ice.head<2>().dot(sim::to_port(record.course)));
  return !angles.gimbal_lock;
}

}  // namespace nilas::output
