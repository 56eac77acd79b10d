#pragma once
/// The request and the plan of a comparison as JSON.
#include <nlohmann/json.hpp>
#include <vector>

#include "apps/compare/scenes/run/scene_study.h"

namespace nilas::compare {

/// A list of objects with `what` and `why`.
nlohmann::ordered_json to_json(const std::vector<Omission>& omissions);

nlohmann::ordered_json to_json(const SceneStudy& study);
/// The study from its JSON. Throws nlohmann::json::exception if an entry is missing or of another kind.
SceneStudy scene_study_from(const nlohmann::ordered_json& json);

}  // namespace nilas::compare
