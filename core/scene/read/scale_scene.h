#pragma once
/// `nilas run --scale`: a scene at another scale by Froude's and Cauchy's laws.
#include <vector>

#include "core/base/error.h"
#include "core/scene/document/document.h"
#include "core/scene/read/resolve.h"

namespace nilas::scene {

/// Scales a resolved tree: each number by the factor of its unit (see scale_factor()), defaults included, and the
/// root's `scale` by `lambda`. Values that have no attribute follow from scaled ones when the world is built. What
/// cannot be scaled becomes a fault: a value that leaves its range, or a file whose reader does not scale. A note says
/// that the scene was scaled.
void scale_scene(SceneElement& root, double lambda, std::vector<Fault>& faults, SceneNotes& notes);

}  // namespace nilas::scene
