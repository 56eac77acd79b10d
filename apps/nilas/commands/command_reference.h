#pragma once
/// The page docs/reference/command-line.md: every command with its options, read from the parser of the command line.
#include <CLI/CLI.hpp>
#include <string>

namespace nilas::commands {

/// The page as Markdown. `program` has all of its commands added.
std::string command_reference(const CLI::App& program);

}  // namespace nilas::commands
