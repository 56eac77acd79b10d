#pragma once
/// Named values that one part of the program sets and another reads: what controllers ask of rudders, propellers and
/// thrusters, and what these measure of themselves.
#include <string>
#include <vector>

#include "core/base/state.h"

namespace nilas {

class Channels {
 public:
  /// Appends a channel and returns its index. Throws ContractError where the name exists already. `unit`: SI; empty
  /// for a pure number.
  int add(const std::string& name, const std::string& unit, double value);
  /// The same for a value that an actuator measures and no controller may set.
  int add_measured(const std::string& name, const std::string& unit, double value);
  /// The index of a channel; -1 where there is none of this name.
  int find(const std::string& name) const;
  int size() const { return static_cast<int>(values_.size()); }
  const std::string& name(int k) const { return names_[k]; }
  const std::string& unit(int k) const { return units_[k]; }
  /// Whether controllers may set it.
  bool is_command(int k) const { return !measured_[k]; }
  double operator[](int k) const { return values_[k]; }
  /// Throws ContractError for a number that is not finite.
  void set(int k, double value);

  void save(StateWriter out) const;
  void restore(const StateReader& in);

 private:
  std::vector<std::string> names_, units_;
  std::vector<bool> measured_;
  std::vector<double> values_;
};

}  // namespace nilas
