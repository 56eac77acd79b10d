#pragma once
/// The picture of computing time against error, for papers.
#include <optional>
#include <string>
#include <vector>

#include "apps/compare/scenes/judge/findings.h"
#include "apps/compare/scenes/report/log_axis.h"
#include "apps/compare/workshop/picture.h"

namespace nilas::compare {

/// The front of the error that ranks the settings, with a number at each mark; nothing if there is no mark. `labels`:
/// of all settings of the plan.
std::optional<Picture> front_picture(const std::string& name, const Findings& found,
                                     const std::vector<std::string>& labels);

/// The ends and labels of an axis under the names that templates use.
void add_axis(const std::string& name, const LogAxis& axis, nlohmann::ordered_json& data);

/// The value, or null if it is not known. Null leaves a section of the template out.
nlohmann::ordered_json number_if(bool known, double value);

}  // namespace nilas::compare
