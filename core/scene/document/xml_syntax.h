#pragma once
/// Describes where XML text is not well formed; the parser gives only a line and a code.
#include <optional>
#include <string>

#include "core/base/error.h"

namespace nilas::scene {

/// A text larger than any scene, for which the parser or the checks would take all memory or minutes: more than 64 MB,
/// more than a million tags, or a tag of more than a thousand attributes. Empty for all others.
std::optional<Fault> size_fault(const std::string& text, const std::string& file);

/// The first tag that is incomplete, closes the wrong element or is never closed; empty when the tags match.
std::optional<Fault> tag_fault(const std::string& text, const std::string& file);

}  // namespace nilas::scene
