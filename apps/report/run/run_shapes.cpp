#include "apps/report/run/run_shapes.h"

#include <algorithm>
#include <cmath>

#include "core/base/log.h"
#include "core/output/tables/contact_rows.h"
#include "core/sim/simulation.h"

namespace nilas::report {

const RunBody* RunShapes::find(const std::string& name, bool is_vessel) const {
  for (const RunBody& body : bodies)
    if (body.is_vessel == is_vessel && (is_vessel || body.name == name)) return &body;
  return nullptr;
}

RunShapes run_shapes(const scene::Scene& scene, bool with_ice) {
  scene::Scene built = scene;
  if (!with_ice) {
    built.ice.reset();
    built.fracture.reset();
  }
  WarningCounts warnings(make_logger("off", ""));
  const sim::Simulation simulation(built, 1, warnings);
  const bodies::Bodies& bodies = simulation.bodies();
  RunShapes shapes;
  shapes.info = simulation.info();
  shapes.with_ice = with_ice || !scene.ice;
  for (std::size_t b = 0; b < bodies.id.size(); ++b)
    if (bodies.kind[b] == bodies::BodyKind::rigid || bodies.kind[b] == bodies::BodyKind::wall)
      shapes.others.push_back(bodies.id[b]);
  const auto add = [&](std::size_t b, bool is_vessel) {
    RunBody& body = shapes.bodies.emplace_back();
    body.ids = {bodies.id[b]};
    body.name = bodies.name[b];
    body.is_vessel = is_vessel;
    body.mesh = bodies.shape[b]->surface;
    for (Vec3& p : body.mesh.vertices)
      p = is_vessel ? Vec3(p + shapes.info.vessel_mass.com) : Vec3(bodies.p_GB[b] + bodies.R_GB[b] * p);
  };
  const output::LoadedBodies loaded = output::loaded_bodies(bodies, shapes.info);
  if (loaded.vessel >= 0) {
    const auto hull = static_cast<std::size_t>(loaded.vessel);
    add(hull, true);
    for (std::size_t part = 1; part <= static_cast<std::size_t>(loaded.num_parts); ++part)
      shapes.bodies.back().ids.push_back(bodies.id[hull + part]);
  }
  for (const std::int64_t id : loaded.structures) add(bodies.index_of(id), false);
  return shapes;
}

Pose vessel_pose(const RunTable& vessel, double t, const Vec3& com_V) {
  const auto& time = vessel.time();
  Pose pose;
  if (time.empty()) return pose;
  const auto after = std::lower_bound(time.begin(), time.end(), t);
  auto k = static_cast<std::size_t>(std::min(after - time.begin(), static_cast<std::ptrdiff_t>(time.size()) - 1));
  if (k > 0 && std::abs(time[k - 1] - t) < std::abs(time[k] - t)) --k;
  pose.q = Quat(Eigen::AngleAxisd(vessel["yaw_deg"][k] * k_deg, Vec3::UnitZ()) *
                Eigen::AngleAxisd(vessel["pitch_deg"][k] * k_deg, Vec3::UnitY()) *
                Eigen::AngleAxisd(vessel["roll_deg"][k] * k_deg, Vec3::UnitX()));
  pose.p = Vec3(vessel["x_m"][k], vessel["y_m"][k], vessel["z_m"][k]) - pose.q * com_V;
  return pose;
}

}  // namespace nilas::report
