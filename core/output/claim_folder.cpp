#include "core/output/claim_folder.h"

#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <optional>
#include <regex>
#include <system_error>
#include <vector>

#include "core/base/error.h"

namespace nilas {

namespace {

namespace fs = std::filesystem;

/// Files that are replaced as a whole are left so where a run was killed while writing.
constexpr const char* k_half_written = ".part";

/// Everything that a run writes beside its trajectory folder.
const std::vector<std::string>& own_files() {
  static const std::vector<std::string> names{"scene.xml",      "vessel.csv", "steps.csv",   "contacts.h5",
                                              "trajectory.pvd", "events.csv", "replay.html", "report.html",
                                              "summary.json",   "bodies.csv", "nilas.log",   "checkpoint.h5"};
  return names;
}

/// Step of a trajectory frame, or of one half written; nothing for other files.
std::optional<long> step_of_frame(const std::string& name) {
  static const std::regex pattern(R"(step-(\d{6,18})\.vtp(\.part)?)");
  std::smatch match;
  if (!std::regex_match(name, match, pattern)) return std::nullopt;
  return std::stol(match[1]);
}

[[noreturn]] void fail(const fs::path& path, const std::string& what, const std::string& reason) {
  throw FileError(path.string() + ": cannot " + what + ": " + reason);
}

void remove_file(const fs::path& path) {
  std::error_code error;
  if (fs::is_directory(fs::symlink_status(path, error))) return;
  fs::remove(path, error);
  if (error) fail(path, "remove the file of an earlier run", error.message());
}

void remove_frames_after(const fs::path& folder, long step) {
  std::error_code error;
  if (!fs::is_directory(fs::symlink_status(folder, error))) return;
  std::vector<fs::path> frames;
  for (const auto& entry : fs::directory_iterator(folder, error))
    if (step_of_frame(entry.path().filename().string()).value_or(step) > step) frames.push_back(entry.path());
  for (const auto& frame : frames) remove_file(frame);
}

/// A run that was interrupted before its first step leaves its log alone.
bool holds_at_most_a_log(const fs::path& folder, std::error_code& error) {
  const fs::directory_iterator entries(folder, error);
  return !error && std::all_of(begin(entries), end(entries),
                               [](const auto& entry) { return entry.path().filename() == "nilas.log"; });
}

}  // namespace

void claim_folder(const fs::path& folder, bool force) {
  std::error_code error;
  fs::create_directories(folder, error);
  if (error) fail(folder, "create the output folder", error.message());
  if (!fs::is_directory(folder, error)) fail(folder, "use it as the output folder", "it is not a folder");
  const bool empty = holds_at_most_a_log(folder, error);
  if (error) fail(folder, "read the output folder", error.message());
  if (!empty && !force)
    throw InputError(folder.string() +
                     ": the output folder is not empty; choose another by --out, or give --force to "
                     "replace the outputs of an earlier run in it");
  if (::access(folder.c_str(), W_OK | X_OK) != 0) fail(folder, "write into the output folder", std::strerror(errno));
  for (const auto& name : own_files()) {
    remove_file(folder / name);
    remove_file(folder / (name + k_half_written));
  }
  remove_frames_after(folder / "trajectory", -1);
}

void clear_after(const fs::path& folder, long step) {
  remove_file(folder / "summary.json");
  for (const auto& name : own_files()) remove_file(folder / (name + k_half_written));
  remove_frames_after(folder / "trajectory", step);
}

}  // namespace nilas
