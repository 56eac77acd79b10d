#include <unistd.h>

#include <cstdlib>
#include <filesystem>
#include <string>
#include <vector>

#include "apps/nilas/commands/commands.h"
#include "apps/nilas/study/study_options.h"
#include "core/base/error.h"

namespace nilas::commands {

namespace {

namespace fs = std::filesystem;

/// The file of this program.
fs::path own_file() {
  std::error_code failed;
  const fs::path file = fs::read_symlink("/proc/self/exe", failed);
  if (failed) throw FileError("the program's own file cannot be found: " + failed.message());
  return file;
}

/// The folder that holds the package for Python: in a build beside the program, in a wheel around it, in an
/// installation below its prefix; else empty.
fs::path package_folder(const fs::path& program) {
  const fs::path beside = program.parent_path() / "python", prefix = program.parent_path().parent_path();
  for (const fs::path& folder : {beside, prefix.parent_path(), prefix / "lib/python3/dist-packages"})
    if (fs::exists(folder / "nilas" / "study" / "__main__.py")) return folder;
  return {};
}

void set(const char* name, const std::string& value) {
  if (::setenv(name, value.c_str(), 1) != 0) throw FileError(std::string("cannot set the variable ") + name);
}

/// The interpreter: what NILAS_PYTHON names, else that of the system, whose packages a Debian package brings.
std::string interpreter() {
  if (const char* named = std::getenv("NILAS_PYTHON"); named && *named) return named;
  return fs::exists("/usr/bin/python3") ? "/usr/bin/python3" : "python3";
}

/// Becomes a module of the Python package.
[[noreturn]] void become_module(const std::string& module, const std::vector<std::string>& words) {
  const fs::path program = own_file();
  if (const fs::path folder = package_folder(program); !folder.empty()) {
    const char* known = std::getenv("PYTHONPATH");
    set("PYTHONPATH", folder.string() + (known ? ":" + std::string(known) : std::string()));
  }
  set("NILAS_PROGRAM", program.string());
  std::vector<std::string> all{interpreter(), "-m", module};
  all.insert(all.end(), words.begin(), words.end());
  std::vector<char*> arguments;
  arguments.reserve(all.size() + 1);
  for (std::string& word : all) arguments.push_back(word.data());
  arguments.push_back(nullptr);
  ::execvp(arguments[0], arguments.data());
  throw FileError(module + " needs Python 3.11 with the package nilas, and " + all[0] +
                  " cannot be started; NILAS_PYTHON may name another interpreter");
}

/// Adds a command that a module of the package carries out, with options of its own.
void add_module(CLI::App& app, Action& action, const char* name, const std::string& module, const char* what) {
  auto* command = app.add_subcommand(name, what);
  command->prefix_command();
  command->set_help_flag();
  command->callback([&action, command, module] {
    const std::vector<std::string> words = command->remaining();
    action = [module, words]() -> int { become_module(module, words); };
  });
}

}  // namespace

void add_study(CLI::App& app, Action& action) {
  CLI::App& command = add_study_command(app);
  command.callback([&action, &command] {
    const std::vector<std::string> words = study_words(command);
    action = [words]() -> int { become_module("nilas.study", words); };
  });
}

void add_validate(CLI::App& app, Action& action) {
  add_module(app, action, "validate", "nilas.validate",
             "Judges loads by published formulas, measured runs and scale laws. "
             "`nilas validate --help` lists its options.");
}

void add_statistics(CLI::App& app, Action& action) {
  add_module(app, action, "statistics", "nilas.loads",
             "States return levels of load peaks, spectra, and how the load follows the ice ahead, of one run or of "
             "several. `nilas statistics --help` lists its options.");
}

}  // namespace nilas::commands
