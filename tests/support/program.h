#pragma once
/// Runs the built program as a user would, and reads its output.
#include <sys/wait.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>
#include <vector>

#include "tests/support/csv_table.h"
#include "tests/support/file_text.h"
#include "tests/support/scratch_folder.h"

namespace nilas_test {

namespace fs = std::filesystem;

using nilas::test::lines_of;
using nilas::test::read_text;
using nilas::test::ScratchFolder;
using nilas::test::Table;

struct ProgramResult {
  int exit_code = -1;
  std::string out, err;
};

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

inline fs::path shipped_scene(const std::string& name) { return fs::path(NILAS_SOURCE_DIR) / "apps" / "scenes" / name; }

}  // namespace nilas_test
