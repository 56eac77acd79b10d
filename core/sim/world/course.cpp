#include "core/sim/world/course.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace nilas::sim {

namespace {

using Box2 = Eigen::AlignedBox2d;

/// The hull's horizontal outline: its corners at the start of the run, moved by the carriage.
class TowedOutline {
 public:
  TowedOutline(const WorldParts& parts, double t0)
      : motion_(parts.carriage->motion), start_(motion_.at(t0)), corners_(corners(parts)) {}

  Box2 box(double t) const {
    const vessel::CarriageMotion::State now = motion_.at(t);
    const Eigen::Rotation2Dd turn(now.yaw - start_.yaw);
    Box2 box;
    for (const Vec2& corner : corners_) box.extend(Vec2(now.p.head<2>() + turn * (corner - Vec2(start_.p.head<2>()))));
    return box;
  }

 private:
  static std::vector<Vec2> corners(const WorldParts& parts) {
    std::vector<Vec2> points;
    for (int body = parts.vessel_index; parts.is_of_vessel(body); ++body) {
      const auto b = static_cast<std::size_t>(body);
      for (const Vec3& vertex : parts.bodies.shape[b]->surface.vertices)
        points.push_back((parts.bodies.R_GB[b] * vertex + parts.bodies.p_GB[b]).head<2>());
    }
    return points;
  }

  const vessel::CarriageMotion& motion_;
  vessel::CarriageMotion::State start_;
  std::vector<Vec2> corners_;
};

/// Name of the wall that a box crosses; empty if none.
std::string crossed_wall(const scene::TankScene& tank, const Box2& box) {
  const double side = 0.5 * tank.width;
  if (box.max().x() > tank.length) return fmt::format("the tank's end wall (x = {:g} m)", tank.length);
  if (box.min().x() < 0) return "the tank's start wall (x = 0 m)";
  if (box.max().y() > side) return fmt::format("the tank's port wall (y = {:g} m)", side);
  if (box.min().y() < -side) return fmt::format("the tank's starboard wall (y = {:g} m)", -side);
  return "";
}

bool ice_stays(const scene::Scene& scene, const WorldParts& parts) {
  const auto at_rest = [](const auto& item) { return item.velocity.isZero(0); };
  return parts.current.isZero(0) &&
         std::none_of(parts.forces.begin(), parts.forces.end(), [](const auto* m) { return m->drift().has_value(); }) &&
         std::all_of(scene.ice->fields.begin(), scene.ice->fields.end(), at_rest) &&
         std::all_of(scene.ice->floes.begin(), scene.ice->floes.end(), at_rest);
}

Box2 box_of_ice(const bodies::Bodies& bodies) {
  Box2 box;
  for (std::size_t b = 0; b < bodies.id.size(); ++b)
    if (bodies.kind[b] == bodies::BodyKind::floe)
      for (const Vec2& corner : bodies.shape[b]->outline)
        box.extend(Vec2((bodies.R_GB[b] * Vec3(corner.x(), corner.y(), 0) + bodies.p_GB[b]).head<2>()));
  return box;
}

/// The time between `before` and `after` from which on `holds` is true, to a millionth of the interval.
template <class Holds>
double since_when(double before, double after, const Holds& holds) {
  for (int pass = 0; pass < 20; ++pass) {
    const double middle = 0.5 * (before + after);
    (holds(middle) ? after : before) = middle;
  }
  return after;
}

}  // namespace

std::optional<CourseForecast> course_forecast(const scene::Scene& scene, const WorldParts& parts) {
  if (!parts.carriage || parts.info.course != CourseKind::carriage) return std::nullopt;
  const TowedOutline hull(parts, scene.time.start);
  CourseForecast forecast;
  const Box2 ice = scene.ice ? box_of_ice(parts.bodies) : Box2();
  forecast.has_ice_at_rest = !ice.isEmpty() && ice_stays(scene, parts);
  const auto& tank = parts.course_within;
  const auto blocked = [&](double t) { return tank && !crossed_wall(*tank, hull.box(t)).empty(); };
  const auto in_ice = [&](double t) { return hull.box(t).intersects(ice); };
  constexpr int k_samples = 500;
  double before = scene.time.start;
  for (int k = 0; k <= k_samples; ++k) {
    const double t = scene.time.start + (scene.time.end - scene.time.start) * k / k_samples;
    if (blocked(t)) {
      forecast.meets_wall = since_when(before, t, blocked);
      forecast.wall = crossed_wall(*tank, hull.box(*forecast.meets_wall));
      break;
    }
    if (forecast.has_ice_at_rest) {
      const bool meets = in_ice(t);
      if (meets && !forecast.reaches_ice) forecast.reaches_ice = k == 0 ? t : since_when(before, t, in_ice);
      if (meets) forecast.leaves_ice.reset();
      if (!meets && forecast.reaches_ice && !forecast.leaves_ice)
        forecast.leaves_ice = since_when(before, t, [&](double x) { return !in_ice(x); });
    }
    before = t;
  }
  return forecast;
}

void describe_course(const scene::Scene& scene, WorldParts& parts) {
  if (!scene.tank || !parts.carriage) return;
  const Box2 hull = TowedOutline(parts, scene.time.start).box(scene.time.start);
  if (crossed_wall(*scene.tank, hull).empty()) parts.course_within = scene.tank;
}

/// Name of the wall that a body would cross with its present velocity; empty if none.
static std::string wall_ahead(const scene::TankScene& tank, const bodies::Bodies& bodies, int body, double h) {
  const auto b = static_cast<std::size_t>(body);
  const Vec3 &p = bodies.p_GB[b], &v = bodies.v_GB[b], &w = bodies.w_GB[b];
  // One step further: a hull that ends the step at the wall has hit it, and poses of Moreau lie half a step ahead.
  const double ahead = 2 * h;
  const double reach =
      bodies.shape[b]->bounding_radius + ahead * (v.norm() + w.norm() * bodies.shape[b]->bounding_radius);
  const Vec2 centre = p.head<2>(), around = Vec2::Constant(reach);
  if (crossed_wall(tank, Box2(Vec2(centre - around), Vec2(centre + around))).empty()) return "";
  Box2 next;
  for (const Vec3& vertex : bodies.shape[b]->surface.vertices) {
    const Vec3 arm = bodies.R_GB[b] * vertex;
    next.extend(Vec2((p + arm + ahead * (v + w.cross(arm))).head<2>()));
  }
  return crossed_wall(tank, next);
}

std::string end_of_course(const WorldParts& parts, double t, double h) {
  if (!parts.carriage) return "";
  constexpr double k_rounding = 1e-6;  // share of a step: rounding of sums of many steps
  if (parts.carriage->motion.follows_path()) {
    const double last = parts.carriage->motion.path_span()[1];
    if (t + h > last + k_rounding * h) return fmt::format("the carriage's path ends at {:g} s", last);
  }
  if (!parts.course_within) return "";
  for (int body = parts.vessel_index; parts.is_of_vessel(body); ++body) {
    const std::string wall = wall_ahead(*parts.course_within, parts.bodies, body, h);
    if (!wall.empty()) return "the carriage would drive the hull into " + wall;
  }
  return "";
}

}  // namespace nilas::sim
