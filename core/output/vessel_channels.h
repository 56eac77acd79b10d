#pragma once
/// What the outputs say about the vessel after each step: the one table of names and values.
#include <string>
#include <vector>

#include "core/sim/step_record.h"

namespace nilas {

/// Channels of the modules that a scene uses, loads first, then motion; units are in the names, angles in degrees.
class VesselChannels {
 public:
  explicit VesselChannels(const RunInfo& info);

  const std::vector<std::string>& names() const { return names_; }
  /// The first so many channels are loads on the vessel.
  int num_loads() const { return num_loads_; }
  /// Values in the order of names(). Returns false at gimbal lock, where the angular rates are written as zero.
  bool read(const VesselRecord& record, std::vector<double>& values) const;

 private:
  void name_wrench(const std::string& source);

  std::vector<std::string> names_;
  int num_loads_ = 0;
  bool has_carriage_ = false, has_cells_ = false, has_hydro_ = false;
};

}  // namespace nilas
