/// The command-line program: it picks the subcommand and maps errors to exit codes.
#include <malloc.h>
#include <unistd.h>

#include <csignal>
#include <filesystem>
#include <iostream>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "apps/nilas/commands/commands.h"
#include "apps/nilas/commands/help_text.h"
#include "apps/nilas/commands/program_identity.h"
#include "apps/nilas/commands/usage_faults.h"
#include "core/base/error.h"
#include "core/output/text/console.h"

namespace {

int run_action(const nilas::commands::Action& action) {
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
  } catch (const nilas::Interruption& e) {
    std::cerr << e.what() << "\n";
    return nilas::exit_interrupted;
  } catch (const nilas::SimulationError& e) {
    std::cerr << "error: " << e.what() << "\n";
    return nilas::exit_numerics;
  } catch (const std::exception& e) {
    std::cerr << "internal error, please report it: " << e.what() << "\n";
    return nilas::exit_numerics;
  }
}

/// The signal handler that ends the program at once. `run` and `compare` replace it when they have outputs to finish.
void leave(int) {
  constexpr char text[] = "The program was interrupted before it had finished.\n";
  [[maybe_unused]] const auto written = ::write(STDERR_FILENO, text, sizeof text - 1);
  ::_exit(nilas::exit_interrupted);
}

/// Reads the words of the command line. Returns an exit code if there is no action to run: after a fault, which is
/// printed, or after --help and --version.
std::optional<int> read_words(CLI::App& app, const std::vector<std::string>& words) {
  const auto refuse = [](const std::string& fault) {
    std::cerr << nilas::output::wrapped("error: " + fault, 0) << "\n";
    return nilas::exit_bad_input;
  };
  if (words.empty()) {
    std::cerr << app.help();
    return nilas::exit_bad_input;
  }
  if (const std::string fault = nilas::commands::unknown_command(app, words); !fault.empty()) return refuse(fault);
  try {
    app.parse(std::vector<std::string>(words.rbegin(), words.rend()));  // CLI11 takes the last word first
  } catch (const CLI::Success& e) {
    return app.exit(e);
  } catch (const CLI::ParseError& e) {
    // an option that is missing is often one that was misspelt
    if (const std::string fault = nilas::commands::unknown_word(app); !fault.empty()) return refuse(fault);
    if (const std::string fault = nilas::commands::bad_number(app); !fault.empty()) return refuse(fault);
    app.exit(e);
    return nilas::exit_bad_input;
  }
  return std::nullopt;
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
  std::signal(SIGXFSZ, SIG_IGN);  // a file size limit is then an error of the write, with a message
  CLI::App app{"Nilas simulates vessels and fixed structures in broken floating sea ice.", "nilas"};
  app.set_version_flag("--version", nilas::commands::version_text());
  app.require_subcommand(1);
  app.formatter(std::make_shared<nilas::commands::HelpText>());
  nilas::commands::Action action;
  nilas::commands::add_run(app, action);
  nilas::commands::add_check(app, action);
  nilas::commands::add_hull(app, action);
  nilas::commands::add_field(app, action);
  nilas::commands::add_hydro(app, action);
  nilas::commands::add_solve(app, action);
  nilas::commands::add_solvers(app, action);
  nilas::commands::add_verify(app, action);
  nilas::commands::add_compare(app, action);
  nilas::commands::add_report(app, action);
  nilas::commands::add_view(app, action);
  nilas::commands::add_problems(app, action);
  nilas::commands::add_study(app, action);
  nilas::commands::add_validate(app, action);
  nilas::commands::add_statistics(app, action);
  nilas::commands::add_schema(app, action);
  if (const auto code = read_words(app, nilas::commands::one_set_each({argv + 1, argv + argc}))) return *code;
  return run_action(action);
}
