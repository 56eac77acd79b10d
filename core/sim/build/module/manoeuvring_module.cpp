#include "core/sim/build/module/manoeuvring_module.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "core/base/error.h"
#include "hydro/manoeuvring/manoeuvring.h"
#include "hydro/manoeuvring/ship_file.h"
#include "hydro/manoeuvring/ship_presets.h"
#include "hydro/manoeuvring/steering.h"

namespace nilas::sim {

namespace {

hydro::ManoeuvringShip preset_ship(const scene::ManoeuvringScene& given, double gravity, double scale) {
  switch (given.preset.value()) {
    case ManoeuvringPreset::kvlcc2:
      return hydro::kvlcc2(given.length.value_or(hydro::k_kvlcc2_length * scale));
    case ManoeuvringPreset::supply:
      return hydro::supply_vessel(given.length.value_or(hydro::k_supply_length * scale), gravity);
  }
  return {};
}

hydro::ManoeuvringShip ship_of(const ModuleSources& from) {
  const scene::ManoeuvringScene& given = *from.scene.vessel->manoeuvring;
  // Without weight, the bis system still needs a unit of acceleration.
  const double weight = from.scene.gravity.norm(), gravity = weight > 0 ? weight : defaults::k_gravity;
  if (given.preset) return preset_ship(given, gravity, from.scene.scale);
  return scaled(hydro::read_ship(given.file, given.model, given.propulsion, gravity), from.scene.scale);
}

/// x of the point amidships in body axes, from the centre of mass.
double midship_of(const ModuleSources& from) {
  const scene::ManoeuvringScene& given = *from.scene.vessel->manoeuvring;
  if (given.midship) return *given.midship - from.parts.vessel_model->mass.com.x();
  const auto& vertices = from.parts.bodies.shape[static_cast<std::size_t>(from.parts.vessel_index)]->surface.vertices;
  const auto [aft, fore] =
      std::minmax_element(vertices.begin(), vertices.end(), [](const Vec3& a, const Vec3& b) { return a.x() < b.x(); });
  return 0.5 * (aft->x() + fore->x());
}

/// The initial speed ahead through the water, not below 0.
double initial_speed(const ModuleSources& from) {
  const Vec3 through_water = from.scene.vessel->velocity - from.parts.water->current;
  return std::max(through_water.head<2>().dot(direction_of(from.scene.vessel->heading_deg * k_deg)), 0.0);
}

/// The rate of revolutions that holds a speed; the message of a speed that is too high names the element.
double rate_for(const ModuleSources& from, const hydro::ManoeuvringShip& ship, double speed,
                const std::string& element) {
  try {
    return hydro::self_propulsion(ship, from.parts.water->density, speed);
  } catch (const InputError& fault) {
    throw InputError(from.scene.file.string() + ": " + element + ": " + fault.what());
  }
}

double froude_time(double length) { return std::sqrt(length / defaults::k_gravity); }

std::vector<hydro::CourseOrder> course_orders(const ModuleSources& from) {
  const scene::ManoeuvreScene& given = *from.scene.vessel->manoeuvre;
  if (!given.file.empty()) return hydro::read_course_orders(given.file, from.scene.scale);
  return {{from.scene.time.start, given.heading_deg.value_or(from.scene.vessel->heading_deg) * k_deg,
           given.speed.value_or(initial_speed(from))}};
}

hydro::AutopilotGains autopilot_gains(const ModuleSources& from, const hydro::ManoeuvringShip& ship,
                                      const std::vector<hydro::CourseOrder>& orders) {
  // In L/V. With them KVLCC2, which is unstable on a straight course, swings 9 % past a change of heading.
  constexpr double k_yaw_lengths = 3, k_heading_lengths = 50;
  // The loop of speed is m s^2 + (P + D) s + P / T_s, with the gain P and the damping D of thrust and resistance in N
  // per m/s. By estimate its damping ratio at 3 L/V is about 1 for an icebreaker on its thrust curve at 3 m/s.
  constexpr double k_speed_lengths = 3;
  constexpr double k_slow = 0.01;  // least Froude number for L/V, so that a stop has gains
  const scene::ManoeuvreScene& given = *from.scene.vessel->manoeuvre;
  double fastest = 0;
  for (const hydro::CourseOrder& order : orders) fastest = std::max(fastest, order.speed);
  const double L = ship.length(), time = L / std::max(fastest, k_slow * L / froude_time(L));
  hydro::AutopilotGains gains;
  gains.heading_gain = given.heading_gain;
  gains.yaw_rate_gain = given.yaw_rate_gain.value_or(k_yaw_lengths * time);
  gains.heading_time = given.heading_time.value_or(k_heading_lengths * time);
  gains.speed_gain = given.speed_gain;
  gains.speed_time = given.speed_time.value_or(k_speed_lengths * time);
  if (fastest > 0) gains.rps_per_speed = rate_for(from, ship, fastest, "<vessel><manoeuvre speed>") / fastest;
  gains.max_rudder = from.scene.vessel->manoeuvring->max_rudder_deg * k_deg;
  gains.max_rps = ship.max_rps;
  return gains;
}

/// A manoeuvre that steers needs a ship that does.
void demand_rudder(const ModuleSources& from, const hydro::ManoeuvringShip& ship) {
  const scene::ManoeuvreScene& given = *from.scene.vessel->manoeuvre;
  if (given.kind == ManoeuvreKind::straight || ship.steers()) return;
  const scene::ManoeuvringScene& hull = *from.scene.vessel->manoeuvring;
  throw InputError(fmt::format(
      "{}: <vessel><manoeuvre kind>: found '{}', but {} has no rudder; allowed: kind=\"{}\", or a file of a ship with "
      "rudder_area_m2 or with derivatives of the rudder angle such as N_d",
      from.scene.file.string(), name_of(given.kind),
      hull.preset ? "the preset '" + name_of(*hull.preset) + "'" : "the ship of " + hull.file,
      name_of(ManoeuvreKind::straight)));
}

std::unique_ptr<hydro::Manoeuvre> manoeuvre_of(const ModuleSources& from, const hydro::ManoeuvringShip& ship) {
  const scene::ManoeuvreScene& given = *from.scene.vessel->manoeuvre;
  const hydro::ManoeuvreFrame frame{ship.length(), from.parts.water->current.head<2>()};
  switch (given.kind) {
    case ManoeuvreKind::straight:
      return hydro::make_straight(frame);
    case ManoeuvreKind::turning_circle:
      return hydro::make_turning_circle(frame, given.angle_deg.value_or(scene::k_circle_rudder_deg) * k_deg);
    case ManoeuvreKind::zigzag: {
      const double angle_deg = given.angle_deg.value_or(scene::k_zigzag_rudder_deg);
      return hydro::make_zigzag(frame, angle_deg * k_deg, given.heading_deg.value_or(std::abs(angle_deg)) * k_deg);
    }
    case ManoeuvreKind::course: {
      std::vector<hydro::CourseOrder> orders = course_orders(from);
      const hydro::AutopilotGains gains = autopilot_gains(from, ship, orders);
      return hydro::make_course(frame, std::move(orders), gains);
    }
  }
  return nullptr;
}

}  // namespace

BuiltModule build_manoeuvring(const ModuleSources& from) {
  if (!from.scene.vessel || !from.scene.vessel->manoeuvring) return {};
  NILAS_DEMAND(from.parts.water && from.parts.vessel_index >= 0);
  const scene::ManoeuvringScene& given = *from.scene.vessel->manoeuvring;
  hydro::ManoeuvringSettings settings;
  settings.ship = ship_of(from);
  settings.vessel = from.parts.vessel_index;
  settings.density = from.parts.water->density;
  settings.current = from.parts.water->current;
  settings.midship = midship_of(from);
  settings.rudder_rate = given.rudder_rate_deg_s * k_deg;
  settings.max_rudder = given.max_rudder_deg * k_deg;
  settings.propeller_rate =
      given.propeller_rate.value_or(settings.ship.max_rps / (2 * froude_time(settings.ship.length())));
  settings.rps =
      given.propeller ? *given.propeller : rate_for(from, settings.ship, initial_speed(from), "<vessel velocity>");
  if (settings.rps > settings.ship.max_rps)
    throw InputError(fmt::format("{}: <vessel><manoeuvring propeller>: found {:g} 1/s; allowed: at most {:g} 1/s",
                                 from.scene.file.string(), settings.rps, settings.ship.max_rps));
  std::string reason = "<manoeuvring>: model " + name_of(given.model) + ", " +
                       (given.preset ? name_of(*given.preset) : given.file) +
                       fmt::format(", propeller at {:.4g} 1/s", settings.rps);
  if (from.scene.hydro && from.scene.hydro->drag) reason += "; <drag> leaves surge, sway and yaw of the vessel out";
  return {hydro::make_manoeuvring(std::move(settings), from.parts.commands), reason};
}

BuiltModule build_manoeuvre(const ModuleSources& from) {
  if (!from.scene.vessel || !from.scene.vessel->manoeuvre) return {};
  const scene::ManoeuvreScene& given = *from.scene.vessel->manoeuvre;
  hydro::SteeringSettings settings;
  settings.vessel = from.parts.vessel_index;
  settings.midship = midship_of(from);
  settings.current = from.parts.water->current;
  settings.start = given.start.value_or(from.scene.time.start);
  const hydro::ManoeuvringShip ship = ship_of(from);
  demand_rudder(from, ship);
  return {hydro::make_steering(settings, manoeuvre_of(from, ship), from.parts.commands),
          fmt::format("<manoeuvre>: {} from {:g} s", name_of(given.kind), settings.start)};
}

}  // namespace nilas::sim
