#include "apps/nilas/commands/shell_completion.h"

namespace nilas::commands {

namespace {

constexpr const char* k_completion_head =
    "# Completion of nilas in bash: commands, then their options, then files.\n"
    "_nilas() {\n"
    "  local word=${COMP_WORDS[COMP_CWORD]} command=${COMP_WORDS[1]:-} words=\n"
    "  COMPREPLY=()\n";

constexpr const char* k_completion_tail =
    "  esac\n"
    "  case $word in\n"
    "    -*) mapfile -t COMPREPLY < <(compgen -W \"$words\" -- \"$word\") ;;\n"
    "    *) compopt -o default ;;\n"
    "  esac\n"
    "}\n"
    "complete -F _nilas nilas\n";

std::string long_names(const CLI::App& command) {
  std::string names;
  for (const CLI::Option* option : command.get_options()) {
    if (option->get_group().empty()) continue;
    for (const std::string& name : option->get_lnames()) names += (names.empty() ? "--" : " --") + name;
  }
  return names;
}

}  // namespace

std::string shell_completion(const CLI::App& program) {
  std::string commands, cases;
  for (const CLI::App* command : program.get_subcommands([](const CLI::App*) { return true; })) {
    commands += (commands.empty() ? "" : " ") + command->get_name();
    cases += "    " + command->get_name() + ") words='" + long_names(*command) + "' ;;\n";
  }
  return k_completion_head +
         ("  if [ \"$COMP_CWORD\" -eq 1 ]; then\n    mapfile -t COMPREPLY < <(compgen -W '" + commands +
          " --help --version' -- \"$word\")\n    return\n  fi\n  case $command in\n") +
         cases + k_completion_tail;
}

}  // namespace nilas::commands
