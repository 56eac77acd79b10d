#include "core/choices/law.h"

#include <charconv>

namespace nilas {

/// The k of "pyramid-k", 0 when the name has another form.
static int parse_facets(const std::string& name) {
  const std::string stem = "pyramid-";
  if (name.rfind(stem, 0) != 0) return 0;
  int facets = 0;
  const char* const end = name.data() + name.size();
  const auto [stop, error] = std::from_chars(name.data() + stem.size(), end, facets);
  return error == std::errc() && stop == end ? facets : 0;
}

static std::string suggestion(const std::string& name) {
  const std::vector<std::string> known{"coulomb", "ccp", "pyramid", "pyramid-8", "frictionless"};
  const std::string nearest = nearest_name(name, known);
  std::string all;
  for (const auto& word : known) all += (all.empty() ? "" : ", ") + word;
  return (nearest.empty() ? "" : "; did you mean '" + nearest + "'?") + std::string(" known: ") + all;
}

ParsedLaw parse_law(const std::string& name) {
  const auto law = find_choice<Law>(name);
  if (law && *law != Law::pyramid_k) return {*law, 0};
  const int facets = parse_facets(name);
  if (facets >= k_fewest_facets && facets <= k_most_facets) return {Law::pyramid_k, facets};
  if (facets != 0 || law)
    throw InputError("contact law '" + name + "': a pyramid has " + std::to_string(k_fewest_facets) + " to " +
                     std::to_string(k_most_facets) + " facets, e.g. pyramid-8");
  throw InputError("unknown contact law '" + name + "'" + suggestion(name));
}

std::string name_of(const ParsedLaw& law) {
  return law.law == Law::pyramid_k ? "pyramid-" + std::to_string(law.facets) : name_of(law.law);
}

}  // namespace nilas
