#include "contact/problem/contact_coefficients.h"

namespace nilas::contact {

const char* to_string(Law law) { return choice_text(law).name.data(); }

ContactCoefficients select(const ContactCoefficients& all, const std::vector<int>& contacts) {
  ContactCoefficients part;
  part.law = all.law;
  part.facets = all.facets;
  for_each_list(part, all, [&](auto& list, const auto& from) {
    list.reserve(contacts.size());
    for (const int c : contacts) list.push_back(from[c]);
  });
  return part;
}

}  // namespace nilas::contact
