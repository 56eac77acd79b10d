#pragma once
/// The results of `nilas verify` as text, JSON and CSV, and the page of cases.
#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

#include "apps/verify/verdicts.h"

namespace nilas::verify {

/// Returns a table within 80 columns. Under each quantity of a case it has a line per law and integrator, which shows
/// the solver nearest to its limit.
std::string table_text(const std::vector<Row>& rows);
/// Returns the rows that do not hold, one per line.
std::string failures_text(const std::vector<Row>& rows);
/// Returns a list of all rows.
nlohmann::ordered_json table_json(const std::vector<Row>& rows);
/// Returns comma-separated values with a header line. Numbers have 17 digits.
std::string table_csv(const std::vector<Row>& rows);
/// Returns the page docs/evidence/verification.md: number, formula, inputs and source of each case.
std::string catalogue_markdown();
/// Returns a line per case.
std::string catalogue_text();

/// Whether every row holds.
bool all_hold(const std::vector<Row>& rows);

}  // namespace nilas::verify
