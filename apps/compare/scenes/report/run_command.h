#pragma once
/// The recommendation as a command.
#include <string>

#include "apps/compare/scenes/report/scene_report.h"

namespace nilas::compare {

/// `nilas run` with the recommended setting, quoted for a shell; empty where no setting is recommended. It has the
/// user's own changes of the scene too, but for its end, which the comparison may have brought forward.
std::string run_command(const SceneReport& report);

}  // namespace nilas::compare
