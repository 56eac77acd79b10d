#pragma once
/// Describes where XML text is not well formed; the parser gives only a line and a code.
#include <optional>
#include <string>

#include "core/base/error.h"

namespace nilas::scene {

/// The first tag that is incomplete, closes the wrong element or is never closed; empty when the tags match.
std::optional<Fault> tag_fault(const std::string& text, const std::string& file);

}  // namespace nilas::scene
