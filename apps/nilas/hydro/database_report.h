#pragma once
/// The report of `nilas hydro` on a hydrodynamic database.
#include <nlohmann/json.hpp>
#include <optional>
#include <string>

#include "hydro/database/self_check.h"

namespace nilas::commands {

/// What was read and what the checks found. Keys end in units; loads and matrices are those of hydro::Database. `mass`:
/// the rigid-body mass about the origin of D, for motions and natural periods; null entries without it.
nlohmann::ordered_json database_report(const hydro::Database& database, const hydro::SelfCheck& check,
                                       const std::optional<Mat6>& mass);

/// The report as tables and sentences for a terminal of 100 columns.
std::string database_text(const nlohmann::ordered_json& report);

}  // namespace nilas::commands
