#include "core/base/error.h"

#include <algorithm>
#include <cstddef>

namespace nilas {

std::string Fault::text() const {
  std::string s = file;
  if (line > 0) s += ":" + std::to_string(line);
  if (line > 0 && column > 0) s += ":" + std::to_string(column);
  if (!s.empty()) s += ": ";
  if (!where.empty()) s += where + ": ";
  return s + message;
}

static std::string join(const std::vector<Fault>& faults) {
  std::string s;
  for (const auto& f : faults) s += (s.empty() ? "" : "\n") + f.text();
  return s;
}

SceneError::SceneError(std::vector<Fault> faults) : std::runtime_error(join(faults)), faults_(std::move(faults)) {}

bool SceneError::only_unreadable_files() const {
  return !faults_.empty() && std::all_of(faults_.begin(), faults_.end(), [](const Fault& f) { return f.unreadable; });
}

void contract_failed(const char* expression, const char* file, int line) {
  throw ContractError(std::string(file) + ":" + std::to_string(line) + ": broken contract: " + expression);
}

static std::size_t edit_distance(const std::string& a, const std::string& b) {
  std::vector<std::size_t> row(b.size() + 1);
  for (std::size_t j = 0; j <= b.size(); ++j) row[j] = j;
  for (std::size_t i = 1; i <= a.size(); ++i) {
    std::size_t diagonal = row[0];
    row[0] = i;
    for (std::size_t j = 1; j <= b.size(); ++j) {
      const std::size_t above = row[j];
      row[j] = std::min({row[j] + 1, row[j - 1] + 1, diagonal + (a[i - 1] == b[j - 1] ? 0 : 1)});
      diagonal = above;
    }
  }
  return row[b.size()];
}

/// American words that are further from the English ones than a slip of the keys.
static std::string in_english(const std::string& word) { return word == "draft" ? "draught" : word; }

std::string nearest_name(const std::string& written, const std::vector<std::string>& candidates) {
  const std::string word = in_english(written);
  std::string best;
  std::size_t best_distance = std::max<std::size_t>(2, word.size() / 2) + 1;
  for (const auto& c : candidates) {
    const std::size_t d = edit_distance(word, c);
    if (d < best_distance) {
      best_distance = d;
      best = c;
    }
  }
  return best;
}

}  // namespace nilas
