#include "hydro/flow/propeller_wash.h"

#include <utility>

#include "core/base/error.h"

namespace nilas::hydro {

namespace {

class PropellerWash : public bodies::Module {
 public:
  PropellerWash(std::vector<WashSource> sources, int hull, std::shared_ptr<const Channels> channels)
      : sources_(std::move(sources)), states_(sources_.size()), hull_(hull), channels_(std::move(channels)) {
    for (const WashSource& source : sources_) NILAS_DEMAND(source.angle_channel < 0 || source.push);
  }
  std::string name() const override { return "propeller_wash"; }
  bodies::VesselLoad load_on_vessel() const override { return bodies::VesselLoad::none; }
  /// The jets set ice in motion, at no one velocity.
  std::optional<Vec3> drift() const override { return Vec3::Zero(); }

  void update(const bodies::Bodies& bodies) {
    for (std::size_t k = 0; k < sources_.size(); ++k) {
      const WashSource& source = sources_[k];
      State& state = states_[k];
      state.position = bodies.p_GB[hull_] + bodies.R_GB[hull_] * source.position;
      state.thrust = source.thrust_channel < 0 ? source.thrust : (*channels_)[source.thrust_channel];
      Vec3 direction = source.direction;
      if (source.angle_channel >= 0) {
        const Vec2 push = source.push((*channels_)[source.angle_channel], state.thrust > 0);
        direction = -Vec3(push.x(), push.y(), 0).normalized();
        state.thrust *= push.norm();
      }
      state.direction = bodies.R_GB[hull_] * direction;
      give(k);
    }
  }
  void end_substep(const bodies::Bodies& bodies, double /*t*/, double /*h*/) override { update(bodies); }

  void save(const bodies::Bodies& /*bodies*/, StateWriter out) const override {
    std::vector<Vec3> position, direction;
    std::vector<double> thrust;
    for (const State& state : states_) {
      position.push_back(state.position);
      direction.push_back(state.direction);
      thrust.push_back(state.thrust);
    }
    out.add("position", position);
    out.add("direction", direction);
    out.add("thrust", thrust);
  }
  void restore(const StateReader& in) override {
    std::vector<Vec3> position, direction;
    std::vector<double> thrust;
    in.get("position", position, states_.size());
    in.get("direction", direction, states_.size());
    in.get("thrust", thrust, states_.size());
    for (std::size_t k = 0; k < states_.size(); ++k) {
      states_[k] = {position[k], direction[k], thrust[k]};
      give(k);
    }
  }

 private:
  /// What a jet was given last. It is kept, since a step after a checkpoint must find the same jet.
  struct State {
    Vec3 position = Vec3::Zero(), direction = Vec3::UnitX();  ///< in G [m, 1]
    double thrust = 0;                                        ///< [N]
  };

  void give(std::size_t k) const { sources_[k].jet->set(states_[k].position, states_[k].direction, states_[k].thrust); }

  std::vector<WashSource> sources_;
  std::vector<State> states_;
  int hull_;
  std::shared_ptr<const Channels> channels_;
};

}  // namespace

std::unique_ptr<bodies::Module> make_propeller_wash(std::vector<WashSource> sources, int hull,
                                                    std::shared_ptr<const Channels> channels,
                                                    const bodies::Bodies& bodies) {
  auto module = std::make_unique<PropellerWash>(std::move(sources), hull, std::move(channels));
  module->update(bodies);
  return module;
}

}  // namespace nilas::hydro
