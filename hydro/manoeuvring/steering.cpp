#include "hydro/manoeuvring/steering.h"

#include <utility>

#include "core/base/error.h"
#include "hydro/manoeuvring/manoeuvring.h"

namespace nilas::hydro {

namespace {

class Steering : public bodies::Module {
 public:
  Steering(const SteeringSettings& settings, std::unique_ptr<Manoeuvre> manoeuvre, std::shared_ptr<Channels> commands)
      : settings_(settings), manoeuvre_(std::move(manoeuvre)), commands_(std::move(commands)) {
    rudder_ = channel(k_rudder_channel);
    propeller_ = channel(k_propeller_channel);
  }

  std::string name() const override { return "manoeuvre"; }
  bodies::VesselLoad load_on_vessel() const override { return bodies::VesselLoad::none; }

  void end_substep(const bodies::Bodies& bodies, double t, double h) override {
    // Times of substeps are sums, which may fall short of the start by rounding.
    constexpr double k_rounding = 1e-6;  // share of a substep
    if (t + k_rounding * h < settings_.start) return;
    const VesselInPlane now = vessel_in_plane(bodies, settings_.vessel, settings_.midship, settings_.current);
    const SteeringOrders orders = manoeuvre_->go_on(now, t, h, {(*commands_)[rudder_], (*commands_)[propeller_]});
    commands_->set(rudder_, orders.rudder);
    commands_->set(propeller_, orders.rps);
  }

  std::vector<bodies::RunFigure> figures() const override { return manoeuvre_->figures(); }

  void save(const bodies::Bodies& /*bodies*/, StateWriter out) const override { manoeuvre_->save(out); }
  void restore(const StateReader& in) override { manoeuvre_->restore(in); }

 private:
  int channel(const std::string& name) const {
    const int found = commands_->find(name);
    if (found < 0)
      throw InputError("<manoeuvre> steers by '" + name +
                       "', which nothing of the scene follows; allowed: with "
                       "<vessel><manoeuvring>");
    return found;
  }

  SteeringSettings settings_;
  std::unique_ptr<Manoeuvre> manoeuvre_;
  std::shared_ptr<Channels> commands_;
  int rudder_ = -1, propeller_ = -1;
};

}  // namespace

std::unique_ptr<bodies::Module> make_steering(const SteeringSettings& settings, std::unique_ptr<Manoeuvre> manoeuvre,
                                              std::shared_ptr<Channels> commands) {
  NILAS_DEMAND(manoeuvre && commands);
  return std::make_unique<Steering>(settings, std::move(manoeuvre), std::move(commands));
}

}  // namespace nilas::hydro
