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

namespace nilas {

namespace {

struct VerifyOptions {
  Selection selection;
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

/// Tells every tenth on standard error.
std::function<void(double)> progress(const VerifyOptions& options) {
  if (phase_style(options.quiet, options.json) == ConsoleStyle::silent) return {};
  return [last = -1](double share) mutable {
    constexpr int k_tenths = 10;
    const int tenth = static_cast<int>(share * k_tenths);
    if (tenth > last) std::cerr << fmt::format("{} %\n", tenth * k_tenths);
    last = std::max(last, tenth);
  };
}

int run_cases(const VerifyOptions& options) {
  if (!options.out.empty()) claim_folder(options.out, options.force);
  const double started = steady_seconds();
  const std::vector<Row> rows = verify(options.selection, options.threads, progress(options));
  const bool holds = all_hold(rows);
  if (options.json) {
    const nlohmann::ordered_json result{{"holds", holds}, {"rows", table_json(rows)}};
    std::cout << result.dump(2) << "\n";
  } else {
    if (!options.quiet) std::cout << table_text(rows);
    std::cout << failures_text(rows);
    const auto failed = std::count_if(rows.begin(), rows.end(), [](const Row& row) { return !row.holds; });
    std::cout << fmt::format("{} rows, {} of them fail, in {}\n", rows.size(), failed,
                             duration_text(steady_seconds() - started));
  }
  // last, so that a missing plotter loses nothing
  if (!options.out.empty()) {
    write_text(std::filesystem::path(options.out) / "verify.csv", table_csv(rows));
    if (options.html) write_page(options.out, rows);
    if (!options.json && !options.quiet) std::cout << "written to " << options.out << "\n";
  }
  return holds ? exit_done : exit_numerics;
}

int run_map(const VerifyOptions& options) {
  claim_folder(options.out, options.force);
  const double started = steady_seconds();
  const std::vector<Cell> cells = run_extremes(options.selection, options.threads, progress(options));
  const auto failed = std::count_if(cells.begin(), cells.end(), [](const Cell& cell) {
    return cell.hold == Hold::fails || cell.hold == Hold::refused;
  });
  if (options.json)
    std::cout << extremes_json(cells).dump(2) << "\n";
  else if (!options.quiet)
    std::cout << extremes_text(cells)
              << fmt::format("{} runs, {} of them fail, in {}; the map is in {}\n", cells.size(), failed,
                             duration_text(steady_seconds() - started), options.out);
  write_extremes(options.out, cells);
  return failed == 0 ? exit_done : exit_numerics;
}

int verify_command(const VerifyOptions& options) {
  if (options.list) {
    std::cout << catalogue_text();
    return exit_done;
  }
  if (options.limitations) {
    std::cout << limitations_markdown(limitations());
    return exit_done;
  }
  if (options.markdown) {
    std::cout << catalogue_markdown();
    return exit_done;
  }
  return options.extremes ? run_map(options) : run_cases(options);
}

}  // namespace

void add_verify(CLI::App& app, Action& action) {
  auto* command = app.add_subcommand("verify", "runs the cases with known answers and prints the table of errors");
  auto options = std::make_shared<VerifyOptions>();
  auto* cases = command
                    ->add_option("--case", options->selection.cases,
                                 "a case (A3 or 3) or a family (A), with --extremes one of its names; repeatable")
                    ->allow_extra_args(false);
  command->add_option("--solver", options->selection.solvers, "only with this solver; repeatable")
      ->allow_extra_args(false);
  auto* law =
      command->add_option("--law", options->selection.laws, "only with this law; repeatable")->allow_extra_args(false);
  auto* all = command->add_flag("--all", options->selection.all, "every solver with every integrator");
  auto* extremes =
      command->add_flag("--extremes", options->extremes,
                        "the scenes at the edge of what can be asked, and a map of where each solver holds");
  auto* limitations =
      command->add_flag("--limitations", options->limitations,
                        "the page of what older tools' simplifications cost, docs/evidence/limitations.md");
  auto* list = command->add_flag("--list", options->list, "lists the cases and runs none");
  auto* markdown =
      command->add_flag("--markdown", options->markdown, "the page of cases, docs/evidence/verification.md");
  command->add_option("--out", options->out,
                      "folder for the results (default: runs/verify with --html, runs/extremes, else none)");
  auto* html =
      command->add_flag("--html", options->html, "writes verify.html with a picture per family; needs gnuplot");
  command->add_flag("--force", options->force, "write into a folder that is not empty");
  command->add_option("--threads", options->threads, "threads; the results do not depend on it")
      ->check(CLI::Range(1, 256))
      ->capture_default_str();
  auto* json = command->add_flag("--json", options->json, "all rows as JSON on stdout and nothing else there");
  command->add_flag("--quiet", options->quiet, "only the rows that fail and the count");
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

}  // namespace nilas
