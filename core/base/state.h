#pragma once
/// The state with which a class continues exactly where it stopped: named arrays, kept bit for bit. Each class saves
/// and restores its own group; core/sim/checkpoint.h writes the whole to disk.
#include <algorithm>
#include <array>
#include <concepts>
#include <cstdint>
#include <map>
#include <span>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "core/base/math.h"

namespace nilas {

using StateEntry = std::variant<std::vector<double>, std::vector<std::int64_t>, std::string>;

struct State {
  std::string source;                         ///< where it was read from, for messages
  std::map<std::string, StateEntry> entries;  ///< entries by path: "simulation/bodies/p_GB"
};

/// The numbers of a value, in place.
inline std::span<double> numbers_of(double& x) { return {&x, 1}; }
inline std::span<double> numbers_of(Quat& q) { return {q.coeffs().data(), 4}; }  // x y z w
template <int rows, int columns>
std::span<double> numbers_of(Eigen::Matrix<double, rows, columns>& m) {
  return {m.data(), static_cast<std::size_t>(m.size())};
}
template <std::size_t count>
std::span<double> numbers_of(std::array<double, count>& a) {
  return a;
}
template <class T>
concept Numbers = requires(T& value) {
  numbers_of(value);
};

/// Adds entries to one group of a state. Throws ContractError for a name used twice.
class StateWriter {
 public:
  explicit StateWriter(State& state, std::string group = "") : state_(&state), group_(std::move(group)) {}
  StateWriter group(const std::string& name) const { return StateWriter(*state_, group_ + name + "/"); }

  void add(const std::string& name, const std::string& text) { put(name, text); }
  template <std::integral T>
  void add(const std::string& name, T n) {
    put(name, std::vector<std::int64_t>{static_cast<std::int64_t>(n)});
  }
  template <Numbers T>
  void add(const std::string& name, T value) {
    const std::span<double> numbers = numbers_of(value);
    put(name, std::vector<double>(numbers.begin(), numbers.end()));
  }
  template <std::integral T>
  void add(const std::string& name, const std::vector<T>& values) {
    put(name, std::vector<std::int64_t>(values.begin(), values.end()));
  }
  /// One value's numbers after the other's.
  template <Numbers T>
  void add(const std::string& name, const std::vector<T>& values) {
    std::vector<double> all;
    for (T value : values) {
      const std::span<double> numbers = numbers_of(value);
      all.insert(all.end(), numbers.begin(), numbers.end());
    }
    put(name, std::move(all));
  }

 private:
  void put(const std::string& name, StateEntry entry);

  State* state_;
  std::string group_;
};

/// Reads one group of a state. Throws InputError naming the entry that is missing, of another kind or of another size.
class StateReader {
 public:
  explicit StateReader(const State& state, std::string group = "") : state_(&state), group_(std::move(group)) {}
  StateReader group(const std::string& name) const { return StateReader(*state_, group_ + name + "/"); }

  void get(const std::string& name, std::string& text) const { text = std::get<std::string>(find(name, 2)); }
  template <std::integral T>
  void get(const std::string& name, T& n) const {
    const auto& stored = integers(name);
    demand(name, stored.size(), 1);
    n = static_cast<T>(stored[0]);
  }
  /// A matrix must have its size already.
  template <Numbers T>
  void get(const std::string& name, T& value) const {
    const auto& stored = numbers(name);
    demand(name, stored.size(), numbers_of(value).size());
    std::copy(stored.begin(), stored.end(), numbers_of(value).begin());
  }
  template <std::integral T>
  void get(const std::string& name, std::vector<T>& values) const {
    const auto& stored = integers(name);
    values.clear();
    for (const std::int64_t n : stored) values.push_back(static_cast<T>(n));
  }
  /// Values of fixed size, as many as there are.
  template <Numbers T>
  void get(const std::string& name, std::vector<T>& values) const {
    const auto& stored = numbers(name);
    T one{};
    const std::size_t size = numbers_of(one).size();
    demand(name, stored.size() % size, 0);
    values.resize(stored.size() / size);
    auto from = stored.begin();
    for (T& value : values) {
      std::copy(from, from + static_cast<std::ptrdiff_t>(size), numbers_of(value).begin());
      from += static_cast<std::ptrdiff_t>(size);
    }
  }
  /// The same, of a length that is known.
  template <class T>
  void get(const std::string& name, std::vector<T>& values, std::size_t length) const {
    get(name, values);
    demand(name, values.size(), length);
  }

  [[noreturn]] void refuse(const std::string& name, const std::string& fault) const;

 private:
  const StateEntry& find(const std::string& name, std::size_t kind) const;
  const std::vector<double>& numbers(const std::string& name) const {
    return std::get<std::vector<double>>(find(name, 0));
  }
  const std::vector<std::int64_t>& integers(const std::string& name) const {
    return std::get<std::vector<std::int64_t>>(find(name, 1));
  }
  void demand(const std::string& name, std::size_t found, std::size_t expected) const;

  const State* state_;
  std::string group_;
};

}  // namespace nilas
