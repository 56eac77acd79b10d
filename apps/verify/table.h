#pragma once
/// The table of verification in its forms.
#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

#include "apps/verify/verdicts.h"

namespace nilas {

/// Under each quantity of a case one line per law and integrator, the worst of its solvers, within 80 columns.
std::string table_text(const std::vector<Row>& rows);
/// The rows that do not hold, one per line.
std::string failures_text(const std::vector<Row>& rows);
nlohmann::ordered_json table_json(const std::vector<Row>& rows);
/// Comma-separated, a header line first, 17 digits.
std::string table_csv(const std::vector<Row>& rows);
/// The page of cases: number, formula, inputs and source of each.
std::string catalogue_markdown();
/// A line per case.
std::string catalogue_text();

/// Whether every row holds.
bool all_hold(const std::vector<Row>& rows);

}  // namespace nilas
