#include <fmt/format.h>

#include <filesystem>
#include <iostream>

#include "apps/nilas/commands.h"
#include "apps/report/contact_picture.h"
#include "apps/report/floe_outlines.h"
#include "core/base/error.h"
#include "core/output/phase_progress.h"
#include "core/output/plot.h"
#include "core/scene/read_scene.h"
#include "core/sim/simulation.h"

namespace nilas {

namespace {

struct ReportOptions {
  std::string run, out;
  std::vector<double> contacts;
  double window = 0.2;
};

/// The vessel's mesh in V; its body has the centre of mass as origin.
TriangleMesh hull_mesh(const Simulation& simulation) {
  TriangleMesh mesh = simulation.bodies().shape[static_cast<std::size_t>(simulation.vessel_index())]->surface;
  for (Vec3& p : mesh.vertices) p += simulation.info().vessel_mass.com;
  return mesh;
}

int report(const ReportOptions& options) {
  const std::filesystem::path run = options.run, out = options.out.empty() ? run : std::filesystem::path(options.out);
  const Scene scene = read_scene(run / "scene.xml");
  WarningCounts warnings(make_logger("off", ""));
  PhaseProgress progress(std::cerr, phase_style(false, false), "building the scene again, for its shapes");
  const Simulation simulation(scene, 1, warnings);
  const int vessel = simulation.vessel_index();
  if (vessel < 0) throw InputError(run.string() + ": is a run without a vessel, so it has no contacts of a hull");
  const auto vessel_id = simulation.bodies().id[static_cast<std::size_t>(vessel)];
  progress.next("reading the contacts");
  ContactPictureInput picture;
  picture.title = "Contacts of ice and hull: " + scene.name;
  picture.windows = contact_windows(run / "contacts.h5", vessel_id, scene.time, options.contacts, options.window);
  picture.hull = hull_mesh(simulation);
  picture.water_level = scene.water ? scene.water->level : 0;
  for (const double t : options.contacts)
    picture.floes.push_back(
        floe_outlines(run / "bodies.csv", simulation.bodies(), vessel, simulation.info().vessel_mass.com, t));
  std::error_code error;
  std::filesystem::create_directories(out, error);
  if (error) throw FileError(out.string() + ": " + error.message());
  progress.next("drawing the contacts");
  plot(out, contact_picture_script(picture));
  progress.end();
  for (const auto& window : picture.windows)
    std::cout << fmt::format("t = {:g} +- {:g} s: {} contacts in {} steps, mean force {:.3f} {:.3f} {:.3f} N\n",
                             window.t, window.half_width, window.marks.size(), window.steps, window.mean_force.x(),
                             window.mean_force.y(), window.mean_force.z());
  std::cout << "written: " << (out / "contacts.svg").string() << ", " << (out / "contacts.png").string() << "\n";
  return exit_done;
}

}  // namespace

void add_report(CLI::App& app, Action& action) {
  auto* command = app.add_subcommand("report", "draws what a run left: where ice met the hull, and with what force");
  auto options = std::make_shared<ReportOptions>();
  command->add_option("run", options->run, "run folder")->required();
  command
      ->add_option("--contacts", options->contacts,
                   "times about which hull contacts are drawn, separated by commas: contacts.svg and contacts.png [s]")
      ->required()
      ->delimiter(',');
  command->add_option("--window", options->window, "contacts up to so long before and after each time [s]")
      ->check(at_least(0))
      ->capture_default_str();
  command->add_option("--out", options->out, "folder for the pictures (default: the run folder)");
  command->callback([&action, options] { action = [options] { return report(*options); }; });
}

}  // namespace nilas
