#include "contact/problem/reducible.h"

#include <cstddef>
#include <unordered_map>

#include "contact/problem/block_fill.h"

namespace nilas::contact {

namespace {

/// Largest number of blocks of W that are formed: 360 MB.
constexpr double k_most_blocks = 5e6;
/// Number of contacts up to which the factors of W are taken to be small enough; above it their fill is counted.
constexpr std::size_t k_small_island = 20000;
/// Blocks right of the diagonal: 1.5 GB in newton, half of it in admm and ipm.
constexpr std::size_t k_most_fill = 8000000;

/// The island's contacts by block, as places in the list of contacts.
std::unordered_map<int, std::vector<int>> contacts_by_block(const ContactProblem& problem,
                                                            const std::vector<int>& contacts) {
  std::unordered_map<int, std::vector<int>> lists;
  for (std::size_t i = 0; i < contacts.size(); ++i) {
    const auto& pair = problem.pairs[contacts[i]];
    if (pair.a >= 0) lists[pair.a].push_back(static_cast<int>(i));
    if (pair.b >= 0 && pair.b != pair.a) lists[pair.b].push_back(static_cast<int>(i));
  }
  return lists;
}

double blocks_of_w(const ContactProblem& problem, const std::vector<int>& contacts) {
  std::unordered_map<int, double> sides;  // contacts of each block
  for (const int c : contacts) {
    const auto& pair = problem.pairs[c];
    if (pair.a >= 0) sides[pair.a] += 1;
    if (pair.b >= 0 && pair.b != pair.a) sides[pair.b] += 1;
  }
  double blocks = 0;
  for (const auto& [block, count] : sides) blocks += count * count;
  return blocks;
}

}  // namespace

bool is_reducible(const ContactProblem& problem, const std::vector<int>& contacts) {
  if (blocks_of_w(problem, contacts) > k_most_blocks) return false;
  if (contacts.size() <= k_small_island) return true;
  const auto lists = contacts_by_block(problem, contacts);
  std::vector<int> row_start{0}, column;
  for (const int c : contacts) {
    const auto& pair = problem.pairs[c];
    for (const int block : {pair.a, pair.b})
      if (block >= 0) column.insert(column.end(), lists.at(block).begin(), lists.at(block).end());
    row_start.push_back(static_cast<int>(column.size()));
  }
  return fills_at_most(k_most_fill, row_start, column);
}

std::string not_reducible_message(const std::vector<int>& contacts) {
  return "an island of " + std::to_string(contacts.size()) +
         " contacts has too large a Delassus operator to be formed and factorised; nsgs, eg, apgd and pgs go without "
         "it";
}

}  // namespace nilas::contact
