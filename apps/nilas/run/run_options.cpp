#include "apps/nilas/run/run_options.h"

#include "apps/nilas/commands/commands.h"
#include "core/base/error.h"

namespace nilas::commands {

namespace {

void add_view_flags(CLI::App& command, RunOptions& options) {
  auto* view = command.add_flag("--view", options.view,
                                "Shows the run in a browser of this machine while it goes on. The address is printed.");
  command
      .add_option("--view-port", options.view_address.port,
                  "Opens this port for the live view, as for a tunnel by ssh. The default is any free one.")
      ->check(CLI::Range(0, 65535))
      ->needs(view);
  command
      .add_option("--view-host", options.view_address.host,
                  "Opens the live view on this address, so that other machines may reach it. Use it only in a network "
                  "that you trust, since the traffic is not encrypted; a tunnel by ssh is safer.")
      ->needs(view)
      ->capture_default_str();
}

}  // namespace

CLI::Option* add_run_options(CLI::App& command, RunOptions& options) {
  auto* scene = add_scene_flags(command, options.scene)->required(false);
  command
      .add_option(
          "--checkpoint-every", options.scene.checkpoint_every,
          "Writes a checkpoint each time this much simulated time [s] has passed, instead of the scene's interval. 0 "
          "writes none.")
      ->check(at_least(0));
  command.add_option(
      "--resume", options.resume,
      "Continues the run in this folder from its newest checkpoint. It replaces the scene argument. With "
      "--until a run can be made longer.");
  command.add_option("--out", options.out,
                     "Writes the run into this folder. The default is the folder that the scene names, else "
                     "runs/<scene>-<time>.");
  command
      .add_option("--threads", options.threads,
                  "Computes on this many threads. The results do not depend on the number. More threads than free "
                  "cores make a run slower.")
      ->check(CLI::Range(1, 256))
      ->capture_default_str();
  command
      .add_option(
          "--twins", options.twins,
          "Makes this many perturbed runs, which start up to 1e-12 m away, in step with the run. summary.json then "
          "holds means, standard errors and the predictability horizon.")
      ->check(CLI::Range(0, 1000))
      ->capture_default_str();
  add_view_flags(command, options);
  command.add_flag("--open-water", options.open_water,
                   "First tows the same vessel without ice. The mean force of that is deducted from the tow force.");
  command
      .add_option("--open-water-run", options.open_water_run,
                  "Deducts the mean force of the run without ice in this folder. It must have towed the same vessel at "
                  "the same speed.")
      ->excludes("--open-water");
  command.add_flag("--force", options.force,
                   "Writes into the folder even if it is not empty. Files of an earlier run there are removed.");
  command.add_flag("--json", options.json, "Prints the summary as JSON on standard output, and nothing else there.");
  command.add_flag("--quiet", options.quiet, "Prints only warnings and errors, no progress.");
  command.add_option("--log-level", options.log_level, "Prints messages of this level and above on the console.")
      ->check(CLI::IsMember({"debug", "info", "warn", "error", "off"}))
      ->capture_default_str();
  return scene;
}

void demand_resumable(const CLI::App& command) {
  for (const char* flag :
       {"scene", "--dt", "--solver", "--law", "--seed", "--scale", "--set", "--twins", "--out", "--force"})
    if (command.get_option(flag)->count() > 0)
      throw InputError(
          std::string("--resume: a run continues with its own settings in its own folder; remove ") + flag +
          " (allowed: --until, --statistics, --open-water, --open-water-run, --checkpoint-every, --threads, --json, "
          "--quiet, --log-level, --view, --view-port, --view-host)");
}

}  // namespace nilas::commands
