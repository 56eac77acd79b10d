#pragma once
/// Optional numbers in JSON.
#include <nlohmann/json.hpp>
#include <optional>

namespace nilas::output {

/// The number, or null where there is none.
inline nlohmann::ordered_json or_null(const std::optional<double>& x) {
  return x ? nlohmann::ordered_json(*x) : nlohmann::ordered_json(nullptr);
}

}  // namespace nilas::output
