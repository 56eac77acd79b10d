#pragma once
/// Contact laws by name.
#include <array>
#include <vector>

#include "core/choices/choice.h"

namespace nilas {

/// Contact law, a property of the problem. See docs/theory/contact.md.
enum class Law { coulomb, ccp, pyramid, pyramid_k, frictionless };
constexpr ChoiceText choice_text(Law value) {
  switch (value) {
    case Law::coulomb:
      return {"coulomb", "The exact friction cone is used."};
    case Law::ccp:
      return {"ccp", "The friction cone is convexified, so that sliding contacts separate slightly."};
    case Law::pyramid:
      return {"pyramid", "Friction is bounded separately along two tangents."};
    case Law::pyramid_k:
      return {"pyramid-k", "The cone is replaced by a pyramid with k facets, as in pyramid-8."};
    case Law::frictionless:
      return {"frictionless", "There is no friction."};
  }
  return {};
}

/// Laws that solvers take together: all; those of single rows; exact cones; and all whose admissible impulses are a
/// convex set that does not depend on the normal impulse.
inline constexpr std::array k_all_laws{Law::coulomb, Law::ccp, Law::pyramid, Law::pyramid_k, Law::frictionless};
inline constexpr std::array k_row_laws{Law::pyramid, Law::coulomb, Law::frictionless};
inline constexpr std::array k_cone_laws{Law::coulomb, Law::ccp, Law::frictionless};
inline constexpr std::array k_convex_laws{Law::coulomb, Law::ccp, Law::pyramid_k, Law::frictionless};

/// Numbers of facets that pyramid-k takes. At the upper bound its friction is within 5e-6 of the cone's.
constexpr int k_fewest_facets = 3, k_most_facets = 1000;

/// A law as it is asked for.
struct ParsedLaw {
  Law law = Law::coulomb;
  int facets = 0;  ///< number of facets of pyramid_k

  bool operator==(const ParsedLaw&) const = default;
};

/// "pyramid-8" gives pyramid_k with 8 facets. Throws InputError naming the nearest law.
ParsedLaw parse_law(const std::string& name);
/// The name of the law with its parameter: "pyramid-8".
std::string name_of(const ParsedLaw& law);

}  // namespace nilas
