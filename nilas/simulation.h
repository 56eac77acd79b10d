#pragma once
/// Runs a scene step by step.
///
///   const nilas::Scene scene = nilas::Scene::read("towing.xml");
///   nilas::Simulation simulation(scene, {.threads = 2});
///   while (!simulation.is_done()) {
///     const nilas::Step step = simulation.step();
///     if (step.vessel) std::cout << simulation.time() << " " << step.vessel->ice_force[0] << "\n";
///   }
#include <array>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "nilas/error.h"
#include "nilas/export.h"
#include "nilas/problem.h"
#include "nilas/scene.h"

namespace nilas {

using Vector3 = std::array<double, 3>;

struct SimulationSettings {
  int threads = 1;  ///< at least 1; the results do not depend on it
  /// Whether apply() may be called. Then the ledger has a column work_applied_J, and a vessel's outputs applied_*.
  bool applied_loads = false;
};

/// All bodies at one time: a row per body, in the order of their indices. Frames: docs/reference/conventions.md.
struct BodyStates {
  std::vector<std::int64_t> id;          ///< never repeats in a run
  std::vector<std::string> name, kind;   ///< kind: floe, rigid, wall or vessel
  std::vector<double> mass;              ///< [kg]
  std::vector<double> position;          ///< n x 3: centre of mass [m]
  std::vector<double> orientation;       ///< n x 4: unit quaternion w, x, y, z from body axes to the ground frame
  std::vector<double> velocity;          ///< n x 3: of the centre of mass [m/s]
  std::vector<double> angular_velocity;  ///< n x 3, ground frame [rad/s]
};

/// Loads on the vessel over a step, and its motion at the end of the step, in the ground frame.
struct VesselStep {
  Vector3 contact_force{}, contact_torque{};  ///< by all contacts, the torque about the centre of mass [N], [N m]
  Vector3 ice_force{};                        ///< by floes alone [N]
  Vector3 position{}, velocity{}, angular_velocity{};
  std::array<double, 4> orientation{1, 0, 0, 0};  ///< w, x, y, z
};

/// What one step did.
struct Step {
  long number = 0;  ///< the first is 1
  double time = 0;  ///< at its end [s]
  int contacts = 0, floes = 0, iterations = 0;
  bool solved = true;   ///< whether the solver reached the scene's tolerance
  std::string message;  ///< what the solver did, or why it failed
  double residual = 0;  ///< of the contact law [m/s]
  std::uint64_t state_hash = 0;
  std::vector<double> numbers;         ///< in the order of Simulation::step_columns()
  std::vector<double> vessel_numbers;  ///< in the order of Simulation::vessel_columns()
  std::optional<VesselStep> vessel;
};

/// A state to which a simulation can return.
class NILAS_API Snapshot {
 public:
  Snapshot(const Snapshot& other);
  Snapshot(Snapshot&& other) noexcept;
  ~Snapshot();

 private:
  friend class Simulation;
  struct Content;
  explicit Snapshot(std::unique_ptr<Content> content);
  std::unique_ptr<Content> content_;
};

/// One thread at a time may use an object. A child of fork() may not use those of its parent.
class NILAS_API Simulation {
 public:
  /// Builds the scene's bodies. Throws Error for content that cannot run, such as an open hull.
  explicit Simulation(const Scene& scene, const SimulationSettings& settings = {});
  Simulation(Simulation&&) noexcept;
  ~Simulation();

  /// Advances by the scene's step. Throws Error of kind numerics, after which the simulation cannot go on.
  Step step();
  /// Whether the scene's end time is reached, or the course has ended.
  bool is_done() const;
  /// Why the run ends before the scene's end time: the carriage's path is at its end. Empty where it can go on.
  std::string end_of_course() const;
  double time() const;  ///< [s]
  long steps() const;   ///< number of steps since the start
  const Scene& scene() const;

  BodyStates bodies() const;
  int num_bodies() const;
  int vessel() const;  ///< index of the vessel; -1: there is none
  /// Names of Step::numbers and Step::vessel_numbers: those of steps.csv without `status` and `state_hash`, and those
  /// of vessel.csv.
  std::vector<std::string> step_columns() const;
  std::vector<std::string> vessel_columns() const;
  /// Models that were built, with the elements that ask for them.
  std::vector<std::pair<std::string, std::string>> modules() const;
  /// Warnings since the start, by kind, with their numbers.
  std::vector<std::pair<std::string, long>> warnings() const;

  /// Loads a body in the next step, on top of what was applied before: a force [N] at a point (ground frame [m]; by
  /// default the centre of mass) and a torque [N m]. The point moves with the body in no way: it is where the force
  /// acts throughout the step. Throws Error without SimulationSettings::applied_loads, for a body that does not exist,
  /// and for numbers that are not finite.
  void apply(int body, const Vector3& force, const Vector3& torque = {}, const std::optional<Vector3>& point = {});
  /// What controllers set: rudders, propellers and thrusters of the scene, by name, in SI units.
  std::vector<std::pair<std::string, double>> commands() const;
  /// Throws Error for an unknown name, a measured value, or a number that is not finite.
  void set_command(const std::string& name, double value);

  /// The contact problem of the last step, and the impulses that solve it, 3 nc [N s].
  Problem last_problem() const;
  std::vector<double> last_impulses() const;

  /// The present state, and the return to it: the next steps then have the same bits. The return builds the scene anew,
  /// which takes as long as at the start, and the last problem is empty until the next step. Throws Error for a
  /// snapshot of another scene, and where the integrator is `reference`; then the simulation stays as it was.
  Snapshot snapshot() const;
  void restore(const Snapshot& snapshot);

 private:
  friend class RunWriter;
  struct Content;
  std::unique_ptr<Content> content_;
};

/// Writes a run folder like that of `nilas run`, with the same numbers.
class NILAS_API RunWriter {
 public:
  /// Creates the folder and writes the state at the start. The simulation must have taken no step yet, and outlive
  /// this. force: files of an earlier run there are replaced. Throws Error.
  RunWriter(const Simulation& simulation, const std::filesystem::path& folder, bool force = false);
  RunWriter(RunWriter&&) noexcept;
  ~RunWriter();

  /// Writes the step that was taken last. Call it once after each. Throws Error.
  void record();
  /// Writes summary.json and closes the files. status: done, interrupted or failed. message: why, for the log. Throws
  /// Error.
  void finish(const std::string& status = "done", const std::string& message = {});

 private:
  struct Content;
  std::unique_ptr<Content> content_;
};

}  // namespace nilas
