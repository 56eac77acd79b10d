#include "core/output/replay/channels.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <limits>
#include <string_view>

#include "core/base/error.h"
#include "core/output/replay/byte_text.h"
#include "core/output/tables/structure_channels.h"

namespace nilas::output::replay {

namespace {

/// The units that names of columns end in. Longer ones come first.
constexpr std::array<std::string_view, 18> k_units{"sqrtJ", "rad_s", "deg_s", "m3_s", "Nms", "m_s", "rpm", "deg", "rad",
                                                   "Nm",    "Ns",    "kg",    "Pa",   "W",   "N",   "J",   "m",   "s"};

/// The loads on a structure that a viewer draws: its ice loads along and across the drift, and the contact force.
constexpr std::array<std::string_view, 5> k_structure_loads{"contact_fx_N", "contact_fy_N", "contact_fz_N",
                                                            "ice_resistance_N", "ice_side_N"};

const char* group_of(std::string_view column) {
  if (column.starts_with("cell")) return "cell";
  return column.ends_with("_N") || column.ends_with("_Nm") ? "load" : "motion";
}

/// x >= 0 as the upper half of a float32, rounded up: 8 binary digits.
std::uint16_t rounded_up(double x) {
  constexpr std::uint32_t k_half = 1u << 16;
  auto value = static_cast<float>(x);
  if (static_cast<double>(value) < x) value = std::nextafter(value, std::numeric_limits<float>::infinity());
  const auto bits = std::bit_cast<std::uint32_t>(value);
  // One that is not a number stays so: its upper half says it.
  const bool up = std::isfinite(value) && bits % k_half != 0;
  return static_cast<std::uint16_t>(bits / k_half + (up ? 1 : 0));
}

}  // namespace

Channels::Channels(const sim::RunInfo& info, const std::vector<std::string>& vessel_names)
    : num_vessel_(vessel_names.size()),
      num_modules_(info.module_columns.size()),
      num_structures_(info.structures.size()),
      course_(info.drift_course) {
  for (const auto& name : vessel_names) add(name, group_of(name));
  for (const auto& structure : info.structures)
    for (const auto load : k_structure_loads) add(structure.name + "_" + std::string(load), "load");
  for (const auto& name : info.module_columns) add(name, "module");
  for (const char* name : {"floes", "contacts", "islands", "iterations", "law_map_m_s", "penetration_max_m"})
    add(name, "solver");
  for (const char* name : {"kinetic_J", "potential_J", "imbalance_J"}) add(name, "energy");
  for (int phase = 0; phase < sim::k_num_phases; ++phase) {
    list_.push_back({sim::to_string(static_cast<sim::Phase>(phase)), "ms", "time"});
  }
  now_.resize(list_.size(), std::numeric_limits<double>::quiet_NaN());
  least_ = most_ = now_;
}

void Channels::add(const std::string& name_with_unit, const char* group) {
  for (const auto unit : k_units) {
    const std::string tail = "_" + std::string(unit);
    if (!name_with_unit.ends_with(tail)) continue;
    list_.push_back({name_with_unit.substr(0, name_with_unit.size() - tail.size()), std::string(unit), group});
    return;
  }
  list_.push_back({name_with_unit, "", group});
}

void Channels::note(const sim::StepRecord& record, const std::vector<double>& vessel_values) {
  NILAS_DEMAND(vessel_values.size() == num_vessel_ && record.module_values.size() == num_modules_);
  now_.clear();
  now_.insert(now_.end(), vessel_values.begin(), vessel_values.end());
  const auto& names = structure_load_names();
  for (std::size_t s = 0; s < num_structures_; ++s) {
    // The integrator "reference" gives no loads on structures.
    if (s >= record.structures.size()) {
      now_.insert(now_.end(), k_structure_loads.size(), 0);
      continue;
    }
    const std::vector<double> loads = structure_loads(record.structures[s], course_);
    for (const auto load : k_structure_loads)
      now_.push_back(loads[static_cast<std::size_t>(std::find(names.begin(), names.end(), load) - names.begin())]);
  }
  now_.insert(now_.end(), record.module_values.begin(), record.module_values.end());
  for (const int count : {record.floes, record.contacts, record.islands, record.iterations}) now_.push_back(count);
  now_.insert(now_.end(), {record.residuals.law_map_m_s, record.penetration_max, record.ledger.kinetic,
                           record.ledger.potential, record.ledger.imbalance});
  now_.insert(now_.end(), record.ms.begin(), record.ms.end());
  NILAS_DEMAND(now_.size() == list_.size());
  for (std::size_t c = 0; c < now_.size(); ++c) {
    least_[c] = fresh_ ? now_[c] : std::min(least_[c], now_[c]);
    most_[c] = fresh_ ? now_[c] : std::max(most_[c], now_[c]);
  }
  fresh_ = false;
}

void Channels::save(StateWriter out) const {
  out.add("now", now_);
  out.add("least", least_);
  out.add("most", most_);
  out.add("fresh", fresh_);
}

void Channels::restore(const StateReader& in) {
  in.get("now", now_);
  in.get("least", least_);
  in.get("most", most_);
  in.get("fresh", fresh_);
  for (const auto& values : {now_, least_, most_})
    if (values.size() != list_.size()) throw InputError("the checkpoint has other channels of the replay");
}

void Channels::add_to(std::string& out) {
  for (std::size_t c = 0; c < now_.size(); ++c) {
    add_float(now_[c], out);
    // As readers have it, so that the range holds all values.
    const auto shown = static_cast<double>(static_cast<float>(now_[c]));
    add_number(rounded_up(std::max(0.0, shown - least_[c])), out);
    add_number(rounded_up(std::max(0.0, most_[c] - shown)), out);
  }
  fresh_ = true;
}

}  // namespace nilas::output::replay
