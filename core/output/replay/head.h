#pragma once
/// The head of a replay: what a viewer must know of the scene before the first frame.
#include <string>

#include "core/output/replay/channels.h"
#include "core/scene/scene.h"

namespace nilas::output::replay {

/// The head as JSON. Keys: docs/reference/replay-file.md.
std::string head_text(const scene::Scene& scene, const sim::RunInfo& info, const Channels& channels,
                      bool has_contact_table);

/// The waves as JSON, empty without waves.
std::string waves_text(const sim::RunInfo& info);

}  // namespace nilas::output::replay
