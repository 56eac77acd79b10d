#include "core/base/channels.h"

#include <algorithm>
#include <cmath>

#include "core/base/error.h"

namespace nilas {

int Channels::add(const std::string& name, const std::string& unit, double value) {
  NILAS_DEMAND(find(name) < 0 && std::isfinite(value));
  names_.push_back(name);
  units_.push_back(unit);
  measured_.push_back(false);
  values_.push_back(value);
  return size() - 1;
}

int Channels::add_measured(const std::string& name, const std::string& unit, double value) {
  const int k = add(name, unit, value);
  measured_[k] = true;
  return k;
}

int Channels::find(const std::string& name) const {
  const auto found = std::find(names_.begin(), names_.end(), name);
  return found == names_.end() ? -1 : static_cast<int>(found - names_.begin());
}

void Channels::set(int k, double value) {
  NILAS_DEMAND(k >= 0 && k < size() && std::isfinite(value));
  values_[k] = value;
}

void Channels::save(StateWriter out) const { out.add("values", values_); }

void Channels::restore(const StateReader& in) { in.get("values", values_, values_.size()); }

}  // namespace nilas
