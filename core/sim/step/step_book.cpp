#include "core/sim/step/step_book.h"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "core/base/error.h"
#include "core/base/hash.h"
#include "core/sim/account/unsolved_advice.h"
#include "core/sim/step/load_check.h"
#include "core/sim/step/structure_record.h"
#include "core/sim/step/vessel_record.h"

namespace nilas::sim {

namespace {

StepLoads step_loads(const World& world, const Loads& loads) {
  StepLoads sorted;
  sorted.gravity = &world.weight;
  for (std::size_t k = 0; k < loads.by_module.size(); ++k)
    (world.parts.forces[k]->conservative() ? sorted.conservative : sorted.working).push_back(&loads.by_module[k]);
  return sorted;
}

std::uint64_t state_hash(const World& world) {
  StateHash hash;
  const bodies::Bodies& bodies = world.parts.bodies;
  for (std::size_t b = 0; b < world.size(); ++b) {
    if (bodies.motion[b] == bodies::Motion::fixed) continue;
    hash.add_vector(bodies.p_GB[b]);
    hash.add_vector(bodies.q_GB[b].coeffs());
    hash.add_vector(bodies.v_GB[b]);
    hash.add_vector(bodies.w_GB[b]);
  }
  if (world.parts.vessel) hash.add_vector(world.parts.vessel->coordinates());
  return hash.value();
}

}  // namespace

StepBook::StepBook(World& world) : world_(world), watch_(record_.ms) {
  world_.solved.clear();
  for (const auto& module : world_.parts.modules) module->begin_step();
}

void StepBook::note_found(const FoundContacts& found, bool first) {
  record_.detection += world_.detector.counts();
  if (!first) return;
  int count = 0;
  record_.penetration_max = record_.penetration_mean = 0;  // the values of a substep that was taken back do not count
  for (const auto& c : found.points) {
    if (c.gap >= 0) continue;
    ++count;
    record_.penetration_max = std::max(record_.penetration_max, -c.gap);
    record_.penetration_mean -= c.gap;
  }
  if (count > 0) record_.penetration_mean /= count;
}

void StepBook::note_solution(const contact::ContactSolution& solution, const contact::Residuals& residuals,
                             double t_end) {
  // Keep the worst of all solutions of the step.
  if (!(residuals.law_map_m_s < record_.residuals.law_map_m_s)) record_.residuals = residuals;
  nilas::sim::note_solution(world_, solution, t_end, record_);
}

void StepBook::add(const Substep& substep, const Loads& loads, SolvedContacts solved, const contact::StepMotion& motion,
                   const CorrectedPositions& corrected, const VesselStart& start) {
  const WorldParts& parts = world_.parts;
  record_.positions_corrected = record_.positions_corrected && corrected.converged;
  record_.contacts = std::max(record_.contacts, solved.contacts.problem.num_points());
  record_.islands = std::max(record_.islands, solved.num_islands);
  warn_of_unnamed_pairs(world_, motion.points);
  if (world_.load_checks.is_due(world_.steps + 1)) {
    watch_.lap(Phase::integration);
    check_load(world_, solved, motion, record_.load_check);
    watch_.lap(Phase::output);
  }
  world_.slipping = std::move(solved.slipping);
  const std::vector<Mat3> frames = std::move(solved.contacts.C);
  keep(solved, motion);
  world_.demand_finite(substep.t + substep.h);
  watch_.lap(Phase::integration);

  const VesselAccount vessel = vessel_account(world_, start);
  const StepLoads sorted = step_loads(world_, loads);
  world_.energy.velocity_step(parts.bodies, motion, sorted, vessel);
  world_.energy.position_step(kinetic_energy(parts.bodies), world_.potential(), corrected.pseudo, motion, sorted,
                              joint_work_after(world_));
  balance_ += momentum_balance(parts.bodies, motion, sorted, vessel);
  if (parts.vessel) {
    if (!record_.vessel) record_.vessel.emplace();
    const double t_end = substep.t + substep.h;
    add_share(vessel_record(world_, loads, motion, world_.solved.back(), frames, t_end), substep.h / world_.step,
              *record_.vessel);
  }
  if (!parts.info.structures.empty()) add_structure_loads(world_, motion, record_.structures);
  for (const auto& module : parts.modules) module->note_motion(parts.bodies, motion);
  ++record_.parts;
  watch_.lap(Phase::output);
}

void StepBook::keep(SolvedContacts& solved, const contact::StepMotion& motion) {
  const WorldParts& parts = world_.parts;
  contact::SolvedProblem& kept = world_.solved.emplace_back();
  kept.problem = std::move(solved.contacts.problem);
  kept.guess = std::move(solved.guess);
  kept.solution = std::move(solved.solution);
  kept.points = motion.points;
  kept.d = std::move(solved.d);
  const auto touching = [&](int body) -> contact::TouchingBody {
    const auto b = static_cast<std::size_t>(body);
    return {parts.bodies.id[b], parts.bodies.motion[b] == bodies::Motion::fixed ? 0 : 1 / parts.bodies.mass[b]};
  };
  kept.touching.reserve(motion.points.size());
  for (const detect::ContactPoint& c : motion.points) kept.touching.push_back({touching(c.a), touching(c.b)});
  kept.impulses = motion.impulses;
  kept.couples = motion.couples;
  if (!parts.vessel) return;
  kept.vessel_p = motion.p[parts.vessel_index];
  kept.vessel_R = motion.R[parts.vessel_index];
}

StepRecord StepBook::close() {
  for (const auto& module : world_.parts.modules) module->append_values(record_.module_values);
  note_end(world_, balance_, record_);
  watch_.lap(Phase::output);
  stop_on_failure(world_, record_);
  return std::move(record_);
}

void note_end(const World& world, const MomentumBalance& balance, StepRecord& record) {
  record.step = world.steps;
  record.t = world.time();
  record.h = world.step;
  record.floes = world.floes;
  record.ledger = world.energy.ledger();
  record.momentum_imbalance = balance.linear;
  record.momentum_scale = balance.linear_scale;
  record.angular_momentum_imbalance = balance.angular;
  record.angular_momentum_scale = balance.angular_scale;
  record.state_hash = state_hash(world);
}

const contact::SolvedProblem* last_problem(const World& world) {
  const auto touched =
      std::find_if(world.solved.rbegin(), world.solved.rend(),
                   [](const contact::SolvedProblem& substep) { return substep.problem.num_points() > 0; });
  if (touched != world.solved.rend()) return &*touched;
  return world.solved.empty() ? nullptr : &world.solved.front();
}

void stop_on_failure(const World& world, const StepRecord& record) {
  const contact::SolvedProblem* last = last_problem(world);
  if (!world.model.stop_on_failure || record.status == contact::SolveStatus::converged || !last ||
      last->problem.num_contacts() == 0)
    return;
  throw SimulationError(fmt::format("at {:g} s the contact solver stopped with status {}, law_map_m_s {:.3g}{}",
                                    record.t, contact::to_string(record.status), record.residuals.law_map_m_s,
                                    record.solver_message.empty() ? "" : ": " + record.solver_message));
}

void note_solution(World& world, const contact::ContactSolution& solution, double t_end, StepRecord& record) {
  record.iterations += solution.iterations;
  if (solution.status >= record.status) {
    record.status = solution.status;
    record.solver_message = solution.message;
  }
  const bool as_asked = solution.status == contact::SolveStatus::converged ||
                        (world.model.fixed_sweeps && solution.status == contact::SolveStatus::iteration_limit);
  record.solver_short = record.solver_short || !as_asked;
  if (as_asked) return;
  world.warnings.warn(
      "steps short of the contact tolerance",
      fmt::format("At {:g} s the contact solver left a residual of {:.3g} m/s,\n"
                  "  and {:.3g} m/s was asked for. Do not use the loads of such a step. {}.\n"
                  "  The solver reports: {}{}.",
                  t_end, record.residuals.law_map_m_s, world.model.tolerance, k_unsolved_advice,
                  contact::to_string(solution.status), solution.message.empty() ? "" : ",\n  " + solution.message));
}

void warn_of_unnamed_pairs(World& world, const std::vector<detect::ContactPoint>& points) {
  const bodies::Bodies& bodies = world.parts.bodies;
  for (const detect::ContactPoint& c : points) {
    const int a = bodies.material[c.a], b = bodies.material[c.b];
    if (world.parts.friction.names(a, b)) continue;
    if (!world.unnamed_pairs.emplace(std::min(a, b), std::max(a, b)).second) continue;
    const auto [first, second] = std::minmax(bodies.material_name(c.a), bodies.material_name(c.b));
    world.warnings.warn("frictionless " + first + " " + second, "'" + first + "' and '" + second +
                                                                    "' touch, but no <friction between> names them: "
                                                                    "frictionless");
  }
}

}  // namespace nilas::sim
