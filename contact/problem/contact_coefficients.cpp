#include "contact/problem/contact_coefficients.h"

namespace nilas {

const char* to_string(Law law) {
  switch (law) {
    case Law::coulomb:
      return "coulomb";
    case Law::ccp:
      return "ccp";
    case Law::pyramid:
      return "pyramid";
    case Law::pyramid_k:
      return "pyramid-k";
    case Law::frictionless:
      return "frictionless";
  }
  return "unknown";
}

ContactCoefficients select(const ContactCoefficients& all, const std::vector<int>& contacts) {
  ContactCoefficients part;
  part.law = all.law;
  part.facets = all.facets;
  for_each_list(part, all, [&](auto& list, const auto& from) {
    list.reserve(contacts.size());
    for (const int c : contacts) list.push_back(from[static_cast<std::size_t>(c)]);
  });
  return part;
}

}  // namespace nilas
