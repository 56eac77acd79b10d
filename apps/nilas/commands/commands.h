#pragma once
/// The subcommands. Each adds its flags to the program and, if it is chosen, sets the action to run.
#include <CLI/CLI.hpp>
#include <functional>
#include <string>

#include "core/base/error.h"

namespace nilas::commands {

/// The work of the chosen subcommand; returns the exit code.
using Action = std::function<int()>;

void add_run(CLI::App& app, Action& action);
void add_check(CLI::App& app, Action& action);
void add_hull(CLI::App& app, Action& action);
void add_field(CLI::App& app, Action& action);
void add_hydro(CLI::App& app, Action& action);
void add_solve(CLI::App& app, Action& action);
void add_solvers(CLI::App& app, Action& action);
void add_verify(CLI::App& app, Action& action);
void add_compare(CLI::App& app, Action& action);
void add_report(CLI::App& app, Action& action);
void add_view(CLI::App& app, Action& action);
void add_problems(CLI::App& app, Action& action);
void add_study(CLI::App& app, Action& action);
void add_validate(CLI::App& app, Action& action);
void add_statistics(CLI::App& app, Action& action);
void add_schema(CLI::App& app, Action& action);

/// Checks with messages of our own, because those of CLI11 are hard to read.
inline CLI::Validator at_least(double least) {
  return {[least](const std::string& text) -> std::string {
            double value = 0;
            if (CLI::detail::lexical_cast(text, value) && value >= least) return "";
            return "found " + text + "; allowed: a number of at least " + CLI::detail::to_string(least);
          },
          ""};
}

inline CLI::Validator above(double bound) {
  return {[bound](const std::string& text) -> std::string {
            double value = 0;
            if (CLI::detail::lexical_cast(text, value) && value > bound) return "";
            return "found " + text + "; allowed: a number above " + CLI::detail::to_string(bound);
          },
          ""};
}

}  // namespace nilas::commands
