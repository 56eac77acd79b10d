#include "core/sim/vessel_rest.h"

#include <fmt/format.h>

#include "core/base/error.h"
#include "hydro/equilibrium.h"
#include "hydro/modules.h"

namespace nilas {

namespace {

/// The vessel alone in the water, as the run's own force modules see it.
class AtRest {
 public:
  AtRest(const Scene& scene, const BodySpec& spec, const WorldParts& parts) : weight_(spec.mass * scene.gravity) {
    alone_.add(spec);
    if (scene.hydro && scene.hydro->buoyancy && parts.water) buoyancy_ = make_buoyancy(*parts.water, 1);
  }
  bool afloat() const { return buoyancy_ != nullptr; }
  double weight() const { return weight_.norm(); }
  Wrench load(const Pose& pose) {
    alone_.set_pose(0, pose.p, pose.q);
    Wrenches wrenches(1);
    wrenches[0].force = weight_;
    if (buoyancy_) buoyancy_->add_forces(alone_, 0, wrenches);
    return wrenches[0];
  }

 private:
  Vec3 weight_;
  Bodies alone_;
  std::unique_ptr<ForceModule> buoyancy_;
};

}  // namespace

void settle_vessel(const Scene& scene, const BodySpec& spec, WorldParts& parts) {
  if (!parts.carriage || parts.is_jointed()) return;
  AtRest vessel(scene, spec, parts);
  RestModel rest;
  rest.load = [&](const Pose& pose) { return vessel.load(pose); };
  rest.weight = vessel.weight();
  rest.length = spec.shape->bounding_radius;
  rest.afloat = vessel.afloat();
  const bool as_placed = scene.vessel->carriage->start == "as-placed";
  try {
    if (rest.afloat && parts.carriage->free_in_heave())
      rest.heave = floating_height(spec.shape->surface, spec.pose.q.toRotationMatrix(), spec.mass, *parts.water) -
                   spec.pose.p.z();
    parts.info.tare = parts.vessel->settle(rest, !as_placed);
  } catch (const InputError& error) {
    if (!as_placed)
      throw InputError(
          fmt::format("{}: <vessel name='{}'>: there is no static equilibrium to start from: {}; "
                      "<carriage start=\"as-placed\"> starts without",
                      scene.file.string(), spec.name, error.what()));
  }
}

}  // namespace nilas
