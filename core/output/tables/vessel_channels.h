#pragma once
/// The channels of the vessel: the one table of names and values for all outputs.
#include <array>
#include <string>
#include <vector>

#include "core/sim/account/step_record.h"

namespace nilas::output {

/// Number of loads along and across the course: ice_resistance_N, positive astern, and ice_side_N, positive to port.
constexpr std::size_t k_num_course_loads = 2;

/// Channels of the modules that a scene uses: loads along the global axes, motion, then the contact load along and
/// across the course. Units are in the names, angles in degrees.
class VesselChannels {
 public:
  explicit VesselChannels(const sim::RunInfo& info);

  const std::vector<std::string>& names() const { return names_; }
  /// Names of the channels that are loads: those along the global axes, the tared cells, then those along and across
  /// the course.
  std::vector<std::string> load_names() const;
  /// Values of the load channels, from all values as given by read().
  std::vector<double> loads(const std::vector<double>& values) const;
  /// Writes the values in the order of names(). Returns false at gimbal lock, where the angular rates are zero.
  bool read(const sim::VesselRecord& record, std::vector<double>& values) const;

 private:
  static constexpr int k_num_cells = 6;

  void name_wrench(const std::string& source);
  template <class Value>
  std::vector<Value> loads_among(const std::vector<Value>& channels) const;

  std::vector<std::string> names_;
  std::array<double, k_num_cells> tare_{};
  std::size_t first_cell_ = 0;
  std::size_t num_global_loads_ = 0;
  std::size_t num_modules_ = 0;
  bool has_carriage_ = false, has_cells_ = false, has_hydro_ = false;
};

}  // namespace nilas::output
