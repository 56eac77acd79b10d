#include "core/scene/read/override_path.h"

#include "core/base/error.h"
#include "core/scene/read/read_scene.h"
#include "core/scene/spec/values.h"

namespace nilas::scene {

/// Splits at slashes, except for slashes inside quotes.
static std::vector<std::string> split_path(const std::string& text) {
  std::vector<std::string> parts{""};
  char quote = 0;
  for (const char c : text) {
    if (quote != 0)
      quote = c == quote ? char{0} : quote;
    else if (c == '\'' || c == '"')
      quote = c;
    if (c == '/' && quote == 0)
      parts.emplace_back();
    else
      parts.back() += c;
  }
  return parts;
}

/// Parses the inside of [...]: a number, @key='value' in single or double quotes, or +.
static bool parse_predicate(const std::string& inside, PathStep& step) {
  step.added = inside == "+";
  if (step.added) return true;
  if (const auto number = parse_integer(inside)) {
    constexpr std::int64_t k_max_number = 1'000'000'000;
    if (*number < 1 || *number > k_max_number) return false;
    step.number = static_cast<int>(*number);
    return true;
  }
  const auto equals = inside.find('=');
  if (inside.empty() || inside[0] != '@' || equals == std::string::npos) return false;
  const std::string quoted = inside.substr(equals + 1);
  if (quoted.size() < 2 || (quoted[0] != '\'' && quoted[0] != '"') || quoted.back() != quoted[0]) return false;
  step.key = inside.substr(1, equals - 1);
  step.value = quoted.substr(1, quoted.size() - 2);
  return !step.key.empty();
}

static std::optional<PathStep> parse_step(const std::string& part) {
  PathStep step;
  step.text = part;
  const auto open = part.find('[');
  step.element = part.substr(0, open);
  if (step.element.empty()) return std::nullopt;
  if (open == std::string::npos) return step;
  if (part.back() != ']' || !parse_predicate(part.substr(open + 1, part.size() - open - 2), step)) return std::nullopt;
  return step;
}

std::optional<OverridePath> parse_override_path(const std::string& text) {
  std::vector<std::string> parts = split_path(text);
  if (parts.front().empty()) parts.erase(parts.begin());
  if (!parts.empty() && parts.front() == "scene") parts.erase(parts.begin());
  if (parts.empty() || parts.back().size() < 2 || parts.back()[0] != '@') return std::nullopt;
  OverridePath path;
  path.attribute = parts.back().substr(1);
  parts.pop_back();
  for (const auto& part : parts) {
    const auto step = parse_step(part);
    if (!step) return std::nullopt;
    path.steps.push_back(*step);
  }
  return path;
}

std::pair<std::string, std::string> split_override(const std::string& text) {
  char quote = 0;
  for (std::size_t i = 0, depth = 0; i < text.size(); ++i) {
    const char c = text[i];
    if (quote != 0)
      quote = c == quote ? char{0} : quote;
    else if (c == '=' && depth == 0)
      return {text.substr(0, i), text.substr(i + 1)};
    else if (c == '\'' || c == '"')
      quote = c;
    else if (c == '[')
      ++depth;
    else if (c == ']' && depth > 0)
      --depth;
  }
  throw InputError("--set " + text + ": found no '='; allowed: PATH=VALUE, as in contact/@tolerance=1e-8");
}

}  // namespace nilas::scene
