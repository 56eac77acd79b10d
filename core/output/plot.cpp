#include "core/output/plot.h"

#include <cstdlib>
#include <fstream>

#include "core/base/error.h"

namespace nilas {

namespace {

/// In single quotes for the shell.
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
  std::ifstream log(folder / ".plot.log");
  const std::string said((std::istreambuf_iterator<char>(log)), std::istreambuf_iterator<char>());
  log.close();
  std::filesystem::remove(file);
  std::filesystem::remove(folder / ".plot.log");
  if (status != 0)
    throw FileError("the pictures need gnuplot (Debian package gnuplot-nox), which ended with: " +
                    (said.empty() ? "status " + std::to_string(status) : said));
}

}  // namespace nilas
