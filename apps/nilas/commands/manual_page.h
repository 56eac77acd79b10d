#pragma once
/// The manual page nilas(1), read from the parser of the command line.
#include <CLI/CLI.hpp>
#include <string>

namespace nilas::commands {

/// The page in the macros of man(7). `program` has all of its commands added.
std::string manual_page(const CLI::App& program, const std::string& version);

}  // namespace nilas::commands
