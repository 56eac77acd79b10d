#pragma once
/// Which of n things hang together, from pairs that do. Source: Tarjan 1975 (path halving: van Leeuwen, Weide 1977).
#include <cstddef>
#include <numeric>
#include <utility>
#include <vector>

namespace nilas {

class UnionFind {
 public:
  static constexpr std::size_t k_nothing = static_cast<std::size_t>(-1);

  /// `count` things, each alone.
  explicit UnionFind(std::size_t count) : parent_(count) { std::iota(parent_.begin(), parent_.end(), std::size_t{0}); }

  std::size_t size() const { return parent_.size(); }

  /// The thing that stands for all that hang together with `k`. Which one it is may change with every join.
  std::size_t find(std::size_t k) {
    while (parent_[k] != k) k = parent_[k] = parent_[parent_[k]];
    return k;
  }

  void join(std::size_t a, std::size_t b) { parent_[find(b)] = find(a); }

  /// Members of each group in rising order, groups by their first member.
  std::vector<std::vector<int>> groups() {
    std::vector<std::size_t> all(size());
    std::iota(all.begin(), all.end(), std::size_t{0});
    return groups_of(all);
  }

  /// Places in `things` of those that hang together, in rising order, groups by their first place. A thing may stand
  /// there often, or not at all; k_nothing stands for one that hangs together with no other.
  std::vector<std::vector<int>> groups_of(const std::vector<std::size_t>& things) {
    std::vector<std::size_t> group(size(), k_nothing);
    std::vector<std::vector<int>> groups;
    for (std::size_t i = 0; i < things.size(); ++i) {
      std::size_t place = groups.size();
      if (things[i] != k_nothing) {
        std::size_t& known = group[find(things[i])];
        if (known == k_nothing) known = place;
        place = known;
      }
      if (place == groups.size()) groups.emplace_back();
      groups[place].push_back(static_cast<int>(i));
    }
    return groups;
  }

 private:
  std::vector<std::size_t> parent_;
};

}  // namespace nilas
