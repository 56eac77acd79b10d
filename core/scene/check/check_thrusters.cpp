#include <algorithm>
#include <cmath>

#include "core/base/math.h"
#include "core/choices/thruster_choices.h"
#include "core/scene/check/cross_checks.h"
#include "core/scene/scene.h"
#include "core/scene/schema/attribute_values.h"
#include "core/scene/spec/values.h"

namespace nilas::scene {

/// Forbidden sectors come in pairs, have a width and lie beside each other.
static void check_sectors(const SceneElement& thruster, std::vector<Fault>& faults) {
  const auto sectors = numbers_of(thruster, "forbidden_deg");
  if (!sectors) return;
  const auto refuse = [&](const std::string& message) {
    faults.push_back(fault_of(thruster, "forbidden_deg", message));
  };
  if (sectors->size() % 2 != 0)
    return refuse("found " + std::to_string(sectors->size()) + " numbers; allowed: pairs of from and to");
  constexpr double k_circle = 360;
  const auto beyond = [](double angle, double from) {
    const double rest = std::fmod(angle - from, k_circle);
    return rest < 0 ? rest + k_circle : rest;
  };
  const auto pair = [&](std::size_t k) {
    return "'" + format_number(sectors->at(k)) + " " + format_number(sectors->at(k + 1)) + "'";
  };
  for (std::size_t k = 0; k < sectors->size(); k += 2) {
    const double from = sectors->at(k), width = beyond(sectors->at(k + 1), from);
    if (width == 0) return refuse("found " + pair(k) + ", a sector without width or a whole turn; allowed: two angles");
    for (std::size_t other = 0; other < sectors->size(); other += 2)
      if (other != k && beyond(sectors->at(other), from) < width)
        return refuse("found " + pair(k) + " and " + pair(other) + ", which overlap; allowed: one sector for both");
  }
}

static void check_thruster(const SceneElement& thruster, std::vector<Fault>& faults) {
  const auto kind = choice_of<ThrusterKind>(thruster, "kind");
  if (kind == ThrusterKind::propeller_rudder)
    for (const char* needed : {"rudder_area", "rudder_span", "rudder_distance", "diameter"})
      if (!is_named(thruster, needed))
        faults.push_back(
            fault_of(thruster, "a propeller with rudder needs " + std::string(needed) + "; allowed: a number > 0"));
  check_sectors(thruster, faults);
  if (is_named(thruster, "free_speed") && is_named(thruster, "loss_table"))
    faults.push_back(fault_of(thruster, "loss_table", "found free_speed and loss_table; allowed: one of them"));
  const auto ahead = number_of(thruster, "max_thrust"), thrust = number_of(thruster, "thrust");
  const auto astern = number_of(thruster, "max_astern");
  if (ahead && thrust && (*thrust > *ahead || *thrust < -astern.value_or(*ahead)))
    faults.push_back(fault_of(thruster, "thrust",
                              "found " + format_number(*thrust) + "; allowed: " +
                                  format_number(-astern.value_or(*ahead)) + " to " + format_number(*ahead) + " [N]"));
}

static void check_thruster_names(const SceneElement& vessel, const SceneElement& thrusters,
                                 std::vector<Fault>& faults) {
  std::vector<std::string> taken;
  for (const auto& thruster : thrusters.children) {
    const auto name = text_of(thruster, "name");
    if (!name) continue;
    if (std::find(taken.begin(), taken.end(), *name) != taken.end())
      faults.push_back(fault_of(thruster, "name", "found '" + *name + "' twice; names of thrusters must be unique"));
    if (*name == "propeller" && is_named(vessel, "manoeuvring"))
      faults.push_back(
          fault_of(thruster, "name", "found 'propeller', which is that of <manoeuvring>; allowed: another name"));
    taken.push_back(*name);
  }
}

/// The motion that no combination of the thrusters can give apart from the others; empty where they give all three. The
/// rank of their loads does not depend on the point to which moments refer.
static std::string missing_motion(const SceneElement& thrusters) {
  std::vector<Vec3> loads;
  for (const auto& thruster : thrusters.children) {
    const auto kind = choice_of<ThrusterKind>(thruster, "kind");
    const auto at = numbers_of(thruster, "at");
    if (!kind || !at) return {};
    if (*kind != ThrusterKind::tunnel) loads.emplace_back(1, 0, -at->at(1));
    if (*kind == ThrusterKind::tunnel || *kind == ThrusterKind::azimuth || *kind == ThrusterKind::propeller_rudder)
      loads.emplace_back(0, 1, at->at(0));
  }
  if (std::all_of(loads.begin(), loads.end(), [](const Vec3& load) { return load.x() == 0; })) return "surge";
  if (std::all_of(loads.begin(), loads.end(), [](const Vec3& load) { return load.y() == 0; })) return "sway";
  MatX all(3, static_cast<Eigen::Index>(loads.size()));
  double arm = 0;
  for (std::size_t k = 0; k < loads.size(); ++k) {
    all.col(static_cast<Eigen::Index>(k)) = loads[k];
    arm = std::max(arm, std::abs(loads[k].z()));
  }
  if (arm > 0) all.row(2) /= arm;
  return Eigen::FullPivLU<MatX>(all).rank() < 3 ? "yaw" : "";
}

static void check_control(const SceneElement& root, const SceneElement& vessel, const SceneElement& control,
                          std::vector<Fault>& faults) {
  if (choice_of<ControlMode>(control, "mode") != ControlMode::dp) return;
  const SceneElement* time = child_of(root, "time");
  const double step = time ? number_of(*time, "step").value_or(TimeScene{}.step) : TimeScene{}.step;
  const auto period = number_of(control, "sensor_period");
  if (period && *period < step)
    faults.push_back(fault_of(control, "sensor_period",
                              "found " + format_number(*period) + ", shorter than the time step; allowed: at least " +
                                  format_number(step) + " [s]"));
  for (const char* replaced : {"setpoint", "heading_deg"})
    if (attribute_of(control, "path") && attribute_of(control, replaced))
      faults.push_back(
          fault_of(control, replaced, std::string("found path and ") + replaced + "; allowed: one of them"));
  const SceneElement* thrusters = child_of(vessel, "thrusters");
  if (!thrusters) {
    if (!is_misspelt(vessel, "thrusters"))
      faults.push_back(fault_of(control, "mode", "dynamic positioning needs <thrusters>; allowed: none"));
    return;
  }
  if (const std::string missing = missing_motion(*thrusters); !missing.empty())
    faults.push_back(fault_of(*thrusters, "no thruster gives " + missing +
                                              " apart from the other motions, which dynamic positioning needs; "
                                              "allowed: thrusters that give surge, sway and yaw"));
}

void check_thrusters(const SceneElement& root, const SceneElement& vessel, std::vector<Fault>& faults) {
  const SceneElement *thrusters = child_of(vessel, "thrusters"), *control = child_of(vessel, "control");
  if (control) check_control(root, vessel, *control, faults);
  if (!thrusters) return;
  for (const char* holder : {"carriage", "fixed"})
    if (child_of(vessel, holder))
      faults.push_back(fault_of(
          *thrusters, std::string("found <thrusters> and <") + holder + ">; allowed: thrusters on a free vessel"));
  if (thrusters->children.empty())
    faults.push_back(fault_of(*thrusters, "found no thruster; allowed: one <thruster> or more"));
  for (const auto& thruster : thrusters->children) check_thruster(thruster, faults);
  check_thruster_names(vessel, *thrusters, faults);
  const SceneElement* contact = child_of(root, "contact");
  if (contact && text_of(*contact, "integrator") == "reference")
    faults.push_back(fault_of(*thrusters,
                              "integrator 'reference' does not take <thrusters>, whose thrust follows commands from "
                              "step to step; allowed: semi-implicit-euler, moreau"));
}

}  // namespace nilas::scene
