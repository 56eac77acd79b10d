#include "core/base/error.h"

#include <algorithm>
#include <cstddef>

namespace nilas {

/// A text without its middle where it repeats a value that is too long to be read.
static std::string shortened(const std::string& text) {
  constexpr std::size_t k_begin = 600, k_end = 1400;  // the end tells what is allowed
  if (text.size() <= k_begin + k_end) return text;
  return text.substr(0, k_begin) + " ... " + text.substr(text.size() - k_end);
}

std::string Fault::text() const {
  std::string s = file;
  if (line > 0) s += ":" + std::to_string(line);
  if (line > 0 && column > 0) s += ":" + std::to_string(column);
  if (!s.empty()) s += ": ";
  if (!where.empty()) s += shortened(where) + ": ";
  return s + shortened(message);
}

static std::string join(const std::vector<Fault>& faults) {
  constexpr std::size_t k_most = 200;  // nobody reads more of them at once
  std::string s;
  for (std::size_t k = 0; k < std::min(faults.size(), k_most); ++k) s += (s.empty() ? "" : "\n") + faults[k].text();
  if (faults.size() > k_most) s += "\nThere are " + std::to_string(faults.size() - k_most) + " further faults.";
  return s;
}

SceneError::SceneError(std::vector<Fault> faults) : std::runtime_error(join(faults)), faults_(std::move(faults)) {}

bool SceneError::only_unreadable_files() const {
  return !faults_.empty() && std::all_of(faults_.begin(), faults_.end(), [](const Fault& f) { return f.unreadable; });
}

void contract_failed(const char* expression, const char* file, int line) {
  throw ContractError(std::string(file) + ":" + std::to_string(line) + ": broken contract: " + expression);
}

/// Edits that change `a` into `b`: a letter more, less or other, or two neighbours that change places.
static std::size_t edit_distance(const std::string& a, const std::string& b) {
  std::vector<std::size_t> before, last(b.size() + 1), row(b.size() + 1);
  for (std::size_t j = 0; j <= b.size(); ++j) last[j] = j;
  for (std::size_t i = 1; i <= a.size(); ++i) {
    row[0] = i;
    for (std::size_t j = 1; j <= b.size(); ++j) {
      row[j] = std::min({last[j] + 1, row[j - 1] + 1, last[j - 1] + (a[i - 1] == b[j - 1] ? 0 : 1)});
      if (i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1]) row[j] = std::min(row[j], before[j - 2] + 1);
    }
    before = last;
    last = row;
  }
  return last[b.size()];
}

/// American words that are further from the English ones than a slip of the keys.
static std::string in_english(const std::string& word) { return word == "draft" ? "draught" : word; }

std::string nearest_name(const std::string& written, const std::vector<std::string>& candidates) {
  const std::string word = in_english(written);
  std::string best;
  // about one edit in each three letters; of a word of two letters, more would leave nothing
  std::size_t best_distance = (word.size() + 1) / 3 + 1;
  for (const auto& c : candidates) {
    // Each edit changes the length by one at most.
    const std::size_t longer = std::max(word.size(), c.size()) - std::min(word.size(), c.size());
    if (longer >= best_distance && !c.starts_with(word + "_")) continue;
    const std::size_t d = c.starts_with(word + "_") ? 1 : edit_distance(word, c);  // only its unit is missing
    if (d < best_distance) {
      best_distance = d;
      best = c;
    }
  }
  return best;
}

}  // namespace nilas
