#include "hydro/modules.h"

namespace nilas::hydro {

namespace {

class VirtualDrag : public bodies::ForceModule {
 public:
  VirtualDrag(double coefficient, const Vec3& velocity) : coefficient_(coefficient), velocity_(velocity) {}
  std::string name() const override { return "virtual_drag"; }
  bodies::VesselLoad load_on_vessel() const override { return bodies::VesselLoad::none; }
  std::optional<Vec3> drift() const override { return velocity_.isZero(0) ? std::nullopt : std::optional(velocity_); }
  void add_forces(const bodies::Bodies& bodies, double /*t*/, bodies::Wrenches& out) override {
    for (std::size_t b = 0; b < out.size(); ++b) {
      if (bodies.kind[b] != bodies::BodyKind::floe || bodies.motion[b] != bodies::Motion::free) continue;
      out[b].force += coefficient_ * (velocity_ - bodies.v_GB[b]);
    }
  }
  void limit(const bodies::Bodies& bodies, double h, bodies::Wrenches& out) const override {
    for (std::size_t b = 0; b < out.size(); ++b)
      if (h * coefficient_ > bodies.mass[b]) out[b].force *= bodies.mass[b] / (h * coefficient_);
  }

 private:
  double coefficient_;  ///< [N s/m]
  Vec3 velocity_;       ///< [m/s]
};

}  // namespace

std::unique_ptr<bodies::ForceModule> make_virtual_drag(double coefficient, const Vec3& velocity) {
  return std::make_unique<VirtualDrag>(coefficient, velocity);
}

}  // namespace nilas::hydro
