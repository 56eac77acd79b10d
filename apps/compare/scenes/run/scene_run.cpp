#include "apps/compare/scenes/run/scene_run.h"

#include <fmt/format.h>

namespace nilas::compare {

ChildTask task_of(const SceneRun& run) {
  ChildTask task;
  task.command = {own_program().string(),
                  "run",
                  run.scene.string(),
                  "--out",
                  run.folder.string(),
                  "--force",
                  "--quiet",
                  "--threads",
                  "1"};
  scene::Overrides all = run.overrides;
  all.insert(all.end(), {{"time/@end", fmt::format("{}", run.end)},
                         {"output/@trajectory_every", fmt::format("{}", run.sample_every)},
                         {"output/@bodies", run.sample_every > 0 ? "true" : "false"},
                         {"output/@contacts", "none"},
                         {"output/@problems", "never"},
                         {"output/@checkpoint_every", "0"}});
  for (const auto& [path, value] : all) {
    task.command.emplace_back("--set");
    task.command.push_back(path + "=" + value);
  }
  task.log = run.log;
  return task;
}

}  // namespace nilas::compare
