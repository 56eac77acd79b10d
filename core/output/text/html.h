#pragma once
/// Pieces of pages that need no other file.
#include <filesystem>
#include <string>

namespace nilas {

/// With <, >, & and both quotes written as entities, so that it may stand in text and in attributes.
std::string html_text(const std::string& text);

/// A picture's <svg> element, to stand in a page. Throws FileError where the file cannot be read.
std::string inline_svg(const std::filesystem::path& file);

/// What all pages look like.
extern const char* const k_page_style;

}  // namespace nilas
