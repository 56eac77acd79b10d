#pragma once
/// Says where XML text stops being well formed, in words: the parser gives a line and a code only.
#include <optional>
#include <string>

#include "core/base/error.h"

namespace nilas {

/// The first tag that is cut short, closes the wrong element or is never closed; nothing when the tags match.
std::optional<Fault> tag_fault(const std::string& text, const std::string& file);

}  // namespace nilas
