#include "core/output/text/html.h"

#include "core/base/error.h"
#include "core/base/file_bytes.h"

namespace nilas::output {

const char* const k_page_style =
    "body{font:14px/1.5 sans-serif;max-width:1100px;margin:2em auto;padding:0 1em;color:#222}"
    "table{border-collapse:collapse;font-size:12px}td,th{padding:1px 6px;text-align:left;border-bottom:1px solid #ddd}"
    "tr.fails{background:#fdd;font-weight:bold}summary{cursor:pointer;margin:.5em 0}svg{max-width:100%;height:auto}";

std::string html_text(const std::string& text) {
  std::string out;
  for (const char c : text) {
    if (c == '<')
      out += "&lt;";
    else if (c == '>')
      out += "&gt;";
    else if (c == '&')
      out += "&amp;";
    else if (c == '"')
      out += "&quot;";
    else if (c == '\'')
      out += "&#39;";
    else
      out += c;
  }
  return out;
}

std::string inline_svg(const std::filesystem::path& file) {
  const std::string svg = file_bytes(file);
  const auto start = svg.find("<svg");
  if (start == std::string::npos) throw FileError(file.string() + " holds no picture");
  return svg.substr(start);
}

}  // namespace nilas::output
