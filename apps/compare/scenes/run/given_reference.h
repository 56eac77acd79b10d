#pragma once
/// A run folder that the user gives in place of the reference that a comparison would make.
#include <filesystem>
#include <map>
#include <string>

#include "apps/compare/scenes/run/scene_store.h"

namespace nilas::compare {

/// Throws InputError if the folder does not hold a whole run of the scene with the same seed and length.
void demand_reference_run(const std::filesystem::path& from, const scene::Scene& scene);

/// Makes that run the reference of every realisation of the study, in the study's plan, its folder and `results`.
/// Throws FileError.
void take_reference(SceneStudy& study, const SceneStore& folder, std::map<std::string, RunResult>& results);

}  // namespace nilas::compare
