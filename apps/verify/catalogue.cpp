#include <algorithm>

#include "apps/verify/families.h"
#include "core/base/error.h"

namespace nilas::verify {

std::string family_title(char family) {
  switch (family) {
    case 'A':
      return "Point friction";
    case 'B':
      return "Rolling and spinning";
    case 'C':
      return "Free bodies and joints";
    case 'D':
      return "Statics, stacks and convergence rates";
    case 'E':
      return "Impacts";
    case 'F':
      return "Floating bodies";
    case 'G':
      return "Invariances";
    case 'H':
      return "Crushing";
    case 'I':
      return "Water that moves with bodies";
    default:
      break;
  }
  throw ContractError("no such family");
}

const std::vector<Case>& catalogue() {
  static const std::vector<Case> all = [] {
    std::vector<Case> cases;
    for (const auto& family : {point_friction(), rolling(), free_bodies(), statics(), impacts(), floating(),
                               invariances(), crushing(), water()})
      cases.insert(cases.end(), family.begin(), family.end());
    std::sort(cases.begin(), cases.end(), [](const Case& a, const Case& b) { return a.number < b.number; });
    return cases;
  }();
  return all;
}

}  // namespace nilas::verify
