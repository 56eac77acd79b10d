#include "apps/nilas/commands/manual_page.h"

#include <string_view>

#include "apps/nilas/commands/help_text.h"

namespace nilas::commands {

namespace {

constexpr const char* k_manual_tail =
    ".SH EXIT STATUS\n"
    "0 done; 2 wrong input or usage; 3 the numerics failed or a check does not hold; 4 a file could not be read or\n"
    "written; 130 interrupted.\n"
    ".SH EXAMPLES\n"
    ".nf\n"
    "nilas run towing.xml \\-\\-until 10 \\-\\-out runs/first\n"
    "nilas report runs/first\n"
    "nilas view runs/first\n"
    ".fi\n"
    ".SH SEE ALSO\n"
    "The pages in /usr/share/doc/nilas.\n";

/// Text as troff reads it: no character of it is a command.
std::string as_text(const std::string& text) {
  std::string out;
  bool is_at_start = true;
  for (const char c : text) {
    if (is_at_start && (c == '.' || c == '\'')) out += "\\&";
    out += c == '\\' ? std::string("\\e") : c == '-' ? std::string("\\-") : std::string(1, c);
    is_at_start = c == '\n';
  }
  return out;
}

std::string options_of(const CLI::App& command) {
  std::string text;
  for (const CLI::Option* option : command.get_options()) {
    if (option == command.get_help_ptr() || option->get_group().empty()) continue;
    const bool takes_value = option->get_expected_max() > 0 && !option->get_positional();
    text += ".TP\n.B " + as_text(listed_names(*option)) + (takes_value ? " \\fIvalue\\fR" : "") + "\n" +
            as_text(option->get_description()) + "\n";
  }
  return text;
}

}  // namespace

std::string manual_page(const CLI::App& program, const std::string& version) {
  std::string page =
      ".TH NILAS 1 \"\" \"nilas " + version + "\" \"User commands\"\n.SH NAME\nnilas \\- vessels and " +
      "structures in broken floating sea ice\n.SH SYNOPSIS\n.B nilas\n\\fIcommand\\fR [\\fIoptions\\fR]\n" +
      ".SH DESCRIPTION\n" + as_text(program.get_description()) +
      " A scene file describes what is simulated, and a run writes its results into a folder.\n" + ".SH COMMANDS\n";
  for (const CLI::App* command : program.get_subcommands([](const CLI::App*) { return true; }))
    page += ".SS nilas " + as_text(command->get_name()) + "\n" + as_text(command->get_description()) + "\n" +
            options_of(*command);
  return page + k_manual_tail;
}

}  // namespace nilas::commands
