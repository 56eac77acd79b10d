#include "core/vessel/mooring/mooring_module.h"

#include <fmt/format.h>

#include <algorithm>

#include "core/base/error.h"
#include "core/vessel/mooring/line_shape.h"

namespace nilas::vessel {

namespace {

/// Runs a computation and tells the time of its failure.
auto told(double t, const auto& compute) {
  try {
    return compute();
  } catch (const SimulationError& error) {
    throw SimulationError(fmt::format("at {:.6g} s {}", t, error.what()));
  }
}

class Mooring : public bodies::ForceModule {
 public:
  Mooring(const MooringModel& model, int hull, const bodies::Bodies& bodies, WarningCounts& warnings)
      : model_(model), hull_(static_cast<std::size_t>(hull)), warnings_(warnings) {
    state_ = initial_mooring(model, pose_of(bodies));
    tensions_ = mooring_loads(model_, state_, motion_of(bodies)).tensions;
  }
  std::string name() const override { return "mooring"; }

  void add_forces(const bodies::Bodies& bodies, double t, bodies::Wrenches& out) override {
    out[hull_] += told(t, [&] { return mooring_loads(model_, turned(bodies), motion_of(bodies)).on_hull; });
  }

  void end_substep(const bodies::Bodies& bodies, double t, double /*h*/) override {
    state_ = told(t, [&] { return turned(bodies); });
    tensions_ = told(t, [&] { return mooring_loads(model_, state_, motion_of(bodies)).tensions; });
    for (std::size_t k = 0; k < model_.lines.size(); ++k) break_line(k, t);
  }

  std::vector<std::string> columns() const override {
    std::vector<std::string> names;
    for (const MooringLine& line : model_.lines) names.push_back("line_" + line.name + "_tension_N");
    names.emplace_back("mooring_broken_1");
    if (model_.turret) names.emplace_back("turret_angle_rad");
    return names;
  }
  void append_values(std::vector<double>& values) const override {
    for (std::size_t k = 0; k < tensions_.size(); ++k) values.push_back(state_.broken[k] != 0 ? 0 : tensions_[k]);
    values.push_back(static_cast<double>(std::count(state_.broken.begin(), state_.broken.end(), 1)));
    if (model_.turret) values.push_back(state_.turret_angle);
  }

  std::vector<bodies::DrawnLine> drawn(const bodies::Bodies& bodies) const override {
    const std::vector<std::vector<Vec3>> shapes = mooring_shapes(model_, state_, pose_of(bodies));
    std::vector<bodies::DrawnLine> lines;
    for (std::size_t k = 0; k < shapes.size(); ++k)
      if (!shapes[k].empty())
        lines.push_back({bodies::DrawnLine::Kind::mooring, model_.lines[k].name, tensions_[k], shapes[k]});
    return lines;
  }

  void save(const bodies::Bodies& /*bodies*/, StateWriter out) const override {
    out.add("broken", std::vector<int>(state_.broken.begin(), state_.broken.end()));
    out.add("turret_angle", state_.turret_angle);
  }
  void restore(const StateReader& in) override {
    in.get("broken", state_.broken, model_.lines.size());
    in.get("turret_angle", state_.turret_angle);
  }

 private:
  Pose pose_of(const bodies::Bodies& bodies) const { return {bodies.q_GB[hull_], bodies.p_GB[hull_]}; }
  HullMotion motion_of(const bodies::Bodies& bodies) const {
    return {pose_of(bodies), bodies.v_GB[hull_], bodies.w_GB[hull_]};
  }
  MooringState turned(const bodies::Bodies& bodies) const {
    MooringState state = state_;
    state.turret_angle = turret_angle(model_, state_, pose_of(bodies));
    return state;
  }
  void break_line(std::size_t k, double t) {
    const MooringLine& line = model_.lines[k];
    if (state_.broken[k] != 0) return;
    const bool by_load = line.break_load && tensions_[k] >= *line.break_load;
    if (!by_load && !(line.break_time && t >= *line.break_time)) return;
    state_.broken[k] = 1;
    const std::string cause = by_load ? fmt::format("its break load is {:.4g} N", *line.break_load)
                                      : fmt::format("as the scene asks for {:g} s", *line.break_time);
    warnings_.warn("mooring line '" + line.name + "' broke",
                   fmt::format("at {:.6g} s mooring line '{}' broke at a tension of {:.4g} N: {}", t, line.name,
                               tensions_[k], cause));
  }

  MooringModel model_;
  std::size_t hull_;
  WarningCounts& warnings_;
  MooringState state_;
  std::vector<double> tensions_;  ///< at the end of the last substep, for the columns only
};

}  // namespace

MooringState initial_mooring(const MooringModel& model, const Pose& hull) {
  MooringState state;
  state.broken.assign(model.lines.size(), 0);
  if (!model.turret) return state;
  MooringModel free = model;
  free.turret->friction = 0;
  state.turret_angle = turret_angle(free, state, hull);
  return state;
}

std::unique_ptr<bodies::ForceModule> make_mooring(const MooringModel& model, int hull, const bodies::Bodies& bodies,
                                                  WarningCounts& warnings) {
  return std::make_unique<Mooring>(model, hull, bodies, warnings);
}

}  // namespace nilas::vessel
