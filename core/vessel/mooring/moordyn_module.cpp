#include "core/vessel/mooring/moordyn_module.h"

namespace nilas::vessel {

namespace {

class MoordynMooring : public bodies::ForceModule {
 public:
  MoordynMooring(const MoordynApi& api, const MoordynSettings& settings, const bodies::Bodies& bodies)
      : settings_(settings), hull_(static_cast<std::size_t>(settings.hull)), system_(api, settings.file) {
    places_ = fairleads(bodies);
    forces_ = system_.start(places_);
  }
  std::string name() const override { return "mooring"; }

  void add_forces(const bodies::Bodies& bodies, double /*t*/, bodies::Wrenches& out) override {
    for (std::size_t k = 0; k < forces_.size(); ++k) out[hull_] += {forces_[k], arm(bodies, k).cross(forces_[k])};
  }

  void end_substep(const bodies::Bodies& bodies, double t, double h) override {
    const std::vector<Vec3> places = fairleads(bodies);
    forces_ = system_.advance(places_, places, t - h, h);
    places_ = places;
  }

  std::vector<std::string> columns() const override {
    std::vector<std::string> names;
    for (const int id : system_.lines()) names.push_back("line_" + std::to_string(id) + "_tension_N");
    return names;
  }
  void append_values(std::vector<double>& values) const override {
    for (const double tension : system_.tensions()) values.push_back(tension);
  }

  void save(const bodies::Bodies& /*bodies*/, StateWriter out) const override {
    out.add("moordyn", system_.state());
    out.add("places", places_);
    out.add("forces", forces_);
  }
  void restore(const StateReader& in) override {
    std::vector<std::int64_t> state;
    in.get("moordyn", state);
    system_.restore(state);
    in.get("places", places_, system_.points().size());
    in.get("forces", forces_, system_.points().size());
  }

 private:
  Vec3 arm(const bodies::Bodies& bodies, std::size_t k) const {
    return bodies.R_GB[hull_] * (system_.points()[k] - settings_.com_V);
  }
  std::vector<Vec3> fairleads(const bodies::Bodies& bodies) const {
    std::vector<Vec3> places;
    for (std::size_t k = 0; k < system_.points().size(); ++k)
      places.push_back(bodies.p_GB[hull_] + arm(bodies, k) - settings_.level * Vec3::UnitZ());
    return places;
  }

  MoordynSettings settings_;
  std::size_t hull_;
  MoordynSystem system_;
  std::vector<Vec3> places_, forces_;  ///< of the fairleads at the end of the last substep [m, N]
};

}  // namespace

std::unique_ptr<bodies::ForceModule> make_moordyn_mooring(const MoordynApi& api, const MoordynSettings& settings,
                                                          const bodies::Bodies& bodies) {
  return std::make_unique<MoordynMooring>(api, settings, bodies);
}

}  // namespace nilas::vessel
