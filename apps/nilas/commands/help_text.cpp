#include "apps/nilas/commands/help_text.h"

#include <algorithm>

#include "core/output/text/console.h"

namespace nilas::commands {

namespace {

constexpr std::size_t k_name_columns = 32;

/// Name and description side by side, or one above the other where the name is long.
std::string entry(const std::string& name, const std::string& description) {
  std::string left = "  " + name;
  if (description.empty()) return left + "\n";
  if (left.size() + 2 > k_name_columns)
    left += "\n" + std::string(k_name_columns, ' ');
  else
    left.resize(k_name_columns, ' ');
  return left + output::wrapped(description, k_name_columns) + "\n";
}

}  // namespace

std::string listed_names(const CLI::Option& option) {
  if (option.get_positional()) return option.get_name(true);
  std::string names;
  for (const std::string& name : option.get_snames()) names += "-" + name + ",";
  return names + option.get_name();
}

HelpText::HelpText() { column_width(k_name_columns); }

std::string HelpText::make_option(const CLI::Option* option, bool is_positional) const {
  // a message states which flags exclude each other when both are given
  std::string values = make_option_opts(option);
  values.erase(std::min(values.size(), values.find(" Excludes:")));
  return entry(make_option_name(option, is_positional) + values, make_option_desc(option));
}

std::string HelpText::make_subcommand(const CLI::App* command) const {
  return entry(command->get_name(), command->get_description());
}

std::string HelpText::make_description(const CLI::App* app) const {
  const std::string text = output::wrapped(Formatter::make_description(app), 0);
  return text.empty() ? text : text + "\n";
}

std::string HelpText::make_footer(const CLI::App* app) const {
  const std::string text = app->get_footer();
  return text.empty() ? text : output::wrapped(text, 0) + "\n";
}

}  // namespace nilas::commands
