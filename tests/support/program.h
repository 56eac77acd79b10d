#pragma once
/// Runs the built program as a user would, and reads its output.
#include <sys/wait.h>

#include <array>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <map>
#include <sstream>
#include <stdexcept>
#include <string>
#include <vector>

#include "tests/support/scratch_folder.h"

namespace nilas_test {

namespace fs = std::filesystem;

using nilas::test::ScratchFolder;

struct ProgramResult {
  int exit_code = -1;
  std::string out, err;
};

inline std::string read_text(const fs::path& file) {
  std::ifstream in(file, std::ios::binary);
  std::ostringstream text;
  text << in.rdbuf();
  return text.str();
}

/// Runs `nilas ARGUMENTS` in the given folder through the shell.
inline ProgramResult run_nilas(const std::string& arguments, const fs::path& folder) {
  const fs::path out = folder / "stdout.txt", err = folder / "stderr.txt";
  const std::string command = "cd '" + folder.string() + "' && '" NILAS_PROGRAM "' " + arguments + " >'" +
                              out.string() + "' 2>'" + err.string() + "' </dev/null";
  const int status = std::system(command.c_str());
  ProgramResult result;
  result.exit_code = WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
  result.out = read_text(out);
  result.err = read_text(err);
  return result;
}

/// A CSV file as columns by name. Cells that are not numbers read as NaN.
class Table {
 public:
  explicit Table(const fs::path& file) {
    std::ifstream in(file);
    std::string line;
    if (!std::getline(in, line)) throw std::runtime_error(file.string() + ": empty");
    header_ = split(line);
    columns_.resize(header_.size());
    text_.resize(header_.size());
    while (std::getline(in, line)) {
      const auto cells = split(line);
      if (cells.size() != header_.size()) throw std::runtime_error(file.string() + ": ragged row: " + line);
      for (std::size_t i = 0; i < cells.size(); ++i) {
        char* end = nullptr;
        const double x = std::strtod(cells[i].c_str(), &end);
        columns_[i].push_back(end == cells[i].c_str() ? std::numeric_limits<double>::quiet_NaN() : x);
        text_[i].push_back(cells[i]);
      }
    }
  }
  bool has(const std::string& name) const { return find(name) < header_.size(); }
  const std::vector<double>& operator[](const std::string& name) const { return columns_[demand(name)]; }
  const std::vector<std::string>& text(const std::string& name) const { return text_[demand(name)]; }
  std::size_t rows() const { return columns_.empty() ? 0 : columns_[0].size(); }
  const std::vector<std::string>& header() const { return header_; }

 private:
  static std::vector<std::string> split(const std::string& line) {
    std::vector<std::string> cells;
    std::stringstream in(line);
    for (std::string cell; std::getline(in, cell, ',');) cells.push_back(cell);
    return cells;
  }
  std::size_t find(const std::string& name) const {
    for (std::size_t i = 0; i < header_.size(); ++i)
      if (header_[i] == name) return i;
    return header_.size();
  }
  std::size_t demand(const std::string& name) const {
    const std::size_t i = find(name);
    if (i == header_.size()) throw std::runtime_error("no column " + name);
    return i;
  }
  std::vector<std::string> header_;
  std::vector<std::vector<double>> columns_;
  std::vector<std::vector<std::string>> text_;
};

inline fs::path shipped_scene(const std::string& name) { return fs::path(NILAS_SOURCE_DIR) / "apps" / "scenes" / name; }

}  // namespace nilas_test
