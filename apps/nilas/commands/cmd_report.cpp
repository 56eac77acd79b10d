#include <fmt/format.h>

#include <filesystem>
#include <iostream>
#include <nlohmann/json.hpp>

#include "apps/nilas/commands/commands.h"
#include "apps/report/drawn_run.h"
#include "apps/report/page/comparison.h"
#include "apps/report/page/figure_files.h"
#include "apps/report/page/report_page.h"
#include "apps/view/page.h"
#include "core/base/error.h"
#include "core/base/file_bytes.h"
#include "core/output/file/output_file.h"
#include "core/output/text/console.h"
#include "core/output/text/phase_progress.h"
#include "core/output/text/plot.h"
#include "core/scene/read/read_scene.h"
#include "core/sim/simulation.h"

namespace nilas::commands {

namespace {

namespace fs = std::filesystem;

struct ReportOptions {
  std::vector<std::string> runs;
  std::string out, body;
  std::vector<double> contacts;
  double window = 0.2;
  bool figures = false, json = false;
};

void make_folder(const fs::path& folder) {
  std::error_code error;
  fs::create_directories(folder, error);
  if (error) throw FileError(folder.string() + ": " + error.message());
}

int draw_contacts(const ReportOptions& options) {
  if (options.runs.size() > 1)
    throw InputError("--contacts draws one run; found " + std::to_string(options.runs.size()));
  const fs::path run = options.runs.front(), out = options.out.empty() ? run : fs::path(options.out);
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
  make_folder(out);
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

/// What the report of one run or the comparison of several writes.
struct WrittenReport {
  report::ReportPage page;
  fs::path file;
  std::vector<std::string> figures;
};

/// Prints the first sentences, what is missing, and where the files are.
void tell(const WrittenReport& written, const ReportOptions& options) {
  const fs::path folder = written.file.parent_path();
  if (options.json) {
    nlohmann::ordered_json json{{"file", written.file.string()}, {"headline", written.page.headline}};
    json["figures"] = nlohmann::ordered_json::array();
    for (const auto& name : written.figures) json["figures"].push_back((folder / "figures" / name).string());
    json["gaps"] = written.page.sections.back().gaps;
    std::cout << json.dump(2, ' ', false, nlohmann::ordered_json::error_handler_t::replace) << "\n";
    return;
  }
  for (const auto& sentence : written.page.headline) std::cout << output::wrapped(sentence, 0) << "\n";
  for (const auto& gap : written.page.sections.back().gaps) std::cout << output::wrapped("missing: " + gap, 0) << "\n";
  if (!written.figures.empty())
    std::cout << fmt::format("written: {} figures in {}\n", written.figures.size(), (folder / "figures").string());
  std::cout << "written: " << written.file.string() << "\n"
            << "Open it in a browser; it needs no other file and no network.\n";
}

/// A run compared with itself would seem to agree.
void demand_different(const std::vector<std::string>& runs) {
  for (std::size_t k = 0; k < runs.size(); ++k)
    for (std::size_t j = 0; j < k; ++j)
      if (fs::exists(runs[k]) && fs::exists(runs[j]) && fs::equivalent(runs[k], runs[j]))
        throw InputError("the run " + runs[k] + " is named twice; allowed: different runs");
}

int write_report(const ReportOptions& options) {
  view::demand_page();
  demand_different(options.runs);
  const bool compares = options.runs.size() > 1;
  output::PhaseProgress progress(std::cerr, output::phase_style(options.json, options.json), "reading the run");
  std::vector<std::unique_ptr<report::RunFindings>> runs;
  for (const std::string& run : options.runs) {
    // All runs are compared by the load on the same body: that of the first.
    const bool follows = options.body.empty() && !runs.empty() && runs.front()->load != nullptr;
    const std::string body = follows && !runs.front()->load->is_vessel() ? runs.front()->load->name : options.body;
    runs.push_back(report::examine_run(run, body));
  }
  progress.next("making the report");
  WrittenReport written;
  written.page = compares ? report::comparison_page(runs) : report::report_page(*runs.front(), options.out.empty());
  const fs::path folder = options.out.empty() ? fs::path(options.runs.front()) : fs::path(options.out);
  make_folder(folder);
  written.file = folder / (compares ? "comparison.html" : "report.html");
  output::write_whole(written.file, report::page_html(written.page));
  if (options.figures) {
    progress.next("drawing the figures");
    make_folder(folder / "figures");
    try {
      written.figures = report::write_figures(written.page, folder / "figures");
    } catch (const FileError& fault) {
      throw FileError(std::string(fault.what()) + "; " + written.file.string() + " was written, without figures");
    }
  }
  progress.end();
  tell(written, options);
  return exit_done;
}

}  // namespace

void add_report(CLI::App& app, Action& action) {
  auto* command = app.add_subcommand("report", "Writes a page that explains a run, or compares several.");
  auto options = std::make_shared<ReportOptions>();
  command
      ->add_option("run", options->runs,
                   "Reads the run in this folder and writes report.html. With several, compares them and writes "
                   "comparison.html.")
      ->required();
  auto* figures =
      command->add_flag("--figures", options->figures,
                        "Also writes each graph as SVG and PDF for papers, into the folder figures beside the page.");
  auto* contacts = command->add_option(
      "--contacts", options->contacts,
      "Writes no page, but draws the contacts around these simulated times [s], separated by commas, into contacts.svg "
      "and contacts.png.");
  contacts->delimiter(',')->excludes(figures);
  command->add_option("--window", options->window, "Draws the contacts up to this long [s] before and after each time.")
      ->check(at_least(0))
      ->needs(contacts)
      ->capture_default_str();
  command->add_option(
      "--body", options->body,
      "Reports on the vessel or fixed body of this name. The default is the vessel, or without one the fixed body with "
      "the largest mean load; for --contacts all fixed bodies.");
  command->add_option("--out", options->out,
                      "Writes into this folder. The default is the run folder; of several runs, the first.");
  command->add_flag("--json", options->json, "Prints the sentences and the names of the files as JSON.")
      ->excludes(contacts);
  command->callback([&action, options] {
    action = [options] { return options->contacts.empty() ? write_report(*options) : draw_contacts(*options); };
  });
}

}  // namespace nilas::commands
