#include "contact/law/friction.h"

#include <algorithm>
#include <cmath>

#include "core/base/error.h"

namespace nilas::contact {

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
  entries_.push_back({material_a, material_b, values});
}

const FrictionTable::Entry* FrictionTable::entry_of(const std::string& a, const std::string& b) const {
  for (const auto& entry : entries_)
    if (entry.joins(a, b)) return &entry;
  for (const auto& entry : entries_)
    if (entry.joins(a, k_any_material) || entry.joins(b, k_any_material)) return &entry;
  for (const auto& entry : entries_)
    if (entry.joins(k_any_material, k_any_material)) return &entry;
  return nullptr;
}

FrictionPair FrictionTable::find(const std::string& material_a, const std::string& material_b) const {
  const Entry* entry = entry_of(material_a, material_b);
  return entry ? entry->values : FrictionPair{};
}

bool FrictionTable::names(const std::string& material_a, const std::string& material_b) const {
  return entry_of(material_a, material_b) != nullptr;
}

FrictionPairs FrictionTable::resolve(const std::vector<std::string>& materials) const {
  FrictionPairs resolved;
  resolved.materials_ = static_cast<int>(materials.size());
  for (const std::string& a : materials)
    for (const std::string& b : materials) {
      resolved.pairs_.push_back(find(a, b));
      resolved.named_.push_back(names(a, b) ? 1 : 0);
      const FrictionPair& pair = resolved.pairs_.back();
      resolved.any_moments_ = resolved.any_moments_ || pair.rolling > 0 || pair.spinning > 0;
      resolved.any_elastic_ = resolved.any_elastic_ || pair.elastic.has_value();
    }
  return resolved;
}

std::size_t FrictionPairs::place(int a, int b) const {
  NILAS_DEMAND(a >= 0 && b >= 0 && a < materials_ && b < materials_);
  return static_cast<std::size_t>(a * materials_ + b);
}

}  // namespace nilas::contact
