#include "core/sim/build/implausible.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "contact/detect/detector.h"
#include "core/scene/time_steps.h"
#include "core/sim/build/natural_periods.h"
#include "core/sim/build/vessel_doubts.h"
#include "core/sim/build/water_doubts.h"
#include "core/sim/world/course.h"

namespace nilas::sim {

namespace {

/// Rounds to two digits by floor or ceil, so that advice stays on the safe side.
double two_digits(double x, double (*round)(double)) {
  const double unit = std::pow(10, std::floor(std::log10(x)) - 1);
  return round(x / unit) * unit;
}

/// The largest share of the speed that can remain after a ramp as swing of a mode with this period [s]. It is the
/// modulus of the Fourier transform of the acceleration, or a bound of it. With x = omega ramp: 2 sin(x/2) / x for a
/// linear ramp; 12/x^2 (2 sin(x/2) / x - cos(x/2)) for a smooth one.
double swing_after(const scene::CarriageScene& carriage, double period) {
  const double x = 2 * k_pi / period * carriage.ramp;
  constexpr double k_smooth = 12;
  switch (carriage.ramp_shape) {
    case RampShape::linear:
      return x > 0 ? 2 / x : 1;
    case RampShape::smooth:
      return x > 0 ? std::min(1.0, k_smooth / (x * x) * (1 + 2 / x)) : 1;
  }
  return 1;
}

/// Shortest ramp of the same shape that leaves at most `share` of the speed [s].
double gentle_ramp(const scene::CarriageScene& carriage, double period, double share) {
  constexpr double k_smooth = 12;
  const double x = carriage.ramp_shape == RampShape::smooth ? 1 + std::sqrt(k_smooth / share) : 2 / share;
  return x * period / (2 * k_pi);
}

class Doubts {
 public:
  Doubts(const scene::Scene& scene, const WorldParts& parts, std::vector<Fault>& warnings)
      : scene_(scene), parts_(parts), warnings_(warnings) {}

  void all() {
    ice();
    water();
    motion();
    course();
    towing();
    periods();
    structures();
    overlaps();
    hull();
  }

 private:
  void doubt(const std::string& path, const std::string& message) {
    warnings_.push_back(scene::warning_at(scene_, path, message));
  }

  void ice() {
    if (!scene_.ice || !parts_.water || scene_.ice->density < parts_.water->density) return;
    doubt("ice/@density",
          fmt::format("ice of {:g} kg/m^3 sinks in water of {:g} kg/m^3", scene_.ice->density, parts_.water->density));
  }

  bool falls(int b) const {
    const bodies::BodyKind kind = parts_.bodies.kind[b];
    return parts_.bodies.is_free(b) && (kind == bodies::BodyKind::floe || kind == bodies::BodyKind::vessel);
  }

  void water() {
    const bool buoyant = scene_.hydro && scene_.hydro->buoyancy;
    if (scene_.water && !scene_.hydro)
      doubt("water",
            "the scene has water but no <hydro>, so that water carries and moves nothing; add <hydro> with "
            "<buoyancy/> and <drag/>");
    if (buoyant || scene_.gravity.isZero(0)) return;
    long floes = 0;
    for (int b = 0; b < parts_.bodies.size(); ++b) floes += falls(b);
    if (floes > 0 && scene_.ice)
      doubt("ice",
            fmt::format("{} free floes have weight but no buoyancy, so they fall; add <hydro><buoyancy/>", floes));
    const bool restored = scene_.hydro && scene_.hydro->restoring;
    if (scene_.vessel && !scene_.vessel->fixed && !held_in_heave() && !restored)
      doubt("vessel", "the vessel has weight but no buoyancy, so it falls; add <hydro><buoyancy/>");
  }

  bool held_in_heave() const { return parts_.carriage && !parts_.carriage->free_in_heave(); }

  /// Whether the scene itself sets something in motion.
  bool drives() const {
    const auto moves = [](const auto& item) { return !item.velocity.isZero(0); };
    if (parts_.info.course == CourseKind::carriage) return true;
    if (scene_.vessel && (moves(*scene_.vessel) || !scene_.vessel->angular_velocity.isZero(0))) return true;
    if (!parts_.current.isZero(0)) return true;
    if (std::any_of(parts_.forces.begin(), parts_.forces.end(), [](const auto* m) { return m->drift().has_value(); }))
      return true;
    if (std::any_of(scene_.bodies.begin(), scene_.bodies.end(),
                    [&](const scene::BodyScene& body) { return moves(body) || !body.angular_velocity.isZero(0); }))
      return true;
    return scene_.ice && (std::any_of(scene_.ice->fields.begin(), scene_.ice->fields.end(), moves) ||
                          std::any_of(scene_.ice->floes.begin(), scene_.ice->floes.end(), moves));
  }

  void motion() {
    const bodies::Bodies& bodies = parts_.bodies;
    bool can_move = parts_.info.course == CourseKind::carriage || (scene_.vessel && !scene_.vessel->fixed);
    for (const bodies::Motion motion_of_body : bodies.motion)
      can_move = can_move || motion_of_body != bodies::Motion::fixed;
    if (!can_move)
      doubt("", bodies.size() == 0 ? "the scene has no bodies, so nothing happens in it"
                                   : "no body of the scene can move: each is fixed");
    else if (scene_.ice && (scene_.vessel || !scene_.bodies.empty()) && !drives())
      doubt(scene_.vessel ? "vessel" : "ice",
            scene_.vessel ? "nothing drives ice and vessel against each other: no <carriage speed>, no velocity, no "
                            "<current>; a vessel without a carriage has no propulsion"
                          : "nothing moves the ice: no velocity, no <current>");
  }

  void course() {
    if (parts_.carriage && parts_.carriage->motion.follows_path()) path();
    const auto forecast = course_forecast(scene_, parts_);
    if (!forecast) return;
    const std::string place =
        parts_.carriage->motion.follows_path() ? "vessel/carriage/path" : "vessel/carriage/@speed";
    if (forecast->meets_wall)
      doubt(place, fmt::format("the hull reaches {} at {:.4g} s; the run ends there, before its end at {:g} s",
                               forecast->wall, *forecast->meets_wall, scene_.time.end));
    if (!forecast->has_ice_at_rest) return;
    if (!forecast->reaches_ice)
      doubt(place,
            fmt::format("the hull does not reach the ice within the run, which ends at {:.4g} s: there is no ice load",
                        forecast->meets_wall.value_or(scene_.time.end)));
    else if (forecast->leaves_ice && counts_after(*forecast->leaves_ice))
      doubt(place, fmt::format("the hull has left the ice behind at {:.4g} s of {:g} s; means over the time after that "
                               "are too small (<output statistics> sets the window)",
                               *forecast->leaves_ice, scene_.time.end));
  }

  /// Whether the statistics window extends beyond a time.
  bool counts_after(double t) const {
    const auto& window = scene_.output.statistics;
    return !window || window->at(1) > t;
  }

  /// Warns of carriage settings that do not fit the tow of a ship.
  void towing() {
    if (!scene_.vessel || !scene_.vessel->carriage || parts_.info.course != CourseKind::carriage) return;
    const scene::CarriageScene& carriage = *scene_.vessel->carriage;
    constexpr std::size_t k_surge = 0, k_sway = 1;
    if (carriage.free[k_surge] || carriage.free[k_sway])
      doubt("vessel/carriage/@free", "the joint is free along the water, so the carriage leaves the vessel behind");
    if (!carriage.path.empty()) return;
    if (carriage.ramp > 0 && scene_.time.start + carriage.ramp > scene_.time.end)
      doubt("vessel/carriage/@ramp",
            fmt::format("the ramp of {:g} s outlasts the run, so the speed is never reached", carriage.ramp));
    constexpr double k_oblique = 45;  // [deg]
    const double drift =
        std::remainder(parts_.carriage->motion.direction() / k_deg - scene_.vessel->heading_deg, 360.0);
    if (std::abs(drift) > k_oblique)
      doubt("vessel/carriage/@heading_deg",
            fmt::format("the vessel is towed {:.4g} deg off its heading; the ice load is told along the tow, positive "
                        "against it",
                        std::abs(drift)));
  }

  void path() {
    const vessel::CarriageMotion& motion = parts_.carriage->motion;
    const auto [first, last] = motion.path_span();
    constexpr double k_rounding = 1e-6;  // share of a step, same value as in end_of_course()
    const double end = scene_.time.start + static_cast<double>(scene::number_of_steps(scene_.time)) * scene_.time.step;
    if (last < end - k_rounding * scene_.time.step)
      doubt("vessel/carriage/path",
            fmt::format("the path ends at {:g} s; the run ends there, before its end at {:g} s", last, end));
    constexpr double k_least_jump = 1e-6;  // [m/s]
    const double jump = motion.at(first).v.norm();
    if (first > scene_.time.start && jump > std::sqrt(scene_.scale) * k_least_jump)
      doubt("vessel/carriage/path",
            fmt::format("the carriage rests until the path begins at {:g} s and then jumps to {:.3g} m/s in one step; "
                        "let the first rows of the path begin at rest",
                        first, jump));
  }

  void periods() {
    const auto& carriage = scene_.vessel ? scene_.vessel->carriage : std::nullopt;
    const double h = scene_.time.step;
    for (const NaturalPeriod& mode : natural_periods(scene_, parts_)) {
      constexpr double k_overshoot = 0.05, k_percent = 100;
      const bool along = mode.motion == "surge" || mode.motion == "sway";
      if (mode.on_cells && along && carriage && carriage->path.empty() && carriage->speed != 0) {
        const double drift = (carriage->heading_deg - scene_.vessel->heading_deg) * k_deg;
        const double share = std::abs(mode.motion == "surge" ? std::cos(drift) : std::sin(drift));
        const double overshoot = share * swing_after(*carriage, mode.period);
        if (overshoot > k_overshoot)
          doubt("vessel/carriage/@ramp",
                fmt::format("the ramp of {:g} s sets the vessel swinging on its load cells in {} ({:.3g} s): its speed "
                            "overshoots by up to {:.0f} %; take stiffer cells or a ramp of {:g} s",
                            carriage->ramp, mode.motion, mode.period, k_percent * overshoot,
                            two_digits(gentle_ramp(*carriage, mode.period, k_overshoot / share), std::ceil)));
      }
      constexpr double k_steps_on_water = 10;
      if (scene_.contact.integrator == Integrator::reference) continue;  // its adaptive steps resolve every mode
      // Fast rotations on the cells are damped without harm, but surge and sway show in the tow force.
      if (mode.on_cells && !along) continue;
      // The product of step and circular frequency is then 0.5; a quasi-static line is an explicit spring.
      constexpr double k_steps_on_mooring = 4 * k_pi;
      const double steps = mode.on_mooring ? k_steps_on_mooring : k_steps_on_water;
      const double longest = mode.period / (mode.on_cells ? k_least_steps_on_cells : steps);
      if (h > longest)
        doubt("time/@step", fmt::format("the step of {:g} s misses the vessel's {} on {} with its period of {:.3g} s; "
                                        "take at most {:g} s to resolve it",
                                        h, mode.motion, mode.held_by(), mode.period, two_digits(longest, std::floor)));
    }
  }

  void hull() {
    const std::string place = scene_.vessel && scene_.vessel->generate ? "vessel/hull" : "vessel/@hull";
    for (const std::string& message : vessel_doubts(scene_, parts_)) doubt(place, message);
    if (parts_.database)
      for (const std::string& message : parts_.database->doubts) doubt("hydro/database/@file", message);
    for (const WaterDoubt& about : water_doubts(scene_, parts_)) doubt(about.path, about.message);
    if (!parts_.restless.empty())
      doubt("vessel", fmt::format("part '{}' finds no rest: nothing brings it back to where it is, or it starts with a "
                                  "rate. So the vessel starts as placed and without a tare; <carriage "
                                  "start=\"as-placed\"> says that this is meant",
                                  parts_.restless));
  }

  void structures() {
    if (scene_.contact.integrator != Integrator::reference) return;
    for (const scene::BodyScene& body : scene_.bodies)
      if (body.fixed && body.kind() != SolidShapeKind::plane)
        doubt("body", fmt::format("integrator reference writes no loads on the fixed body '{}'", body.name));
  }

  /// What integrator reference does not push apart.
  void overlaps() {
    if (scene_.contact.integrator != Integrator::reference) return;
    constexpr double k_slight = 1e-3;  // share of the smaller radius
    const bodies::Bodies& bodies = parts_.bodies;
    detect::ContactDetector detector;
    for (const auto& c : detector.detect(bodies, 0, [&](int a, int b) { return parts_.are_joined(a, b); })) {
      const double smaller = std::min(bodies.shape[c.a]->bounding_radius, bodies.shape[c.b]->bounding_radius);
      if (-c.gap <= k_slight * smaller) continue;
      doubt("contact", fmt::format("'{}' and '{}' overlap by {:g} m at the start; integrator reference removes no "
                                   "overlap, and its energy ledger may not close",
                                   bodies.name[c.a], bodies.name[c.b], -c.gap));
      return;
    }
  }

  const scene::Scene& scene_;
  const WorldParts& parts_;
  std::vector<Fault>& warnings_;
};

}  // namespace

void note_implausible(const scene::Scene& scene, WorldParts& parts) {
  std::vector<Fault> warnings = scene.warnings;
  Doubts(scene, parts, warnings).all();
  parts.info.warnings = std::move(warnings);
}

}  // namespace nilas::sim
