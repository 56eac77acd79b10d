#pragma once
/// Friction and restitution by pair of materials.
#include <string>
#include <utility>
#include <vector>

#include "core/base/state.h"

namespace nilas {

struct FrictionPair {
  double mu_static = 0;
  double mu_kinetic = 0;
  double restitution = 0;  ///< Newton's coefficient, 0..1
  double rolling = 0;      ///< the moment against rolling is at most this times the normal force [m]
  double spinning = 0;     ///< the same about the normal [m]
};

/// The pairs that a scene names. The order of the two materials never matters.
class FrictionTable {
 public:
  /// `*` stands for any material. Throws InputError for a pair named twice, mu_static < mu_kinetic, a coefficient that
  /// is negative or not finite, or a restitution above 1.
  void add(const std::string& material_a, const std::string& material_b, const FrictionPair& values);

  /// The exact pair, else one with one `*` (the first added when both materials have one), else `* *`. A pair that
  /// nothing names is frictionless and remembered.
  FrictionPair find(const std::string& material_a, const std::string& material_b);

  /// Pairs that `find` met and nothing names, each once, in the order they were met.
  std::vector<std::pair<std::string, std::string>> unnamed_pairs() const;

  /// The unnamed pairs, which are told once.
  void save(StateWriter out) const;
  void restore(const StateReader& in);

 private:
  struct Entry {
    std::string first, second;  ///< in alphabetical order
    FrictionPair values;
    bool named = true;
    bool joins(const std::string& a, const std::string& b) const {
      return (first == a && second == b) || (first == b && second == a);
    }
  };
  Entry resolve(const std::string& a, const std::string& b) const;

  std::vector<Entry> entries_;
  std::vector<Entry> met_;  ///< answers so far, by material
};

}  // namespace nilas
