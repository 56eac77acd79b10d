#include "core/sim/step/solve_contacts.h"

#include <fmt/format.h>

#include <algorithm>

#include "contact/detect/broad/contact_key.h"
#include "core/sim/step/advance.h"
#include "core/sim/step/fast_bodies.h"
#include "core/sim/step/vessel_step.h"

namespace nilas::sim {

namespace {

/// Overlaps that a solved substep must not lead to [share of the thickness]: a body that reaches half of the thickness
/// can leave on the other side. Smaller overlaps become a penetration of the next step.
constexpr detect::SoughtOverlap k_passing{0.02, k_fast_share};
/// Largest number of solutions of one substep in which a body may miss a contact, before the substep is halved or
/// judged.
constexpr int k_most_misses = 8, k_most_misses_whole = 40;

/// Frames with orthonormal columns for every contact; a moment has the frame of its contact.
std::vector<Mat3> orthonormal_frames(const contact::AssembledContacts& contacts) {
  std::vector<Mat3> frames = contacts.C;
  for (std::size_t c = 0; c < frames.size(); ++c)
    if (contacts.problem.is_moment(static_cast<int>(c))) frames[c] = contacts.C[contacts.problem.moments[c].contact];
  return frames;
}

/// First guess: the impulses of the last solution, and those that modules know for new bodies.
VecX first_guess(World& world, const SolvedContacts& solved, const std::vector<Mat3>& frames) {
  VecX guess;
  if (world.model.warm_start) {
    guess = world.warm.guess(solved.contacts.problem.key, frames);
    for (const auto& module : world.parts.modules)
      module->add_to_guess(world.parts.bodies, solved.found.points, solved.contacts.C, guess);
  }
  return guess;
}

void solve(World& world, SolvedContacts& solved) {
  contact::ContactProblem& problem = solved.contacts.problem;
  const std::vector<Mat3> frames = orthonormal_frames(solved.contacts);
  const contact::PreparedProblem prepared(problem);
  solved.guess = first_guess(world, solved, frames);
  contact::StaticFrictionSolution found = world.model.solve(problem, prepared, solved.guess, solved.slipping);
  solved.solution = std::move(found.solution);
  solved.slipping = std::move(found.slipping);
  world.warm.keep(problem.key, frames, solved.solution.r);
  for (const auto& module : world.parts.modules) module->end_guess();
  solved.num_islands = static_cast<int>(prepared.islands().size());
  solved.residuals = contact::measure(prepared, solved.solution.r, solved.solution.v, solved.d, world.threads);
}

/// Velocities of the free bodies and of the vessel after the impulses.
contact::Velocities solved_velocities(const World& world, const Loads& loads, const Substep& substep,
                                      const SolvedContacts& solved,
                                      const std::vector<contact::ArticulatedBlock>& vessel) {
  const contact::AssembledContacts& contacts = solved.contacts;
  contact::Velocities after = new_velocities(world, contacts, solved.solution, loads, substep.h);
  for (const contact::ArticulatedBlock& block : vessel) {
    VecX without_contact;
    for (const contact::ArticulatedBody& body : block.bodies) {
      Vec6 twist = body.prescribed;
      const auto b = static_cast<std::size_t>(body.body);
      if (const int k = contacts.block_of_body[b]; k >= 0) {
        twist += body.jacobian * solved.solution.v.segment(contacts.problem.block_offset[k], body.jacobian.cols());
      } else if (block.f.size() > 0) {
        if (without_contact.size() == 0) without_contact = block.mass.ldlt().solve(block.f);
        twist += body.jacobian * without_contact;
      }
      after.v[b] = twist.head<3>();
      after.w[b] = twist.tail<3>();
    }
  }
  return after;
}

/// Contacts that the solved velocities lead to. Each body has its own number of solutions in which it may miss some, so
/// that unrelated bodies do not use it up.
class MissedContacts {
 public:
  MissedContacts(World& world, const Substep& substep, bool can_halve)
      : world_(world),
        substep_(substep),
        most_(can_halve ? k_most_misses : k_most_misses_whole),
        misses_(world.size(), 0) {}

  /// Adds the contacts of fast pairs that the velocities still lead into each other. Returns whether there are any.
  bool add(const contact::Velocities& after, SolvedContacts& solved) {
    solved.unheld.clear();
    if (world_.model.detection != Detection::continuous) return false;
    std::vector<char> missed(world_.size(), 0);
    bool added = false;
    for (const detect::SweptPair& pair : sweep(world_, after, substep_.h, substep_.h, k_passing)) {
      if (!pair.first.hit || pair.first.t == 0) continue;
      const auto a = static_cast<std::size_t>(pair.a), b = static_cast<std::size_t>(pair.b);
      const int before = std::max(misses_[a], misses_[b]);
      if (before >= most_) {
        solved.unheld.emplace_back(pair.a, pair.b);
        continue;
      }
      missed[a] = missed[b] = 1;
      for (const detect::ContactPoint& met : pair.points) {
        detect::ContactPoint& point =
            solved.found.points.emplace_back(as_gap(world_, met, pair.first.t, after, substep_.h));
        point.key = detect::mix(met.key, static_cast<std::uint64_t>(before) + 1);
        solved.found.met_on_path.push_back(point.key);
        added = true;
      }
    }
    for (std::size_t b = 0; b < misses_.size(); ++b) misses_[b] += missed[b];
    if (added) sort_as_detected(solved.found.points);
    return added;
  }

 private:
  World& world_;
  Substep substep_;
  int most_;
  std::vector<int> misses_;
};

}  // namespace

contact::Velocities new_velocities(const World& world, const contact::AssembledContacts& contacts,
                                   const contact::ContactSolution& solution, const Loads& loads, double h) {
  contact::Velocities after;
  free_velocities(world.parts.bodies, loads.total, h, after);
  for (std::size_t b = 0; b < world.size(); ++b) {
    const int block = contacts.block_of_body[b];
    if (block < 0 || !world.parts.bodies.is_free(static_cast<int>(b))) continue;
    const int first = contacts.problem.block_offset[block];
    after.v[b] = solution.v.segment<3>(first);
    after.w[b] = solution.v.segment<3>(first + 3);
  }
  return after;
}

SolvedContacts solve_contacts(World& world, const Loads& loads, const Substep& substep, FoundContacts found,
                              bool can_halve, const NoteSolution& note, Stopwatch& watch) {
  SolvedContacts solved;
  solved.found = std::move(found);
  solved.slipping = world.slipping;
  const std::vector<contact::ArticulatedBlock> vessel = begin_vessel_step(world, loads.total, substep.h);
  const contact::AssemblySettings settings = world.model.assembly_over(substep.h);
  MissedContacts missed(world, substep, can_halve);
  bool goes_on = true;
  while (goes_on) {
    solved.contacts = contact::assemble(world.parts.bodies, loads.total, solved.found.points, world.parts.friction,
                                        settings, vessel, world.springs(solved.found.points));
    watch.lap(Phase::assembly);
    solve(world, solved);
    note(solved.solution, solved.residuals);
    solved.after = solved_velocities(world, loads, substep, solved, vessel);
    watch.lap(Phase::solver);
    // Each round books its own times: the search for missed contacts may take longer than all else.
    goes_on = missed.add(solved.after, solved);
    watch.lap(Phase::detection);
  }
  return solved;
}

void judge_unheld(World& world, const Substep& substep, const SolvedContacts& solved) {
  if (solved.unheld.empty()) return;
  if (const auto pair = passing_bodies(world, solved.after, substep.h)) refuse_passing(world, *pair, substep.t);
  world.warnings.warn("steps with impacts that were not resolved",
                      fmt::format("at {:g} s bodies overlap on their path after all solutions of the step; try a "
                                  "smaller <time step>",
                                  substep.t));
}

}  // namespace nilas::sim
