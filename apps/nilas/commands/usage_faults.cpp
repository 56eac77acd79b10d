#include "apps/nilas/commands/usage_faults.h"

#include <algorithm>

#include "core/base/error.h"

namespace nilas::commands {

namespace {

bool is_flag(const std::string& word) { return word.size() > 1 && word[0] == '-'; }

std::string joined(const std::vector<std::string>& names) {
  std::string text;
  for (const auto& name : names) text += (text.empty() ? "" : ", ") + name;
  return text;
}

std::vector<std::string> command_names(const CLI::App& app) {
  std::vector<std::string> names;
  for (const auto* command : app.get_subcommands([](const CLI::App*) { return true; }))
    names.push_back(command->get_name());
  return names;
}

std::string unknown_flag(const CLI::App& command, const std::string& title, const std::string& word) {
  std::vector<std::string> names;
  for (const auto* option : command.get_options())
    for (const auto& name : option->get_lnames()) names.push_back(name);
  const std::string flag = word.substr(0, word.find('='));
  const auto letters = flag.find_first_not_of('-');
  const std::string near = nearest_name(letters == std::string::npos ? "" : flag.substr(letters), names);
  return title + " has no flag " + flag + (near.empty() ? "" : "; the nearest is --" + near) + ". `" + title +
         " --help` lists all.";
}

}  // namespace

std::vector<std::string> one_set_each(const std::vector<std::string>& words) {
  std::vector<std::string> expanded;
  const auto is_value = [&](std::size_t i) {
    return i < words.size() && !is_flag(words[i]) && words[i].find('=') != std::string::npos;
  };
  for (std::size_t i = 0; i < words.size(); ++i) {
    if (words[i] == "--") {
      expanded.insert(expanded.end(), words.begin() + static_cast<std::ptrdiff_t>(i), words.end());
      break;
    }
    expanded.push_back(words[i]);
    const bool with_value = words[i].rfind("--set=", 0) == 0;
    if (words[i] != "--set" && !with_value) continue;
    if (!with_value && i + 1 < words.size()) expanded.push_back(words[++i]);
    while (is_value(i + 1)) {
      expanded.emplace_back("--set");
      expanded.push_back(words[++i]);
    }
  }
  return expanded;
}

std::string unknown_command(const CLI::App& app, const std::vector<std::string>& words) {
  if (words.empty() || is_flag(words.front())) return "";
  const auto names = command_names(app);
  if (std::count(names.begin(), names.end(), words.front()) > 0) return "";
  const std::string near = nearest_name(words.front(), names);
  return "'" + words.front() + "' is no command of nilas; " +
         (near.empty() ? "allowed: " + joined(names) + "." : "the nearest is " + near + ". `nilas --help` lists all.");
}

std::string bad_number(const CLI::App& app) {
  const CLI::App* command = &app;
  for (auto chosen = app.get_subcommands(); !chosen.empty(); chosen = command->get_subcommands())
    command = chosen.front();
  for (const auto* option : command->get_options()) {
    const std::string type = option->get_type_name();
    const bool is_whole = type.rfind("INT", 0) == 0 || type.rfind("UINT", 0) == 0;
    if (!is_whole && type.rfind("FLOAT", 0) != 0) continue;
    for (const std::string& word : option->results()) {
      long whole = 0;
      double number = 0;
      if (is_whole ? CLI::detail::lexical_cast(word, whole) : CLI::detail::lexical_cast(word, number)) continue;
      return option->get_name() + ": found '" + word + "'; allowed: a " + (is_whole ? "whole number" : "number");
    }
  }
  return "";
}

std::string unknown_word(const CLI::App& app) {
  const CLI::App* command = &app;
  std::string title = app.get_name();
  std::vector<std::string> left = app.remaining();
  if (const auto chosen = app.get_subcommands(); left.empty() && !chosen.empty()) {
    command = chosen.front();
    title += " " + command->get_name();
    left = command->remaining();
  }
  if (left.empty()) return "";
  const auto flag = std::find_if(left.begin(), left.end(), is_flag);
  if (flag != left.end()) return unknown_flag(*command, title, *flag);
  return title + " does not expect '" + left.front() + "' here. `" + title + " --help` says what it takes.";
}

}  // namespace nilas::commands
