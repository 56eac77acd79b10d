#pragma once
/// Completion of commands and options in bash, read from the parser of the command line.
#include <CLI/CLI.hpp>
#include <string>

namespace nilas::commands {

/// A script for bash-completion. `program` has all of its commands added.
std::string shell_completion(const CLI::App& program);

}  // namespace nilas::commands
