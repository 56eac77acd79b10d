#include "core/sim/build/vessel_rest.h"

#include <fmt/format.h>

#include "core/base/error.h"
#include "hydro/equilibrium.h"
#include "hydro/modules.h"

namespace nilas::sim {

namespace {

/// The vessel alone in the water, under the force modules of the run.
class AtRest {
 public:
  AtRest(const scene::Scene& scene, const std::vector<bodies::BodySpec>& specs, const WorldParts& parts)
      : gravity_(scene.gravity) {
    for (const bodies::BodySpec& spec : specs) alone_.add(spec);
    if (scene.hydro && scene.hydro->buoyancy && parts.water) buoyancy_ = hydro::make_buoyancy(*parts.water, 1);
  }
  bool afloat() const { return buoyancy_ != nullptr; }
  std::vector<Wrench> loads(const std::vector<Pose>& poses) {
    std::vector<Wrench> wrenches(poses.size());
    for (std::size_t b = 0; b < poses.size(); ++b) {
      alone_.set_pose(static_cast<int>(b), poses[b].p, poses[b].q);
      wrenches[b].force = alone_.mass[b] * gravity_;
    }
    if (buoyancy_) buoyancy_->add_forces(alone_, 0, wrenches);
    return wrenches;
  }

 private:
  Vec3 gravity_;
  bodies::Bodies alone_;
  std::unique_ptr<bodies::ForceModule> buoyancy_;
};

}  // namespace

void settle_vessel(const scene::Scene& scene, const std::vector<bodies::BodySpec>& specs, WorldParts& parts) {
  if (!parts.carriage || !scene.vessel->rods.empty()) return;
  const bodies::BodySpec& hull = specs.front();
  AtRest vessel(scene, specs, parts);
  vessel::RestModel rest;
  rest.loads = [&](const std::vector<Pose>& poses) { return vessel.loads(poses); };
  rest.weight = (hull.mass * scene.gravity).norm();
  rest.length = hull.shape->bounding_radius;
  rest.afloat = vessel.afloat();
  const bool as_placed = scene.vessel->carriage->start == CarriageStart::as_placed;
  try {
    if (rest.afloat && parts.carriage->free_in_heave() && specs.size() == 1)
      rest.heave =
          hydro::floating_height(hull.shape->surface, hull.pose.q.toRotationMatrix(), hull.mass, *parts.water) -
          hull.pose.p.z();
    const vessel::VesselRest found = parts.vessel->settle(rest, !as_placed);
    parts.info.tare = found.carried;
    if (found.moving_part && !as_placed) parts.restless = scene.vessel->parts[*found.moving_part].name;
  } catch (const InputError& error) {
    if (!as_placed)
      throw InputError(
          fmt::format("{}: <vessel name='{}'>: there is no static equilibrium to start from: {}; "
                      "<carriage start=\"as-placed\"> starts without",
                      scene.file.string(), hull.name, error.what()));
  }
}

}  // namespace nilas::sim
