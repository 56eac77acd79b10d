#include "core/output/text/plot.h"

#include <sys/wait.h>

#include <cstdlib>
#include <fstream>

#include "core/base/file_bytes.h"

namespace nilas::output {

namespace {

/// The text in single quotes for the shell.
std::string for_shell(const std::string& text) {
  std::string out = "'";
  for (const char c : text) out += c == '\'' ? std::string("'\\''") : std::string(1, c);
  return out + "'";
}

}  // namespace

void plot(const std::filesystem::path& folder, const std::string& script) {
  const std::filesystem::path file = folder / ".plot.gp";
  std::ofstream out(file);
  out << script;
  if (!out.flush()) throw FileError("cannot write " + file.string());
  out.close();
  const int status = std::system(("cd " + for_shell(folder.string()) + " && gnuplot .plot.gp 2>.plot.log").c_str());
  const std::filesystem::path log = folder / ".plot.log";
  const std::string said = std::filesystem::exists(log) ? file_bytes(log) : "";
  std::error_code ignored;
  std::filesystem::remove(file, ignored);
  std::filesystem::remove(log, ignored);
  constexpr int k_not_found = 127;  // exit code of the shell
  if (WIFEXITED(status) && WEXITSTATUS(status) == k_not_found)
    throw PlotError("the pictures need gnuplot (Debian package gnuplot-nox), which is not there");
  if (status != 0) throw PlotError("gnuplot failed: " + (said.empty() ? "status " + std::to_string(status) : said));
}

}  // namespace nilas::output
