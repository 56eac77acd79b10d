#include <fmt/format.h>

#include <filesystem>
#include <fstream>
#include <iostream>
#include <nlohmann/json.hpp>
#include <thread>

#include "apps/nilas/commands/commands.h"
#include "apps/verify/extremes.h"
#include "apps/verify/limitations.h"
#include "apps/verify/page.h"
#include "apps/verify/table.h"
#include "apps/verify/verdicts.h"
#include "core/base/error.h"
#include "core/output/run/claim_folder.h"
#include "core/output/text/console.h"
#include "core/output/text/phase_progress.h"

namespace nilas::commands {

namespace {

struct VerifyOptions {
  verify::Selection selection;
  std::string out;
  int threads = std::max(1, static_cast<int>(std::thread::hardware_concurrency()));
  bool extremes = false, limitations = false, json = false, html = false, list = false, markdown = false, force = false,
       quiet = false;
};

void write_text(const std::filesystem::path& file, const std::string& text) {
  std::ofstream out(file);
  out << text;
  if (!out.flush()) throw FileError("cannot write " + file.string());
}

/// Reports every tenth of the work on standard error.
std::function<void(double)> progress(const VerifyOptions& options) {
  if (output::phase_style(options.quiet, options.json) == output::ConsoleStyle::silent) return {};
  return [last = -1](double share) mutable {
    constexpr int k_tenths = 10;
    const int tenth = static_cast<int>(share * k_tenths);
    if (tenth > last) std::cerr << fmt::format("{} %\n", tenth * k_tenths);
    last = std::max(last, tenth);
  };
}

int run_cases(const VerifyOptions& options) {
  if (!options.out.empty()) output::claim_folder(options.out, options.force);
  const double started = output::steady_seconds();
  const std::vector<verify::Row> rows = verify::verify(options.selection, options.threads, progress(options));
  const bool holds = verify::all_hold(rows);
  if (options.json) {
    const nlohmann::ordered_json result{{"holds", holds}, {"rows", verify::table_json(rows)}};
    std::cout << result.dump(2) << "\n";
  } else {
    if (!options.quiet) std::cout << verify::table_text(rows);
    std::cout << verify::failures_text(rows);
    const auto failed = std::count_if(rows.begin(), rows.end(), [](const verify::Row& row) { return !row.holds; });
    std::cout << fmt::format("{} rows, {} of them fail, in {}\n", rows.size(), failed,
                             output::duration_text(output::steady_seconds() - started));
  }
  // The files come last, so that a missing plotter loses no result.
  if (!options.out.empty()) {
    write_text(std::filesystem::path(options.out) / "verify.csv", verify::table_csv(rows));
    if (options.html) verify::write_page(options.out, rows);
    if (!options.json && !options.quiet) std::cout << "written to " << options.out << "\n";
  }
  return holds ? exit_done : exit_numerics;
}

int run_map(const VerifyOptions& options) {
  output::claim_folder(options.out, options.force);
  const double started = output::steady_seconds();
  const std::vector<verify::Cell> cells = verify::run_extremes(options.selection, options.threads, progress(options));
  const auto failed = std::count_if(cells.begin(), cells.end(), [](const verify::Cell& cell) {
    return cell.hold == verify::Hold::fails || cell.hold == verify::Hold::refused;
  });
  if (options.json)
    std::cout << verify::extremes_json(cells).dump(2) << "\n";
  else if (!options.quiet)
    std::cout << verify::extremes_text(cells)
              << fmt::format("{} runs, {} of them fail, in {}; the map is in {}\n", cells.size(), failed,
                             output::duration_text(output::steady_seconds() - started), options.out);
  verify::write_extremes(options.out, cells);
  return failed == 0 ? exit_done : exit_numerics;
}

int verify_command(const VerifyOptions& options) {
  if (options.list) {
    std::cout << verify::catalogue_text();
    return exit_done;
  }
  if (options.limitations) {
    std::cout << verify::limitations_markdown(verify::limitations());
    return exit_done;
  }
  if (options.markdown) {
    std::cout << verify::catalogue_markdown();
    return exit_done;
  }
  return options.extremes ? run_map(options) : run_cases(options);
}

}  // namespace

void add_verify(CLI::App& app, Action& action) {
  auto* command = app.add_subcommand("verify", "Runs the cases with known answers and prints their errors.");
  auto options = std::make_shared<VerifyOptions>();
  auto* cases = command
                    ->add_option("--case", options->selection.cases,
                                 "Runs this case (A3 or 3) or family of cases (A), or with --extremes the extreme of "
                                 "this name. The flag may be repeated.")
                    ->allow_extra_args(false);
  command->add_option("--solver", options->selection.solvers, "Runs only with this solver. The flag may be repeated.")
      ->allow_extra_args(false);
  auto* law =
      command->add_option("--law", options->selection.laws, "Runs only with this law. The flag may be repeated.")
          ->allow_extra_args(false);
  auto* all = command->add_flag("--all", options->selection.all, "Runs every solver with every integrator.");
  auto* extremes = command->add_flag(
      "--extremes", options->extremes,
      "Runs scenes with extreme values instead, and draws a map of where each solver keeps all limits.");
  auto* limitations = command->add_flag(
      "--limitations", options->limitations,
      "Prints the page docs/evidence/limitations.md: what the simplifications of game-engine based simulators cost.");
  auto* list = command->add_flag("--list", options->list, "Lists the cases and runs none.");
  auto* markdown =
      command->add_flag("--markdown", options->markdown,
                        "Prints the page docs/evidence/verification.md, which lists the cases and their formulas.");
  command->add_option("--out", options->out,
                      "Writes the results into this folder. The default is runs/verify with --html, runs/extremes with "
                      "--extremes and no folder otherwise.");
  auto* html =
      command->add_flag("--html", options->html, "Writes verify.html with a picture per family. It needs gnuplot.");
  command->add_flag("--force", options->force, "Writes into the folder even if it is not empty.");
  command
      ->add_option("--threads", options->threads,
                   "Computes on this many threads. The results do not depend on the number.")
      ->check(CLI::Range(1, 256))
      ->capture_default_str();
  auto* json =
      command->add_flag("--json", options->json, "Prints all rows as JSON on standard output, and nothing else there.");
  command->add_flag("--quiet", options->quiet, "Prints only the rows that fail, and their number.");
  extremes->excludes(law)->excludes(all)->excludes(html)->excludes(limitations)->excludes(list)->excludes(markdown);
  for (auto* page : {limitations, list, markdown}) page->excludes(html)->excludes(json)->excludes(all)->excludes(cases);
  limitations->excludes(list)->excludes(markdown);
  list->excludes(markdown);
  command->callback([&action, options] {
    if (options->html && options->out.empty()) options->out = "runs/verify";
    if (options->extremes && options->out.empty()) options->out = "runs/extremes";
    action = [options] { return verify_command(*options); };
  });
}

}  // namespace nilas::commands
