#include "apps/nilas/study/study_options.h"

#include <nlohmann/json.hpp>

namespace nilas::commands {

namespace {

/// Adds one option: without a value it is a switch, and with bounds a whole number.
void add_study_option(CLI::App& command, const nlohmann::json& entry) {
  const std::string name = entry.at("name"), help = entry.at("help");
  CLI::Option* option = nullptr;
  if (!entry.contains("value")) {
    option = command.add_flag(name, help);
  } else {
    option = command.add_option(name, help);
    option->type_name(entry.contains("most") ? std::string("INT") : entry.at("value").get<std::string>());
  }
  if (entry.contains("most")) option->check(CLI::Range(entry.at("least").get<int>(), entry.at("most").get<int>()));
  if (entry.contains("default")) option->default_str(entry.at("default").dump());
  if (option->get_positional()) option->required();
  if (entry.value("hidden", false)) option->group("");
}

}  // namespace

CLI::App& add_study_command(CLI::App& program) {
  const nlohmann::json known = nlohmann::json::parse(study_text("options.json"));
  CLI::App& command = *program.add_subcommand("study", known.at("description").get<std::string>());
  command.footer(known.at("more").get<std::string>());
  for (const nlohmann::json& entry : known.at("options")) add_study_option(command, entry);
  return command;
}

std::vector<std::string> study_words(const CLI::App& command) {
  std::vector<std::string> words, places;
  for (const CLI::Option* option : command.get_options()) {
    if (option->count() == 0) continue;
    if (option->get_positional()) {
      places.push_back(option->results().front());
    } else if (const std::string name = "--" + option->get_lnames().front(); option->get_expected_max() > 0) {
      words.push_back(name + "=" + option->results().back());
    } else if (option->as<bool>()) {
      words.push_back(name);
    }
  }
  // A file may have a name that starts with a hyphen.
  words.emplace_back("--");
  words.insert(words.end(), places.begin(), places.end());
  return words;
}

}  // namespace nilas::commands
