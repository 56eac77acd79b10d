#pragma once
/// The page docs/reference/command-line.md: every command with its options, as the command line itself knows them.
#include <CLI/CLI.hpp>
#include <string>

namespace nilas {

/// `program` with all of its commands added.
std::string command_reference(const CLI::App& program);

}  // namespace nilas
