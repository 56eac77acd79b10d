#pragma once
/// Friction and restitution by pair of materials.
#include <optional>
#include <string>
#include <vector>

#include "contact/law/elasticity.h"

namespace nilas::contact {

struct FrictionPair {
  double mu_static = 0;
  double mu_kinetic = 0;
  double restitution = 0;                  ///< Newton's coefficient, 0..1
  double rolling = 0;                      ///< the moment against rolling is at most this times the normal force [m]
  double spinning = 0;                     ///< the same about the normal [m]
  std::optional<Elasticity> elastic = {};  ///< empty: the contact is rigid
};

/// Friction of bodies by the numbers of their materials (Bodies::material). Resolved once, so that a step compares no
/// names.
class FrictionPairs {
 public:
  FrictionPairs() = default;
  /// Throws ContractError for a number without a material.
  const FrictionPair& of(int material_a, int material_b) const { return pairs_[place(material_a, material_b)]; }
  /// False for a pair that the scene does not name: it is frictionless.
  bool names(int material_a, int material_b) const { return named_[place(material_a, material_b)] != 0; }
  /// True where some pair has rolling or spinning friction.
  bool any_moments() const { return any_moments_; }
  /// True where some pair is elastic.
  bool any_elastic() const { return any_elastic_; }

 private:
  friend class FrictionTable;
  std::size_t place(int a, int b) const;

  int materials_ = 0;
  std::vector<FrictionPair> pairs_;  ///< materials x materials
  std::vector<char> named_;
  bool any_moments_ = false, any_elastic_ = false;
};

/// The pairs that a scene names. The order of the two materials never matters.
class FrictionTable {
 public:
  /// `*` stands for any material. Throws InputError for a pair named twice, mu_static < mu_kinetic, a coefficient that
  /// is negative or not finite, or a restitution above 1.
  void add(const std::string& material_a, const std::string& material_b, const FrictionPair& values);

  /// The exact pair, else one with one `*` (the first added when both materials have one), else `* *`. A pair that
  /// nothing names is frictionless.
  FrictionPair find(const std::string& material_a, const std::string& material_b) const;
  /// False for a pair that nothing names.
  bool names(const std::string& material_a, const std::string& material_b) const;

  /// All pairs of these materials, which a body names by its place in the list.
  FrictionPairs resolve(const std::vector<std::string>& materials) const;

 private:
  struct Entry {
    std::string first, second;
    FrictionPair values;
    bool joins(const std::string& a, const std::string& b) const {
      return (first == a && second == b) || (first == b && second == a);
    }
  };
  const Entry* entry_of(const std::string& a, const std::string& b) const;

  std::vector<Entry> entries_;
};

}  // namespace nilas::contact
