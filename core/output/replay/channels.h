#pragma once
/// The numbers that a replay draws over time. A frame has their value and their range since the frame before, so no
/// peak between two frames is lost.
#include <cstddef>
#include <string>
#include <vector>

#include "core/base/state.h"
#include "core/sim/account/step_record.h"

namespace nilas::output::replay {

struct Channel {
  std::string name;   ///< as in the tables of the run, without its unit: ice_resistance
  std::string unit;   ///< N, Nm, m, deg ...; empty for pure numbers
  std::string group;  ///< load, cell, motion, solver, energy, time or module
};

class Channels {
 public:
  /// `vessel_names`: the columns of vessel.csv without time, empty without a vessel.
  Channels(const sim::RunInfo& info, const std::vector<std::string>& vessel_names);

  const std::vector<Channel>& list() const { return list_; }
  /// Takes the values of a step. `vessel_values`: in the order of the names.
  void note(const sim::StepRecord& record, const std::vector<double>& vessel_values);
  void save(StateWriter out) const;
  void restore(const StateReader& in);
  /// Appends the value of each channel and how far it was below and above since the last time, and begins anew. Before
  /// the first step the values are not a number.
  void add_to(std::string& out);

 private:
  void add(const std::string& name_with_unit, const char* group);

  std::vector<Channel> list_;
  std::vector<double> now_, least_, most_;
  std::size_t num_vessel_ = 0, num_modules_ = 0, num_structures_ = 0;
  Vec2 course_;
  bool fresh_ = true;
};

}  // namespace nilas::output::replay
