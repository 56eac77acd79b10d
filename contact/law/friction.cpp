#include "contact/law/friction.h"

#include <algorithm>
#include <cmath>

#include "core/base/error.h"

namespace nilas {

constexpr const char* k_any_material = "*";

[[noreturn]] static void refuse(const std::string& a, const std::string& b, const std::string& fault) {
  std::string message = "friction between '";
  message.append(a).append("' and '").append(b).append("': ").append(fault);
  throw InputError(message);
}

static void check(const std::string& a, const std::string& b, const FrictionPair& values) {
  for (const double x : {values.mu_static, values.mu_kinetic, values.restitution, values.rolling, values.spinning})
    if (!std::isfinite(x) || x < 0) refuse(a, b, "coefficients must be finite and not negative");
  if (values.mu_static < values.mu_kinetic)
    refuse(a, b,
           "static " + std::to_string(values.mu_static) + " is below kinetic " + std::to_string(values.mu_kinetic));
  if (values.restitution > 1) refuse(a, b, "restitution " + std::to_string(values.restitution) + " is above 1");
}

void FrictionTable::add(const std::string& material_a, const std::string& material_b, const FrictionPair& values) {
  check(material_a, material_b, values);
  for (const auto& entry : entries_)
    if (entry.joins(material_a, material_b)) refuse(material_a, material_b, "named twice");
  entries_.push_back({std::min(material_a, material_b), std::max(material_a, material_b), values, true});
  met_.clear();
}

FrictionTable::Entry FrictionTable::resolve(const std::string& a, const std::string& b) const {
  const auto answer = [&](const FrictionPair& values, bool named) {
    return Entry{std::min(a, b), std::max(a, b), values, named};
  };
  for (const auto& entry : entries_)
    if (entry.joins(a, b)) return answer(entry.values, true);
  for (const auto& entry : entries_)
    if (entry.joins(a, k_any_material) || entry.joins(b, k_any_material)) return answer(entry.values, true);
  for (const auto& entry : entries_)
    if (entry.joins(k_any_material, k_any_material)) return answer(entry.values, true);
  return answer({}, false);
}

FrictionPair FrictionTable::find(const std::string& material_a, const std::string& material_b) {
  for (const auto& entry : met_)
    if (entry.joins(material_a, material_b)) return entry.values;
  met_.push_back(resolve(material_a, material_b));
  return met_.back().values;
}

std::vector<std::pair<std::string, std::string>> FrictionTable::unnamed_pairs() const {
  std::vector<std::pair<std::string, std::string>> pairs;
  for (const auto& entry : met_)
    if (!entry.named) pairs.emplace_back(entry.first, entry.second);
  return pairs;
}

void FrictionTable::save(StateWriter out) const {
  const auto pairs = unnamed_pairs();
  out.add("unnamed_pairs", pairs.size());
  for (std::size_t k = 0; k < pairs.size(); ++k) {
    StateWriter pair = out.group(std::to_string(k));
    pair.add("first", pairs[k].first);
    pair.add("second", pairs[k].second);
  }
}

void FrictionTable::restore(const StateReader& in) {
  std::size_t count = 0;
  in.get("unnamed_pairs", count);
  for (std::size_t k = 0; k < count; ++k) {
    std::string first, second;
    in.group(std::to_string(k)).get("first", first);
    in.group(std::to_string(k)).get("second", second);
    find(first, second);
  }
}

}  // namespace nilas
