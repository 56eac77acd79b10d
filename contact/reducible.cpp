#include "contact/reducible.h"

#include <unordered_map>

namespace nilas {

constexpr std::size_t k_most_contacts = 20000;
constexpr double k_most_blocks = 5e6;

bool is_reducible(const ContactProblem& problem, const std::vector<int>& contacts) {
  if (contacts.size() > k_most_contacts) return false;
  std::unordered_map<int, double> sides;  // contacts of each block
  for (const int c : contacts) {
    const auto& pair = problem.pairs[static_cast<std::size_t>(c)];
    if (pair.a >= 0) sides[pair.a] += 1;
    if (pair.b >= 0 && pair.b != pair.a) sides[pair.b] += 1;
  }
  double blocks = 0;
  for (const auto& [block, count] : sides) blocks += count * count;
  return blocks <= k_most_blocks;
}

std::string not_reducible_message(const std::vector<int>& contacts) {
  return "an island of " + std::to_string(contacts.size()) +
         " contacts has too large a Delassus operator to be formed; nsgs, eg, apgd and pgs go without it";
}

}  // namespace nilas
