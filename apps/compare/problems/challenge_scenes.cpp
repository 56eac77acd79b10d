#include "apps/compare/problems/challenge_scenes.h"

#include <algorithm>
#include <cmath>

#include "core/base/log.h"
#include "core/scene/read/read_scene.h"
#include "core/sim/simulation.h"

namespace nilas::compare {

namespace {

bool all_can_move(const contact::ContactProblem& problem) {
  const std::vector<Mat3> diagonal = contact::delassus_diagonal(problem);
  for (int c = 0; c < problem.num_contacts(); ++c)
    if (!problem.is_moment(c) && !(diagonal[c].trace() > 0)) return false;
  return true;
}

}  // namespace

std::optional<HardestStep> hardest_step(const std::filesystem::path& scene_file, double until,
                                        const std::function<bool()>& stop) {
  const scene::Scene scene = scene::read_scene(scene_file);
  WarningCounts warnings(make_logger("off", ""));
  sim::Simulation simulation(scene, 1, warnings);
  std::optional<HardestStep> hardest;
  const double end = std::min(until, scene.time.end), half_step = 0.5 * scene.time.step;
  while (simulation.time() < end - half_step) {
    if (stop()) return {};
    simulation.step();
    for (const auto& part : simulation.solved_substeps()) {
      const int contacts = part.problem.num_contacts(), iterations = part.solution.iterations;
      const bool harder =
          !hardest || std::pair(iterations, contacts) > std::pair(hardest->iterations, hardest->problem.num_contacts());
      if (contacts > 0 && harder && all_can_move(part.problem))
        hardest = HardestStep{part.problem, simulation.time(), iterations};
    }
  }
  return hardest;
}

std::vector<StoredStep> last_steps(const std::filesystem::path& scene_file, double until,
                                   const std::function<bool()>& stop) {
  const scene::Scene scene = scene::read_scene(scene_file);
  WarningCounts warnings(make_logger("off", ""));
  sim::Simulation simulation(scene, 1, warnings);
  const int count =
      static_cast<int>(std::lround((std::min(until, scene.time.end) - scene.time.start) / scene.time.step));
  constexpr int k_apart = 5, k_first = 2 * k_apart;
  std::vector<StoredStep> found;
  for (int done = 1; done <= count; ++done) {
    if (stop()) return {};
    simulation.step();
    const contact::SolvedProblem& solved = simulation.last_problem();
    if ((count - done) % k_apart != 0 || count - done > k_first || solved.problem.num_contacts() == 0) continue;
    if (all_can_move(solved.problem)) found.push_back({solved.problem, solved.guess, simulation.time(), done});
  }
  return found;
}

}  // namespace nilas::compare
