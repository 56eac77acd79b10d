#include "hydro/manoeuvring/ship_file.h"

#include <cmath>
#include <functional>
#include <map>
#include <sstream>

#include "core/base/csv.h"
#include "core/base/error.h"
#include "core/base/file_bytes.h"

namespace nilas::hydro {

namespace {

/// A number that a file may hold.
struct NamedNumber {
  std::string name;
  double* place;
  bool required = false;
  bool positive = false;
};

std::vector<NamedNumber> numbers_in(MmgHull& hull) {
  return {{"length_m", &hull.length, true, true},
          {"draught_m", &hull.draught, true, true},
          {"m_x", &hull.m_x, true, true},
          {"m_y", &hull.m_y, true, true},
          {"J_z", &hull.J_z, true, true},
          {"R_0", &hull.R_0},
          {"X_vv", &hull.X_vv},
          {"X_vr", &hull.X_vr},
          {"X_rr", &hull.X_rr},
          {"X_vvvv", &hull.X_vvvv},
          {"Y_v", &hull.Y_v, true},
          {"Y_r", &hull.Y_r, true},
          {"Y_vvv", &hull.Y_vvv},
          {"Y_vvr", &hull.Y_vvr},
          {"Y_vrr", &hull.Y_vrr},
          {"Y_rrr", &hull.Y_rrr},
          {"N_v", &hull.N_v, true},
          {"N_r", &hull.N_r, true},
          {"N_vvv", &hull.N_vvv},
          {"N_vvr", &hull.N_vvr},
          {"N_vrr", &hull.N_vrr},
          {"N_rrr", &hull.N_rrr}};
}

std::vector<NamedNumber> numbers_in(DerivativesHull& hull) {
  const bool bis = hull.scaling == DerivativeScaling::bis, draught = hull.scaling == DerivativeScaling::prime_draught;
  return {{"length_m", &hull.length, true, true},
          {"draught_m", &hull.draught, draught, draught},
          {"mass_kg", &hull.mass, bis, bis},
          {"reference_speed_m_s", &hull.reference_speed},
          {"X_udot", &hull.X_udot},
          {"Y_vdot", &hull.Y_vdot},
          {"Y_rdot", &hull.Y_rdot},
          {"N_vdot", &hull.N_vdot},
          {"N_rdot", &hull.N_rdot}};
}

std::vector<NamedNumber> numbers_in(OpenWaterPropeller& propeller) {
  return {{"propeller_diameter_m", &propeller.diameter, true, true},
          {"k_0", &propeller.k_0, true, true},
          {"k_1", &propeller.k_1, true},
          {"k_2", &propeller.k_2, true},
          {"t_P", &propeller.t_P},
          {"w_P0", &propeller.w_P0},
          {"C_1", &propeller.C_1},
          {"C_2_plus", &propeller.C_2_plus},
          {"C_2_minus", &propeller.C_2_minus},
          {"x_P", &propeller.x_P}};
}

/// What a thrust curve may be given by, beside its own numbers.
struct PullByPower {
  double power = 0, screws = 0;
};

std::vector<NamedNumber> numbers_in(ThrustCurve& curve, PullByPower& by) {
  return {{"pull_N", &curve.pull},
          {"power_W", &by.power},
          {"screws", &by.screws},
          {"propeller_diameter_m", &curve.diameter},
          {"pull_a_1", &curve.a_1},
          {"pull_a_2", &curve.a_2},
          {"max_speed_m_s", &curve.max_speed, true, true}};
}

std::vector<NamedNumber> numbers_in(MmgRudder& rudder) {
  return {{"rudder_area_m2", &rudder.area, true, true},
          {"f_alpha", &rudder.f_alpha, true, true},
          {"eta", &rudder.eta},
          {"kappa", &rudder.kappa},
          {"epsilon", &rudder.epsilon},
          {"t_R", &rudder.t_R},
          {"a_H", &rudder.a_H},
          {"x_H", &rudder.x_H},
          {"x_R", &rudder.x_R},
          {"l_R", &rudder.l_R},
          {"gamma_plus", &rudder.gamma_plus},
          {"gamma_minus", &rudder.gamma_minus}};
}

/// The entries of a file, each of which is to be used once.
class ShipEntries {
 public:
  explicit ShipEntries(const std::string& file) : file_(file) {
    std::istringstream lines(file_bytes(file, k_most_text_bytes));
    int number = 0;
    bool header = false;
    CsvLine fields;
    for (std::string line; std::getline(lines, line);) {
      ++number;
      if (!line.empty() && line.back() == '\r') line.pop_back();
      const auto first = line.find_first_not_of(" \t");
      if (first == std::string::npos || line[first] == '#') continue;
      fields.split(line);
      if (fields.size() != 2)
        refuse_line(number, "found " + std::to_string(fields.size()) + " fields; allowed: name,value");
      const std::string name = trimmed(fields[0]), value = trimmed(fields[1]);
      if (!header) {
        if (name != "name" || value != "value")
          refuse_line(number, "found the header '" + line + "'; allowed: name,value");
        header = true;
        continue;
      }
      if (const auto before = entries_.find(name); before != entries_.end())
        refuse_line(number, "'" + name + "' stands in line " + std::to_string(before->second.line) + " already");
      entries_[name] = {value, number};
    }
  }

  /// Reads all of these numbers that the file has.
  void take(const std::vector<NamedNumber>& numbers) {
    for (const NamedNumber& number : numbers) {
      known_.push_back(number.name);
      const auto entry = entries_.find(number.name);
      if (entry == entries_.end()) {
        if (number.required) throw InputError(file_ + ": '" + number.name + "' is missing");
        continue;
      }
      *number.place = number_in(entry->first, entry->second);
      if (number.positive && !(*number.place > 0))
        refuse_line(entry->second.line, "'" + number.name + "' is " + entry->second.value + "; allowed: > 0");
      entries_.erase(entry);
    }
  }

  bool has(const std::string& name) const { return entries_.count(name) > 0; }

  /// Takes the text of an entry; empty where there is none.
  std::string take_text(const std::string& name) {
    known_.push_back(name);
    const auto entry = entries_.find(name);
    if (entry == entries_.end()) return {};
    std::string text = entry->second.value;
    entries_.erase(entry);
    return text;
  }

  /// Takes all that are names of terms.
  std::vector<DerivativeTerm> take_terms() {
    std::vector<DerivativeTerm> terms;
    for (auto entry = entries_.begin(); entry != entries_.end();) {
      auto term = derivative_term(entry->first);
      if (!term) {
        ++entry;
        continue;
      }
      term->value = number_in(entry->first, entry->second);
      terms.push_back(*term);
      entry = entries_.erase(entry);
    }
    return terms;
  }

  /// Throws where an entry is left.
  void demand_empty() const {
    if (entries_.empty()) return;
    const auto& [name, entry] = *entries_.begin();
    const std::string nearest = nearest_name(name, known_);
    refuse_line(entry.line, "unknown name '" + name + "' for this model, propulsion and rudder" +
                                (nearest.empty() ? "" : "; nearest: " + nearest));
  }

  [[noreturn]] void refuse(const std::string& fault) const { throw InputError(file_ + ": " + fault); }

 private:
  struct Entry {
    std::string value;
    int line = 0;
  };

  static std::string trimmed(std::string_view text) {
    const auto first = text.find_first_not_of(" \t"), last = text.find_last_not_of(" \t");
    return first == std::string_view::npos ? std::string() : std::string(text.substr(first, last - first + 1));
  }
  double number_in(const std::string& name, const Entry& entry) const {
    const double value = csv_number(entry.value);
    if (!std::isfinite(value))
      refuse_line(entry.line, "'" + name + "' is '" + entry.value + "'; allowed: a finite number");
    return value;
  }
  [[noreturn]] void refuse_line(int line, const std::string& fault) const {
    throw InputError(file_ + ":" + std::to_string(line) + ": " + fault);
  }

  std::string file_;
  std::map<std::string, Entry> entries_;
  std::vector<std::string> known_;
};

DerivativesHull derivatives_in(ShipEntries& entries, double gravity) {
  DerivativesHull hull;
  const std::string scaling = entries.take_text("scaling");
  const auto found = find_choice<DerivativeScaling>(scaling);
  if (!found) {
    std::string allowed;
    for (const std::string& name : choice_names<DerivativeScaling>()) allowed += (allowed.empty() ? "" : ", ") + name;
    entries.refuse((scaling.empty() ? "'scaling' is missing" : "scaling is '" + scaling + "'") +
                   "; allowed: " + allowed);
  }
  hull.scaling = *found;
  hull.gravity = gravity;
  entries.take(numbers_in(hull));
  hull.terms = entries.take_terms();
  return hull;
}

ThrustCurve thrust_curve_in(ShipEntries& entries) {
  ThrustCurve curve;
  PullByPower by;
  const bool given = entries.has("pull_N"), by_power = entries.has("power_W");
  entries.take(numbers_in(curve, by));
  if (given == by_power) entries.refuse("found both or none of pull_N and power_W; allowed: one of them");
  if (by_power && !(by.power > 0 && curve.diameter > 0))
    entries.refuse("with power_W, allowed: power_W > 0 and propeller_diameter_m > 0");
  if (by_power) curve.pull = bollard_pull(by.power, curve.diameter, static_cast<int>(std::lround(by.screws)));
  if (!(curve.pull > 0)) entries.refuse("the bollard pull is not above 0");
  if (!(curve.a_1 >= 0 && curve.a_2 > 0)) entries.refuse("allowed: pull_a_1 >= 0 and pull_a_2 > 0");
  return curve;
}

}  // namespace

ManoeuvringShip read_ship(const std::string& file, ManoeuvringModel model, PropulsionKind propulsion, double gravity) {
  ShipEntries entries(file);
  ManoeuvringShip ship;
  if (model == ManoeuvringModel::mmg)
    entries.take(numbers_in(ship.hull.emplace<MmgHull>()));
  else
    ship.hull = derivatives_in(entries, gravity);
  entries.take({{"max_rps", &ship.max_rps, true, true}});
  if (propulsion == PropulsionKind::open_water) {
    entries.take(numbers_in(ship.propulsion.emplace<OpenWaterPropeller>()));
  } else {
    ship.propulsion = thrust_curve_in(entries);
    std::get<ThrustCurve>(ship.propulsion).max_rps = ship.max_rps;
  }
  if (entries.has("rudder_area_m2")) entries.take(numbers_in(ship.rudder.emplace()));
  entries.demand_empty();
  const PlanarAddedMass added = planar_added_mass(ship, 1);
  if (!(added.surge >= 0 && added.sway >= 0 && added.yaw >= 0 &&
        added.sway_yaw * added.sway_yaw <= added.sway * added.yaw))
    entries.refuse("the added mass is not positive; allowed: X_udot, Y_vdot, N_rdot <= 0 and a coupling below both");
  return ship;
}

}  // namespace nilas::hydro
