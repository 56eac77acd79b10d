/// The command-line program: picks the subcommand and maps errors to exit codes.
#include <malloc.h>
#include <unistd.h>

#include <csignal>
#include <filesystem>
#include <iostream>
#include <memory>

#include "apps/nilas/commands.h"
#include "apps/nilas/help_text.h"
#include "core/base/error.h"

namespace {

int run_action(const nilas::Action& action) {
  try {
    return action();
  } catch (const nilas::SceneError& e) {
    std::cerr << e.what() << "\n" << e.faults().size() << (e.faults().size() == 1 ? " fault\n" : " faults\n");
    return e.only_unreadable_files() ? nilas::exit_file : nilas::exit_bad_input;
  } catch (const nilas::InputError& e) {
    std::cerr << "error: " << e.what() << "\n";
    return nilas::exit_bad_input;
  } catch (const nilas::FileError& e) {
    std::cerr << "error: " << e.what() << "\n";
    return nilas::exit_file;
  } catch (const std::filesystem::filesystem_error& e) {
    std::cerr << "error: " << e.what() << "\n";
    return nilas::exit_file;
  } catch (const nilas::SimulationError& e) {
    std::cerr << "error: " << e.what() << "\n";
    return nilas::exit_numerics;
  } catch (const std::exception& e) {
    std::cerr << "internal error, please report it: " << e.what() << "\n";
    return nilas::exit_numerics;
  }
}

/// Ends the program where there is nothing to finish; `run` puts its own in place once it has steps to end.
void leave(int) {
  constexpr char text[] = "interrupted\n";
  [[maybe_unused]] const auto written = ::write(STDERR_FILENO, text, sizeof text - 1);
  ::_exit(nilas::exit_interrupted);
}

}  // namespace

int main(int argc, char** argv) {
  // Each step frees and takes the same few megabytes: returning them to the system in between costs a tenth of the
  // time.
  constexpr int k_keep_bytes = 1 << 28;
  mallopt(M_TRIM_THRESHOLD, k_keep_bytes);
  mallopt(M_MMAP_THRESHOLD, k_keep_bytes);
  std::signal(SIGINT, leave);
  std::signal(SIGTERM, leave);
  CLI::App app{"Nilas simulates vessels and offshore structures in broken floating sea ice.", "nilas"};
  app.set_version_flag("--version", "nilas " NILAS_VERSION);
  app.require_subcommand(1);
  app.formatter(std::make_shared<nilas::HelpText>());
  nilas::Action action;
  nilas::add_run(app, action);
  nilas::add_check(app, action);
  nilas::add_hull(app, action);
  nilas::add_field(app, action);
  nilas::add_solve(app, action);
  nilas::add_solvers(app, action);
  nilas::add_verify(app, action);
  nilas::add_compare(app, action);
  nilas::add_report(app, action);
  nilas::add_problems(app, action);
  nilas::add_schema(app, action);
  try {
    app.parse(argc, argv);
  } catch (const CLI::Success& e) {
    return app.exit(e);
  } catch (const CLI::ParseError& e) {
    app.exit(e);
    return nilas::exit_bad_input;
  }
  return run_action(action);
}
