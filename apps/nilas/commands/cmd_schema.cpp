#include <iostream>

#include "apps/nilas/commands/command_reference.h"
#include "apps/nilas/commands/commands.h"
#include "apps/nilas/commands/manual_page.h"
#include "apps/nilas/commands/shell_completion.h"
#include "core/output/run/program_versions.h"
#include "core/scene/schema/schema.h"

namespace nilas::commands {

void add_schema(CLI::App& app, Action& action) {
  auto* command = app.add_subcommand("schema", "Prints the schema of scene files.");
  auto markdown = std::make_shared<bool>(false);
  auto xsd = std::make_shared<bool>(true);
  command->add_flag("--xsd", *xsd, "Prints it as an XML Schema, which is the default.");
  command->add_flag("--markdown", *markdown, "Prints it as the scene reference page of the documentation.");
  auto commands = std::make_shared<bool>(false);
  command->add_flag("--commands", *commands, "Prints the page of the documentation that lists all commands instead.");
  auto manual = std::make_shared<bool>(false);
  command->add_flag("--man", *manual, "Prints the manual page nilas(1) instead.");
  auto completion = std::make_shared<bool>(false);
  command->add_flag("--completion", *completion,
                    "Prints a script that completes commands and options in bash instead.");
  command->callback([&action, &app, markdown, commands, manual, completion] {
    action = [&app, markdown, commands, manual, completion] {
      std::cout << (*commands     ? command_reference(app)
                    : *manual     ? manual_page(app, output::program_versions().at("nilas"))
                    : *completion ? shell_completion(app)
                    : *markdown   ? scene::schema_markdown()
                                  : scene::schema_xsd());
      return exit_done;
    };
  });
}

}  // namespace nilas::commands
