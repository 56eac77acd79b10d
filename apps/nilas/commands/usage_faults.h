#pragma once
/// Faults in the words of a command line, with the nearest name that is right.
#include <CLI/CLI.hpp>
#include <string>
#include <vector>

namespace nilas::commands {

/// The words with `--set A=1 B=2` written as `--set A=1 --set B=2`. Words after --set and its value belong to it as
/// long as they contain a '=', so that it does not take the scene. Words after `--` stay as they are.
std::vector<std::string> one_set_each(const std::vector<std::string>& words);

/// A sentence if the first word names no command; else empty.
std::string unknown_command(const CLI::App& app, const std::vector<std::string>& words);

/// A sentence about the first value of the chosen command's options that should be a number and is none; else empty.
/// Call it after `app` has parsed or thrown.
std::string bad_number(const CLI::App& app);

/// A sentence about the first word that the chosen command did not take, or about the first such flag; empty if it took
/// all. Call it after `app` has parsed or thrown.
std::string unknown_word(const CLI::App& app);

}  // namespace nilas::commands
