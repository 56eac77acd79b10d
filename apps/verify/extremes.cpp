#include "apps/verify/extremes.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "apps/verify/jobs.h"
#include "apps/verify/scene_changes.h"
#include "contact/registry.h"
#include "core/base/error.h"

namespace nilas::verify {

namespace {

/// The largest values that a cell may reach.
constexpr double k_most_energy = 1e-6, k_most_momentum = 1e-9, k_most_penetration = 1e-3, k_most_drift = 1e-6;
constexpr double k_tolerance = 1e-9;  // tolerance of the solvers [m/s]
constexpr int k_iterations = 2000;

/// The extreme whose level 1 breaks a limit as docs/theory/dynamics.md states. With semi-implicit Euler a body bounces
/// before it touches, so energies scatter.
constexpr const char* k_elastic = "restitution";
constexpr double k_scatter = 0.05;  // share of the energy that may be gained in the ten seconds of that run

/// Returns the larger of two values, or NaN if either is NaN.
double larger(double a, double b) { return a >= b || std::isnan(a) ? a : b; }

/// Takes the steps of a run and keeps the largest values of a cell.
class Watch {
 public:
  Watch(Trial& run, Cell& cell, double energy_scale) : run_(run), cell_(cell), scale_(energy_scale) {
    start_ = run.initial_ledger().kinetic + run.initial_ledger().potential;
  }
  void steps(long count) {
    for (long k = 0; k < count; ++k) {
      const sim::StepRecord& record = run_.step();
      cell_.short_steps += record.solver_short ? 1 : 0;
      cell_.residual = larger(cell_.residual, record.residuals.law_map_m_s);
      imbalance_ = larger(imbalance_, record.momentum_imbalance);
      momentum_ = std::max(momentum_, record.momentum_scale);
      deepest_ = larger(deepest_, record.penetration_max);
      if (momentum_ > 0) cell_.momentum_error = imbalance_ / momentum_;
      const double energy = record.ledger.kinetic + record.ledger.potential - start_;
      cell_.energy_won = larger(cell_.energy_won, energy / scale_);
    }
  }
  /// Sets the cell's penetration to the deepest of all steps.
  void penetration(double size) { cell_.penetration = deepest_ / size; }
  /// Sets the cell's penetration to that after the last step.
  void penetration_left(double size) { cell_.penetration = run_.last().penetration_max / size; }

 private:
  Trial& run_;
  Cell& cell_;
  double scale_, start_ = 0;
  double deepest_ = 0;
  /// Largest of all steps, since a step at rest has no momentum to compare rounding with.
  double imbalance_ = 0, momentum_ = 0;
};

struct Extreme {
  std::string name, unit, scene;
  std::vector<double> levels;
  void (*observe)(const Setting& setting, double level, Cell& cell);
  std::vector<std::string> solvers{};  ///< empty: all but enumerate
};

scene::Overrides settled() { return {{"contact/@stabilisation", "projection"}}; }

void mass_ratio(const Setting& s, double level, Cell& cell) {
  Trial run = s.trial(of("heavy", "mass", level) + settled());
  Watch watch(run, cell, k_gravity * level);
  watch.steps(50);
  watch.penetration(1);
  cell.drift = std::max(std::abs(run.body("heavy").p.z() - 1.5), run.body("light").v.norm());
}

void step_length(const Setting& s, double level, Cell& cell) {
  Trial run = s.trial(settled() + scene::Overrides{{"time/@step", text(level)}});
  Watch watch(run, cell, 0.5 * 2 * 4);
  watch.steps(std::clamp(static_cast<long>(2 / level), 10L, 2000L));
  watch.penetration(0.2);
  cell.drift = std::abs(run.body("block").p.z() - 0.1);
}

void friction_coefficient(const Setting& s, double level, Cell& cell) {
  const double slope = 20 * k_deg;
  Trial run = s.trial(settled() + friction(level) + gravity(k_gravity * Vec3(std::sin(slope), 0, -std::cos(slope))));
  Watch watch(run, cell, 0.5 * 2 * 4);
  watch.steps(100);
  watch.penetration(0.2);
  cell.drift = std::abs(run.body("block").p.y());
}

void thickness(const Setting& s, double level, Cell& cell) {
  const double width = std::max(1.0, 4 * level);
  Trial run = s.trial(settled() + of("block", "size", Vec3(width, width, level)) +
                      of("block", "position", Vec3(0, 0, 0.5 * level)) + friction(0.2));
  Watch watch(run, cell, 0.5 * 2 * 4);
  watch.steps(100);
  watch.penetration(level);
  cell.drift = run.body("block").w.norm();
}

void aspect(const Setting& s, double level, Cell& cell) {
  Trial run = s.trial(settled() + of("block", "size", Vec3(std::sqrt(level), 1, 1 / std::sqrt(level))) +
                      of("block", "position", Vec3(0, 0, 0.5 / std::sqrt(level))));
  Watch watch(run, cell, 0.5 * 2 * 4);
  watch.steps(100);
  watch.penetration(1 / std::sqrt(level));
  cell.drift = std::abs(run.body("block").v.y());
}

void speed(const Setting& s, double level, Cell& cell) {
  Trial run = s.trial(settled() + of("left", "velocity", Vec3(level, 0, 0)));
  Watch watch(run, cell, level * level);
  double nearest = 1;
  for (long k = std::max(30L, static_cast<long>(1.0 / level / s.h())); k > 0; --k) {
    watch.steps(1);
    nearest = std::min(nearest, (run.body("left").p - run.body("right").p).norm());
  }
  watch.penetration(1);
  // The balls have a diameter of 1 m. This counts penetration of which no contact was found.
  cell.penetration = larger(cell.penetration, 1 - nearest);
  // A ball of 2 kg hits one of 3 kg, inelastic along the line of centres. The second must have been pushed.
  const bool hit = run.body("right").v.x() > 0.1 * level;
  cell.drift = hit ? 0 : 1;
}

void short_edge(const Setting& s, double level, Cell& cell) {
  const std::string outline = fmt::format("0 0 {} 0 1 {} 1 1 0 1", 1 - level, level);
  Trial run = s.trial(scene::Overrides{{"ice/floe[1]/@outline", outline}});
  Watch watch(run, cell, 0.5 * 180 * 1.04);
  watch.steps(50);
  watch.penetration(1);
  const bool hit = run.body("whole").v.x() > 0.1;
  cell.drift = hit ? 0 : 1;
}

void offset(const Setting& s, double level, Cell& cell) {
  Trial run = s.trial(settled() + of("block", "position", Vec3(level, -level, 0.1)) + of("block", "velocity", "0 1 0"));
  Watch watch(run, cell, 0.5 * 2);
  watch.steps(100);
  watch.penetration(0.2);
  // Rounding may be four units in the last place of the coordinates per step.
  const double rounding = 100 * 4 * level * std::numeric_limits<double>::epsilon();
  cell.drift = std::max(0.0, std::abs(run.body("block").p.x() - level) - rounding);
}

void stack(const Setting& s, double level, Cell& cell) {
  Trial run = s.trial(scene::Overrides{{"gravity/@value", text(Vec3(0, 0, -level))}});
  Watch watch(run, cell, 2 * level);
  watch.steps(20);
  watch.penetration(1);
  cell.drift = std::hypot(run.body("cube30").p.x(), run.body("cube30").p.y());
}

void spin(const Setting& s, double level, Cell& cell) {
  const Vec3 w = level * Vec3(0.1, 1, 0.2);
  Trial run = s.trial(of("top", "angular_velocity", w));
  const Vec3 momentum = run.body("top").inertia * w;
  Watch watch(run, cell, 0.5 * momentum.dot(w));
  watch.steps(1000);
  const BodyState top = run.body("top");
  cell.drift = (top.inertia * top.w - momentum).norm() / momentum.norm();
}

void spin_on_floor(const Setting& s, double level, Cell& cell) {
  Trial run = s.trial(settled() + of("disc", "angular_velocity", Vec3(0, 0, level)));
  Watch watch(run, cell, 0.5 * 0.25 * level * level);
  watch.steps(100);
  watch.penetration(0.1);
  const BodyState disc = run.body("disc");
  cell.drift = std::hypot(disc.p.x(), disc.p.y());
}

void pitch(const Setting& s, double level, Cell& cell) {
  const double angle = level * k_deg;
  const double height = 0.5 * (std::sin(angle) + 0.2 * std::cos(angle));
  Trial run = s.trial(settled() + of("block", "rotation_deg", Vec3(30, level, 0)) +
                      of("block", "position", Vec3(0, 0, height)) + of("block", "velocity", "0 0 0") +
                      of("block", "angular_velocity", "0 0 2"));
  Watch watch(run, cell, 2 * k_gravity);
  watch.steps(100);
  watch.penetration(0.2);
}

void overlap(const Setting& s, double level, Cell& cell) {
  Trial run =
      s.trial(settled() + of("block", "position", Vec3(0, 0, 0.1 - 0.2 * level)) + of("block", "velocity", "0 0 0"));
  Watch watch(run, cell, 2 * k_gravity * 0.2);
  watch.steps(5);
  watch.penetration_left(0.2);
  // The stabilisation lifts the block out and so gives it potential energy. Any energy beyond that is an error.
  cell.energy_won -= std::max(0.0, level);
  cell.drift = run.body("block").v.norm();
}

void restitution_level(const Setting& s, double level, Cell& cell) {
  Trial run = s.trial(settled() + of("ball", "position", "0 0 1.5") + of("ball", "velocity", "0 0 0") +
                      restitution(level) + friction(0));
  Watch watch(run, cell, 2 * k_gravity);
  double lowest = 1;
  for (int k = 0; k < 1000; ++k) {
    watch.steps(1);
    lowest = std::min(lowest, run.body("ball").p.z() - 0.5);
  }
  // With moreau a bouncing body is up to the distance of one step deep when it is found.
  const double met = level > 0 && s.theta() < 1 ? s.h() * std::sqrt(2 * k_gravity) : 0;
  cell.penetration = std::max(0.0, -lowest - met);
  cell.drift = std::hypot(run.body("ball").p.x(), run.body("ball").p.y());
}

void gravity_level(const Setting& s, double level, Cell& cell) {
  Trial run = s.trial(settled() + gravity({0, 0, -level}));
  Watch watch(run, cell, 10);
  watch.steps(100);
  watch.penetration(0.3);
}

void rest(const Setting& s, double level, Cell& cell) {
  Trial run = s.trial(settled() + of("block", "velocity", "0 0 0"));
  Watch watch(run, cell, 2 * k_gravity * 0.1);
  watch.steps(static_cast<long>(level));
  watch.penetration(0.2);
  cell.drift = (run.body("block").p - Vec3(0, 0, 0.1)).norm();
}

void load_cells(const Setting& s, double level, Cell& cell) {
  Trial run = s.trial(settled() + scene::Overrides{{"vessel/carriage/force_balance/@stiffness", text(level)},
                                                   {"vessel/carriage/force_balance/@damping", text(1e-3 * level)}});
  const double given = 0.5 * 115 * 0.25;
  Watch watch(run, cell, given);
  watch.steps(100);
  watch.penetration(0.2);
  // The carriage puts energy in, so a gain is no error here. The energy ledger must close.
  cell.energy_won = std::abs(run.last().ledger.imbalance) / given;
}

const std::vector<Extreme>& extremes() {
  static const std::vector<Extreme> all{
      {"mass ratio", "", "heavy-on-light.xml", {1, 1e2, 1e4, 1e6, 1e8}, mass_ratio},
      {"step", "s", "block.xml", {1e-5, 1e-3, 0.1, 0.5}, step_length},
      {"friction", "", "block.xml", {0, 1e-3, 1, 10}, friction_coefficient},
      {"thickness", "m", "block.xml", {1e-3, 0.1, 10}, thickness},
      {"aspect", "", "block.xml", {1, 30, 1000}, aspect},
      {"speed", "m/s", "pair.xml", {0.1, 2, 20}, speed},
      {"shortest edge", "m", "edges.xml", {1e-3, 1e-6, 1e-9}, short_edge},
      {"offset", "m", "block.xml", {1, 1e3, 1e6}, offset},
      {"stack of 30, gravity", "m/s^2", "stack.xml", {1, 9.81, 100}, stack},
      {"spin, free", "rad/s", "top.xml", {1, 30, 1000}, spin, {"auto"}},
      {"spin, on a floor", "rad/s", "disc.xml", {1, 30, 1000}, spin_on_floor},
      {"pitch", "deg", "block.xml", {0, 89.9999, 90}, pitch},
      {"overlap", "of the thickness", "block.xml", {0.01, 0.1, 0.5}, overlap},
      {k_elastic, "", "ball.xml", {0, 0.5, 1}, restitution_level},
      {"gravity", "m/s^2", "pile.xml", {0, 1e-6, 100}, gravity_level},
      {"rest", "steps", "block.xml", {1e3, 1e6}, rest, {"auto", "nsgs", "newton"}},
      {"load cells", "N/m", "towed.xml", {1e3, 1e6, 1e9, 1e12}, load_cells},
  };
  return all;
}

Hold judged(const Cell& cell) {
  const bool kept = cell.energy_won <= k_most_energy && cell.momentum_error <= k_most_momentum &&
                    cell.penetration <= k_most_penetration && cell.drift <= k_most_drift;
  if (kept) return Hold::holds;
  const bool only_energy = cell.momentum_error <= k_most_momentum && cell.penetration <= k_most_penetration &&
                           cell.drift <= k_most_drift && cell.energy_won <= k_scatter;
  if (cell.extreme == k_elastic && cell.level == "1" && cell.model.integrator == "semi-implicit-euler" && only_energy)
    return Hold::stated;
  return cell.short_steps > 0 ? Hold::short_of_it : Hold::fails;
}

void fill(const Extreme& extreme, double level, Cell& cell) {
  Case base;
  base.scene = extreme.scene;
  base.contact_tolerance = k_tolerance;
  base.contact_iterations = k_iterations;
  try {
    extreme.observe(Setting(base, cell.model, {}), level, cell);
    cell.hold = judged(cell);
  } catch (const SimulationError& error) {
    cell.hold = Hold::stopped;
    cell.message = error.what();
  } catch (const std::runtime_error& error) {
    cell.hold = Hold::refused;
    cell.message = error.what();
  }
}

}  // namespace

const char* to_string(Hold hold) {
  switch (hold) {
    case Hold::holds:
      return "holds";
    case Hold::short_of_it:
      return "short";
    case Hold::stopped:
      return "stopped";
    case Hold::refused:
      return "refused";
    case Hold::stated:
      return "stated";
    case Hold::fails:
      break;
  }
  return "FAILS";
}

std::vector<std::string> extreme_names() {
  std::vector<std::string> names;
  for (const auto& extreme : extremes()) names.push_back(extreme.name);
  return names;
}

std::vector<Cell> run_extremes(const Selection& selection, int threads, const std::function<void(double)>& done) {
  const auto names = extreme_names();
  for (const auto& wanted : selection.cases)
    if (std::find(names.begin(), names.end(), wanted) == names.end())
      throw InputError("--case: found '" + wanted + "', allowed with --extremes: '" +
                       fmt::format("{}", fmt::join(names, "'; '")) + "'");
  for (const auto& name : selection.solvers) contact::find_solver(name);
  const auto chosen = [](const std::vector<std::string>& list, const std::string& name) {
    return list.empty() || std::find(list.begin(), list.end(), name) != list.end();
  };
  struct Job {
    const Extreme* extreme;
    double level;
  };
  std::vector<Cell> cells;
  std::vector<Job> jobs;
  for (const auto& extreme : extremes()) {
    if (!chosen(selection.cases, extreme.name)) continue;
    for (const double level : extreme.levels)
      for (const auto& solver : contact::solver_registry()) {
        // The solver enumerate is an oracle for a few points and too slow for runs.
        if (solver.name == "enumerate" || !chosen(selection.solvers, solver.name) ||
            !chosen(extreme.solvers, solver.name))
          continue;
        for (const char* integrator : {"semi-implicit-euler", "moreau"}) {
          Cell cell;
          cell.extreme = extreme.name;
          cell.level = fmt::format("{:g}{}{}", level, extreme.unit.empty() ? "" : " ", extreme.unit);
          cell.model = {"coulomb", solver.name, integrator, 0.01};
          cells.push_back(cell);
          jobs.push_back({&extreme, level});
        }
      }
  }
  if (cells.empty()) throw InputError("no extreme runs with the solvers that were given");
  run_jobs(
      cells.size(), threads, [&](std::size_t k) { fill(*jobs[k].extreme, jobs[k].level, cells[k]); }, done);
  return cells;
}

}  // namespace nilas::verify
