#pragma once
/// Checks a tree against the schema table, element by element.
#include <vector>

#include "core/scene/document/document.h"

namespace nilas {

/// Reports everything that the table does not allow. Elements that are unknown, not built or one too many leave the
/// tree, faulty attributes become invalid, so that later checks speak of what is left.
void check_document(SceneElement& root, std::vector<Fault>& faults);

}  // namespace nilas
