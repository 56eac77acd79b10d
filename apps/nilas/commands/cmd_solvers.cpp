#include <iostream>
#include <nlohmann/json.hpp>

#include "apps/nilas/commands/commands.h"
#include "contact/registry.h"
#include "core/output/text/console.h"

namespace nilas::commands {

static int list_solvers(bool json) {
  auto list = nlohmann::ordered_json::array();
  for (const auto& entry : contact::solver_registry()) {
    std::string laws;
    auto names = nlohmann::ordered_json::array();
    for (const Law law : entry.laws) {
      laws += (laws.empty() ? "" : ", ") + std::string(contact::to_string(law));
      names.push_back(contact::to_string(law));
    }
    list.push_back({{"name", entry.name}, {"laws", names}, {"summary", entry.summary}});
    constexpr std::size_t k_indent = 2;
    if (!json)
      std::cout << entry.name << "\n  " << output::wrapped("laws: " + laws, k_indent) << "\n  "
                << output::wrapped(entry.summary, k_indent) << "\n";
  }
  if (json) std::cout << list.dump(2) << "\n";
  return exit_done;
}

void add_solvers(CLI::App& app, Action& action) {
  auto* command = app.add_subcommand("solvers", "Lists the contact solvers and the laws that each can solve.");
  auto json = std::make_shared<bool>(false);
  command->add_flag("--json", *json, "Prints the list as JSON on standard output.");
  command->callback([&action, json] { action = [json] { return list_solvers(*json); }; });
}

}  // namespace nilas::commands
