#pragma once
/// Reads files, and the lines of texts.
#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>
#include <vector>

namespace nilas::test {

/// Returns the bytes of a file, or an empty text where it cannot be opened.
inline std::string read_text(const std::filesystem::path& file) {
  std::ifstream in(file, std::ios::binary);
  std::ostringstream text;
  text << in.rdbuf();
  return text.str();
}

/// Returns the lines of a text without their ends.
inline std::vector<std::string> split_lines(const std::string& text) {
  std::istringstream in(text);
  std::vector<std::string> lines;
  for (std::string line; std::getline(in, line);) lines.push_back(line);
  return lines;
}

/// Returns the lines of a file without their ends.
inline std::vector<std::string> lines_of(const std::filesystem::path& file) { return split_lines(read_text(file)); }

}  // namespace nilas::test
