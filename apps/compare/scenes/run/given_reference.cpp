#include "apps/compare/scenes/run/given_reference.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "apps/compare/scenes/run/load_series.h"
#include "core/base/error.h"

namespace nilas::compare {

void demand_reference_run(const std::filesystem::path& from, const scene::Scene& scene) {
  const std::string allowed = "; allowed: auto, or the folder of a run of this scene that is done";
  if (!std::filesystem::exists(from / "summary.json"))
    throw InputError("--reference: " + from.string() + " is no run folder, because it has no summary.json" + allowed);
  const RunResult run = read_run(from, {}, ChildResult{.exit_code = 0});
  if (run.summary.status != "done")
    throw InputError("--reference: the run in " + from.string() + " is not done" + allowed);
  if (const std::string& of = run.summary.scene; of != scene.name)
    throw InputError("--reference: the run in " + from.string() + " is of the scene '" + of + "', not of '" +
                     scene.name + "'" + allowed);
  if (const auto seed = run.summary.seed.value_or(scene.seed); seed != scene.seed)
    throw InputError(fmt::format("--reference: the run in {} has the seed {}, the scene {}{}", from.string(), seed,
                                 scene.seed, allowed));
  const double end = run.summary.time_end_s;
  if (run.summary.ended_early.empty() && !(std::abs(end - scene.time.end) < scene.time.step))
    throw InputError(fmt::format("--reference: the run in {} ends at {:g} s, the scene at {:g} s{}", from.string(), end,
                                 scene.time.end, allowed));
}

void take_reference(SceneStudy& study, const SceneStore& folder, std::map<std::string, RunResult>& results) {
  const std::filesystem::path from = study.reference;
  const RunResult result = read_run(from, {}, ChildResult{.exit_code = 0});
  auto& runs = study.plan.runs;
  for (int r = 0; r < study.plan.realisations; ++r) {
    const PlannedRun run{fmt::format("reference-r{}", r), RunKind::reference, 0, r, 0};
    if (results.count(run.id) > 0) continue;
    const auto target = folder.run_folder(run.id);
    std::filesystem::create_directories(target);
    for (const char* file : {"bodies.csv", "vessel.csv"})
      if (std::filesystem::exists(from / file))
        std::filesystem::copy_file(from / file, target / file, std::filesystem::copy_options::overwrite_existing);
    keep_load_series(target);
    std::filesystem::remove(target / "vessel.csv");
    put_on_disk(target);
    folder.write_result(run.id, result);
    if (std::none_of(runs.begin(), runs.end(), [&](const PlannedRun& other) { return other.id == run.id; }))
      runs.push_back(run);
    results[run.id] = result;
  }
  folder.write(study);
}

}  // namespace nilas::compare
