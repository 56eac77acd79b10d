#pragma once
/// What is wrong with the words of a command line, with the nearest name that is right.
#include <CLI/CLI.hpp>
#include <string>
#include <vector>

namespace nilas {

/// The words with `--set A=1 B=2` written as `--set A=1 --set B=2`: words behind --set and its value belong to it as
/// long as they hold a '=', so that it swallows no scene. Words behind `--` stay as they are.
std::vector<std::string> one_set_each(const std::vector<std::string>& words);

/// A sentence where the first word names no command; else empty.
std::string unknown_command(const CLI::App& app, const std::vector<std::string>& words);

/// A sentence about the first word that the chosen command did not take, a flag before others; empty where it took
/// all. For after `app` has parsed, or thrown.
std::string unknown_word(const CLI::App& app);

}  // namespace nilas
