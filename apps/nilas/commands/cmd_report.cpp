#include <fmt/format.h>

#include <filesystem>
#include <iostream>

#include "apps/nilas/commands/commands.h"
#include "apps/report/drawn_run.h"
#include "core/base/error.h"
#include "core/base/file_bytes.h"
#include "core/output/text/console.h"
#include "core/output/text/phase_progress.h"
#include "core/output/text/plot.h"
#include "core/scene/read/read_scene.h"
#include "core/sim/simulation.h"

namespace nilas::commands {

namespace {

struct ReportOptions {
  std::string run, out, body;
  std::vector<double> contacts;
  double window = 0.2;
};

int draw_report(const ReportOptions& options) {
  const std::filesystem::path run = options.run, out = options.out.empty() ? run : std::filesystem::path(options.out);
  demand_there(run, "run folder");
  const scene::Scene scene = scene::read_scene(run / "scene.xml");
  WarningCounts warnings(make_logger("off", ""));
  output::PhaseProgress progress(std::cerr, output::phase_style(false, false),
                                 "building the scene again for its shapes");
  const sim::Simulation simulation(scene, 1, warnings);
  progress.next("reading the contacts");
  std::vector<std::string> notes;
  const report::ContactPictureInput picture =
      report::contact_picture(run, scene, simulation, options.body, options.contacts, options.window, notes);
  std::error_code error;
  std::filesystem::create_directories(out, error);
  if (error) throw FileError(out.string() + ": " + error.message());
  progress.next("drawing the contacts");
  output::plot(out, report::contact_picture_script(picture));
  progress.end();
  for (const auto& [window, loads, floes] : picture.rows)
    std::cout << fmt::format("t = {:g} +- {:g} s: {} contacts in {} steps\n  {}\n", window.t, window.half_width,
                             window.marks.size(), window.steps, loads);
  for (const auto& note : notes) std::cout << output::wrapped(note, 0) << "\n";
  std::cout << "written: " << (out / "contacts.svg").string() << ", " << (out / "contacts.png").string() << "\n";
  return exit_done;
}

}  // namespace

void add_report(CLI::App& app, Action& action) {
  auto* command =
      app.add_subcommand("report", "Draws where ice touched the vessel or fixed bodies in a run, and with what force.");
  auto options = std::make_shared<ReportOptions>();
  command->add_option("run", options->run, "Reads the run in this folder.")->required();
  command
      ->add_option("--contacts", options->contacts,
                   "Draws the contacts around these simulated times [s], separated by commas, into contacts.svg and "
                   "contacts.png.")
      ->required()
      ->delimiter(',');
  command->add_option("--window", options->window, "Draws the contacts up to this long [s] before and after each time.")
      ->check(at_least(0))
      ->capture_default_str();
  command->add_option(
      "--body", options->body,
      "Draws the vessel or fixed body of this name. The default is the vessel, or all fixed bodies without "
      "one.");
  command->add_option("--out", options->out, "Writes the pictures into this folder. The default is the run folder.");
  command->callback([&action, options] { action = [options] { return draw_report(*options); }; });
}

}  // namespace nilas::commands
