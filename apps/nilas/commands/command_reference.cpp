#include "apps/nilas/commands/command_reference.h"

#include <cctype>
#include <string_view>

#include "apps/nilas/commands/help_text.h"

namespace nilas::commands {

namespace {

constexpr const char* k_head =
    "# Command line\n"
    "\n"
    "This page lists the commands of `nilas` with all of their options. It is printed by\n"
    "`nilas schema --commands`. `nilas COMMAND --help` shows the same in the terminal.\n"
    "\n"
    "- Every command also takes `-h` and `--help`, and `nilas --version` prints the version,\n"
    "  the build and the versions of the libraries that it was built with.\n"
    "- Exit codes are in [conventions](conventions.md#exit-codes), and the files that a command writes\n"
    "  are in [outputs](outputs.md).\n"
    "- An option with `...` takes one value or several. One without a value is a switch.\n";

/// The option whose default is not printed, because some commands take the number of cores of the machine.
constexpr std::string_view k_of_the_machine = "--threads";

std::string escaped(const std::string& text) {
  std::string out;
  for (const char c : text)
    out += c == '|' ? std::string("\\|") : c == '<' ? "&lt;" : c == '>' ? "&gt;" : std::string(1, c);
  return out;
}

/// The text with a capital at its start and a full stop at its end, escaped for a table.
std::string sentence(std::string text) {
  if (text.empty()) return text;
  text.front() = static_cast<char>(std::toupper(static_cast<unsigned char>(text.front())));
  if (text.back() != '.') text += '.';
  return escaped(text);
}

std::string code(const std::string& text) { return text.empty() ? "" : "`" + text + "`"; }

/// The list "a,b" as "a, b", which may wrap.
std::string choices(const std::string& list) {
  std::string text;
  for (const char c : list) text += c == ',' ? std::string(", ") : std::string(1, c);
  return text;
}

/// The value that an option takes: "number", "whole number" or "text", with its bounds or choices; empty for a switch.
std::string value_of(const CLI::Option& option) {
  if (option.get_expected_max() == 0) return "";
  const std::string type = option.get_type_name();
  const auto colon = type.find(':');
  const std::string kind = type.substr(0, colon);
  std::string text = kind == "INT" || kind == "UINT" ? "whole number" : kind == "FLOAT" ? "number" : "text";
  if (colon != std::string::npos && type.substr(colon + 1, 1) == "{")
    text = choices(type.substr(colon + 2, type.size() - colon - 3));
  else if (const auto bounds = type.find('['); bounds != std::string::npos)
    text += " in " + type.substr(bounds);
  if (option.get_expected_max() > 1) text += " ...";
  return escaped(text);
}

std::string row_of(const CLI::Option& option) {
  const bool machine = option.check_lname(std::string(k_of_the_machine.substr(2)));
  const std::string fallback = machine ? "" : option.get_default_str();
  return "| " + code(listed_names(option)) + " | " + value_of(option) + " | " + code(fallback) + " | " +
         escaped(option.get_description()) + " |\n";
}

std::string section_of(const CLI::App& command) {
  std::string rows;
  for (const CLI::Option* option : command.get_options())
    if (option != command.get_help_ptr() && !option->get_group().empty()) rows += row_of(*option);
  std::string text = "\n## nilas " + command.get_name() + "\n" + sentence(command.get_description()) + "\n";
  if (rows.empty()) return text;
  return text + "\n| option | value | default | meaning |\n|---|---|---|---|\n" + rows;
}

}  // namespace

std::string command_reference(const CLI::App& program) {
  std::string page = k_head;
  for (const CLI::App* command : program.get_subcommands([](const CLI::App*) { return true; }))
    page += section_of(*command);
  return page;
}

}  // namespace nilas::commands
