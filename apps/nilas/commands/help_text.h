#pragma once
/// Help that fits a terminal of 80 columns.
#include <CLI/CLI.hpp>
#include <string>

namespace nilas::commands {

/// The names by which pages list an option, as "-j,--jobs" or "scene"; a further long name is left to --help.
std::string listed_names(const CLI::Option& option);

/// CLI11's help with descriptions wrapped at the right edge.
class HelpText : public CLI::Formatter {
 public:
  HelpText();
  std::string make_option(const CLI::Option* option, bool is_positional) const override;
  std::string make_subcommand(const CLI::App* command) const override;
  std::string make_description(const CLI::App* app) const override;
  std::string make_footer(const CLI::App* app) const override;
};

}  // namespace nilas::commands
