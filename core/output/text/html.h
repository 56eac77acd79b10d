#pragma once
/// Elements of self-contained HTML pages.
#include <filesystem>
#include <string>

namespace nilas::output {

/// The text with <, >, & and both quotes as entities, for text and attributes.
std::string html_text(const std::string& text);

/// The <svg> element of a picture file, to embed in a page. Throws FileError where the file cannot be read or holds
/// none.
std::string inline_svg(const std::filesystem::path& file);

/// The style sheet of all pages.
extern const char* const k_page_style;

}  // namespace nilas::output
