#pragma once
/// The law of a contact problem and the coefficients of its contacts: what its two forms have in common.
#include <cstdint>
#include <vector>

#include "core/choices/law.h"

namespace nilas::contact {

/// The law's name; pyramid-k stands for the names with a number that scene files have, such as pyramid-8.
const char* to_string(Law law);

struct ContactCoefficients {
  Law law = Law::coulomb;
  int facets = 8;  ///< number of sides of pyramid_k

  std::vector<double> mu;           ///< nc, kinetic friction coefficient
  std::vector<double> mu_static;    ///< nc, >= mu
  std::vector<double> force_limit;  ///< nc, largest normal impulse (infinite: none) [N s]
  std::vector<double> compliance;   ///< nc, >= 0, c_N: u_N + c_N r_N replaces u_N [m/(s N s)]
  /// nc, >= 0, c_T: u_T + c_T r_T replaces u_T [m/(s N s)]. For a spring it is the speed of slip, so it takes the place
  /// of u_T everywhere in the law, in mu |u_T| as well: with C = diag(c_N, c_T, c_T) a solver works with W + C for W.
  /// Zero for moments.
  std::vector<double> tangential_compliance;
  std::vector<std::uint64_t> key;  ///< nc, distinct, stable from step to step

  bool operator==(const ContactCoefficients&) const = default;
};

/// Calls use(list, the same list of the other) for every list with one entry per contact. The bindings name every
/// member, so a new one does not compile until it is added here.
template <class Use>
void for_each_list(ContactCoefficients& one, const ContactCoefficients& other, const Use& use) {
  auto& [law, facets, mu, mu_static, force_limit, compliance, tangential_compliance, key] = one;
  use(mu, other.mu);
  use(mu_static, other.mu_static);
  use(force_limit, other.force_limit);
  use(compliance, other.compliance);
  use(tangential_compliance, other.tangential_compliance);
  use(key, other.key);
}

/// The law, and the coefficients of some contacts in the order given.
ContactCoefficients select(const ContactCoefficients& all, const std::vector<int>& contacts);

}  // namespace nilas::contact
