#include <iostream>

#include "apps/nilas/commands/command_reference.h"
#include "apps/nilas/commands/commands.h"
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
  command->callback([&action, &app, markdown, commands] {
    action = [&app, markdown, commands] {
      std::cout << (*commands ? command_reference(app) : *markdown ? scene::schema_markdown() : scene::schema_xsd());
      return exit_done;
    };
  });
}

}  // namespace nilas::commands
