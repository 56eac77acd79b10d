#include "apps/compare/scenes/report/run_command.h"

#include <algorithm>

namespace nilas::compare {

namespace {

/// The word as a shell reads it.
std::string shell_word(const std::string& word) {
  constexpr const char* k_harmless = "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789@%_+=:,./-";
  if (!word.empty() && word.find_first_not_of(k_harmless) == std::string::npos) return word;
  std::string quoted = "'";
  for (const char c : word) quoted += c == '\'' ? std::string("'\\''") : std::string(1, c);
  return quoted + "'";
}

}  // namespace

std::string run_command(const SceneReport& report) {
  const SceneStudy& study = report.study;
  if (study.ablation || !report.found.choice.chosen) return "";
  const scene::Overrides own = study.plan.settings.front().overrides(),
                         chosen = study.plan.settings[*report.found.choice.chosen].overrides();
  std::string command = "nilas run " + shell_word(study.scene.string());
  const auto set = [&](const std::pair<std::string, std::string>& change) {
    command += " --set " + shell_word(change.first + "=" + change.second);
  };
  for (const auto& change : study.overrides)
    if (change.first != "time/@end") set(change);
  for (const auto& change : chosen)
    if (std::find(own.begin(), own.end(), change) == own.end()) set(change);
  return command;
}

}  // namespace nilas::compare
