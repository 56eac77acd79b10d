#pragma once
/// Checks a tree against the schema table, element by element.
#include <vector>

#include "core/scene/document/document.h"

namespace nilas::scene {

/// Reports everything that the table does not allow. Elements that are unknown, not built or too many are removed from
/// the tree, and faulty attributes become invalid, so that later checks only treat the rest.
void check_document(SceneElement& root, std::vector<Fault>& faults);

}  // namespace nilas::scene
