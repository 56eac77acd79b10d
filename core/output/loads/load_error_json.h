#pragma once
/// The objects "load_error" and "twins" (perturbed runs) of summary.json. Keys: docs/reference/outputs.md.
#include <nlohmann/json.hpp>

#include "core/output/loads/load_error.h"

namespace nilas::output {

nlohmann::ordered_json load_error_json(const LoadError& error, const TwinStatistics* twins);
nlohmann::ordered_json twins_json(const TwinStatistics& twins);

}  // namespace nilas::output
