#include "core/base/parallel.h"
#include "hydro/modules.h"
#include "hydro/wet_body.h"

namespace nilas::hydro {

namespace {

/// The submerged part of a body at the pose of the last update.
struct Afloat {
  bool known = false;
  Vec3 p = Vec3::Zero();
  Quat q = Quat::Identity();
  Submerged wet;
};

class Buoyancy : public bodies::ForceModule {
 public:
  Buoyancy(const Water& water, int threads, bool without_vessel)
      : water_(water), threads_(threads), without_vessel_(without_vessel) {}
  std::string name() const override { return "buoyancy"; }
  bool conservative() const override { return true; }
  bodies::VesselLoad load_on_vessel() const override { return bodies::VesselLoad::water; }
  void add_forces(const bodies::Bodies& bodies, double t, bodies::Wrenches& out) override;
  double potential_energy(const bodies::Bodies& bodies) override;

 private:
  bool is_lifted(const bodies::Bodies& bodies, std::size_t b) const {
    return takes_water(bodies, static_cast<int>(b)) && !(without_vessel_ && bodies.kind[b] == bodies::BodyKind::vessel);
  }
  void update(const bodies::Bodies& bodies);
  Submerged submerged(WetBody<Afloat>& body, const Mat3& R, const Vec3& p) const;

  Water water_;
  int threads_;
  bool without_vessel_;
  std::vector<WetBody<Afloat>> list_;
  std::vector<std::size_t> moved_;  ///< Bodies in the water whose pose differs from the one of the last update.
};

Submerged Buoyancy::submerged(WetBody<Afloat>& body, const Mat3& R, const Vec3& p) const {
  if (auto* prism = std::get_if<PrismWater>(&body.geometry)) return prism->submerged(R, p, water_.level);
  if (auto* mesh = std::get_if<MeshWater>(&body.geometry)) return mesh->submerged(R, p, water_.level);
  return submerged_sphere(body.shape->radius, p, water_.level);
}

/// Clips the bodies that moved. The energy account reads the energy at the poses at which the next step reads the
/// forces, so that each pose is clipped once.
void Buoyancy::update(const bodies::Bodies& bodies) {
  nilas::hydro::follow(bodies, list_, prepare_geometry);
  moved_.clear();
  for (std::size_t b = 0; b < list_.size(); ++b) {
    const Afloat& kept = list_[b].result;
    const bool same = kept.known && kept.p == bodies.p_GB[b] && kept.q.coeffs() == bodies.q_GB[b].coeffs();
    if (!same && is_lifted(bodies, b)) moved_.push_back(b);
  }
  if (moved_.empty()) return;
  parallel_for(static_cast<std::ptrdiff_t>(moved_.size()), threads_, [&](std::ptrdiff_t i) {
    const std::size_t b = moved_[i];
    const Vec3& p = bodies.p_GB[b];
    list_[b].result = {true, p, bodies.q_GB[b], submerged(list_[b], bodies.R_GB[b], p)};
  });
}

void Buoyancy::add_forces(const bodies::Bodies& bodies, double /*t*/, bodies::Wrenches& out) {
  update(bodies);
  for (std::size_t b = 0; b < list_.size(); ++b) {
    if (!is_lifted(bodies, b)) continue;
    const Submerged& wet = list_[b].result.wet;
    const Vec3 force(0, 0, water_.density * water_.gravity * wet.volume);
    out[b] += Wrench{force, (wet.centre - bodies.p_GB[b]).cross(force)};
  }
}

double Buoyancy::potential_energy(const bodies::Bodies& bodies) {
  update(bodies);
  double moment = 0;  // of the displaced volume below the level [m^4]
  for (std::size_t b = 0; b < list_.size(); ++b) {
    if (!is_lifted(bodies, b)) continue;
    const Submerged& wet = list_[b].result.wet;
    moment += wet.volume * (water_.level - wet.centre.z());
  }
  return water_.density * water_.gravity * moment;
}

}  // namespace

std::unique_ptr<bodies::ForceModule> make_buoyancy(const Water& water, int threads, bool without_vessel) {
  return std::make_unique<Buoyancy>(water, threads, without_vessel);
}

}  // namespace nilas::hydro
