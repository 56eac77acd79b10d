#pragma once
/// The options of `nilas study`. They stand in python/nilas/study/options.json alone, which the build puts into the
/// program and the Python package reads: help, manual page and completion need no Python.
#include <CLI/CLI.hpp>
#include <string>
#include <string_view>
#include <vector>

namespace nilas::commands {

/// The text of options.json. Throws ContractError for any other name.
std::string_view study_text(std::string_view name);

/// Adds the command with its options. Those that are jobs of Snakemake stay out of help, manual page and completion.
CLI::App& add_study_command(CLI::App& program);

/// The options that were given, as words for `python3 -m nilas.study`. Call it after the command line was parsed.
std::vector<std::string> study_words(const CLI::App& command);

}  // namespace nilas::commands
