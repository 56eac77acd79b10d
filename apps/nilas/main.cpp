/// The command-line program: it picks the subcommand and maps errors to exit codes.
#include <malloc.h>
#include <unistd.h>

#include <csignal>
#include <cstdlib>
#include <exception>
#include <filesystem>
#include <iostream>
#include <memory>
#include <new>
#include <optional>
#include <string>
#include <string_view>
#include <system_error>
#include <vector>

#include "apps/nilas/commands/commands.h"
#include "apps/nilas/commands/help_text.h"
#include "apps/nilas/commands/program_identity.h"
#include "apps/nilas/commands/usage_faults.h"
#include "core/base/error.h"
#include "core/output/text/console.h"

namespace {

constexpr std::string_view k_no_memory = "error: there is too little memory for this command\n";

/// Writes a text on standard error without asking for memory.
void say(std::string_view text) {
  [[maybe_unused]] const auto written = ::write(STDERR_FILENO, text.data(), text.size());
}

/// A message that changes nothing at the terminal: names of files and values may hold control characters.
std::string shown(std::string message) {
  for (char& c : message)
    if ((static_cast<unsigned char>(c) < ' ' && c != '\n' && c != '\t') || c == '\x7f') c = '?';
  return message;
}

/// Runs a body and maps its exceptions to exit codes.
template <class Body>
int guarded(const Body& body) {
  try {
    return body();
  } catch (const nilas::SceneError& e) {
    std::cerr << shown(e.what()) << "\n" << e.faults().size() << (e.faults().size() == 1 ? " fault\n" : " faults\n");
    return e.only_unreadable_files() ? nilas::exit_file : nilas::exit_bad_input;
  } catch (const nilas::InputError& e) {
    std::cerr << "error: " << shown(e.what()) << "\n";
    return nilas::exit_bad_input;
  } catch (const nilas::FileError& e) {
    std::cerr << "error: " << shown(e.what()) << "\n";
    return nilas::exit_file;
  } catch (const std::bad_alloc&) {
    say(k_no_memory);
    return nilas::exit_file;
  } catch (const std::system_error& e) {  // of files, and of threads that the system refuses
    std::cerr << "error: " << shown(e.what()) << "\n";
    return nilas::exit_file;
  } catch (const nilas::Interruption& e) {
    std::cerr << shown(e.what()) << "\n";
    return nilas::exit_interrupted;
  } catch (const nilas::SimulationError& e) {
    std::cerr << "error: " << shown(e.what()) << "\n";
    return nilas::exit_numerics;
  } catch (const std::exception& e) {
    std::cerr << "internal error, please report it: " << shown(e.what()) << "\n";
    return nilas::exit_numerics;
  }
}

/// The signal handler that ends the program at once. `run` and `compare` replace it when they have outputs to finish.
void leave(int) {
  say("The program was interrupted before it had finished.\n");
  ::_exit(nilas::exit_interrupted);
}

/// Ends the program where an exception cannot be handled, as one that a destructor lets out. Libraries free memory by
/// asking for some, so without memory this is how the program ends.
[[noreturn]] void give_up() {
  try {
    if (const auto thrown = std::current_exception()) std::rethrow_exception(thrown);
  } catch (const std::bad_alloc&) {
    say(k_no_memory);
    ::_exit(nilas::exit_file);
  } catch (const std::system_error& e) {
    say("error: ");
    say(e.what());
    say("\n");
    ::_exit(nilas::exit_file);
  } catch (const std::exception& e) {
    say("internal error, please report it: ");
    say(e.what());
    say("\n");
    ::_exit(nilas::exit_numerics);
  } catch (...) {
  }
  say("internal error, please report it: an exception without a name\n");
  ::_exit(nilas::exit_numerics);
}

/// Reads the words of the command line. Returns an exit code if there is no action to run: after a fault, which is
/// printed, or after --help and --version.
std::optional<int> read_words(CLI::App& app, const std::vector<std::string>& words) {
  const auto refuse = [](const std::string& fault) {
    std::cerr << nilas::output::wrapped("error: " + shown(fault), 0) << "\n";
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

bool ends_by_itself = false;  // what the handlers of exit() see, which take no arguments

/// Ends the program where a library called exit(), as some do where they get no memory.
void tell_of_library() {
  if (ends_by_itself) return;
  say("error: a library ended the program; there may be too little memory for this command\n");
  ::_exit(nilas::exit_file);
}

/// Reads the words after the program's name and runs the command that they ask for. Returns the exit code.
int run_words(const std::vector<std::string>& words) {
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
  if (const auto code = read_words(app, nilas::commands::one_set_each(words))) return *code;
  return action();
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
  std::set_terminate(give_up);
  std::atexit(tell_of_library);
  const int code = guarded([&] { return run_words({argv + 1, argv + argc}); });
  ends_by_itself = true;
  return code;
}
