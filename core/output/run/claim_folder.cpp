#include "core/output/run/claim_folder.h"

#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <ctime>
#include <functional>
#include <optional>
#include <regex>
#include <system_error>
#include <vector>

#include "core/base/error.h"
#include "core/output/run/run_inputs.h"
#include "core/output/tables/problem_files.h"
#include "core/scene/read/input_files.h"

namespace nilas::output {

namespace {

namespace fs = std::filesystem;

/// Ending of a file that is being replaced; such files remain where a run was killed while writing.
constexpr const char* k_half_written = ".part";
constexpr const char* k_log = "nilas.log";

/// All files that a run writes directly into its folder.
const std::vector<std::string>& own_files() {
  static const std::vector<std::string> names{"scene.xml",   "vessel.csv",     "structures.csv", "steps.csv",
                                              "contacts.h5", "trajectory.pvd", "events.csv",     "replay.bin",
                                              "replay.html", "report.html",    "summary.json",   "bodies.csv",
                                              k_log,         "checkpoint.h5",  "parts.csv",      "statistics.bin"};
  return names;
}

/// Step of a trajectory frame, also of a half-written one; 0 for files written only at the start; empty for other
/// files.
std::optional<long> step_of_frame(const std::string& name) {
  static const std::regex pattern(R"(step-(\d{6,18})(-(ice|vessel|bodies|forces))?\.vtp(\.part)?)"),
      standing(R"((water|walls)\.vtp(\.part)?)");
  if (std::regex_match(name, standing)) return 0;
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

/// Removes the files in `folder` whose names are `chosen`.
void remove_where(const fs::path& folder, const std::function<bool(const std::string&)>& chosen) {
  std::error_code error;
  if (!fs::is_directory(fs::symlink_status(folder, error))) return;
  std::vector<fs::path> files;
  for (const auto& entry : fs::directory_iterator(folder, error))
    if (chosen(entry.path().filename().string())) files.push_back(entry.path());
  for (const auto& file : files) remove_file(file);
}

void remove_frames_after(const fs::path& folder, long step) {
  remove_where(folder, [&](const std::string& name) { return step_of_frame(name).value_or(step) > step; });
}

/// Whether a file holds a contact problem to remove: one of a later step than `step`, a half-written one, last.hdf5 or
/// a kept worst one. worst.hdf5 is one of them only where `worst` < 0.
bool is_problem_after(const std::string& name, long step, long worst) {
  static const std::regex pattern(R"((last|worst|worst-\d{8,18}|step-(\d{8,18}))\.hdf5(\.part)?)");
  std::smatch match;
  if (!std::regex_match(name, match, pattern)) return false;
  if (match[3].matched) return true;
  if (match[2].matched) return std::stol(match[2]) > step;
  return worst < 0 || match[1] != "worst";
}

void remove_problems_after(const fs::path& folder, long step, long worst) {
  std::error_code error;
  if (!fs::is_directory(fs::symlink_status(folder, error))) return;
  const fs::path kept = folder / kept_worst_name(worst);
  if (worst >= 0 && fs::exists(kept, error)) {
    fs::rename(kept, folder / "worst.hdf5", error);
    if (error) fail(kept, "rename it to worst.hdf5", error.message());
  }
  remove_where(folder, [&](const std::string& name) { return is_problem_after(name, step, worst); });
  fs::remove(folder, error);  // fails on purpose when the folder is not empty
}

/// Whether a folder holds no more than a run leaves that stopped before its first step: its log, copies of its input
/// files, and half-written files.
bool holds_no_outputs(const fs::path& folder, std::error_code& error) {
  const auto left_over = [&](const std::string& name) {
    const auto& own = own_files();
    return name == k_log ||
           (name == scene::k_input_folder && fs::exists(folder / k_log) && holds_copies_only(folder)) ||
           std::any_of(own.begin(), own.end(), [&](const std::string& file) { return name == file + k_half_written; });
  };
  const fs::directory_iterator entries(folder, error);
  return !error && std::all_of(begin(entries), end(entries),
                               [&](const auto& entry) { return left_over(entry.path().filename().string()); });
}

}  // namespace

std::filesystem::path dated_folder(const std::string& name) {
  const std::time_t now = std::time(nullptr);
  std::tm local{};
  localtime_r(&now, &local);
  char text[32];
  std::strftime(text, sizeof text, "%Y%m%d-%H%M%S", &local);
  return std::filesystem::path("runs") / (name + "-" + text);
}

RunLock claim_run_folder(const fs::path& folder, bool force, const std::vector<scene::InputFile>& inputs) {
  std::error_code error;
  fs::create_directories(folder, error);
  if (error) fail(folder, "create the output folder", error.message());
  if (!fs::is_directory(folder, error)) fail(folder, "use it as the output folder", "it is not a folder");
  const bool empty = holds_no_outputs(folder, error);
  if (error) fail(folder, "read the output folder", error.message());
  if (!empty && !force)
    throw InputError(folder.string() +
                     ": the output folder is not empty; choose another by --out, or give --force to "
                     "replace the outputs of an earlier run in it");
  if (::access(folder.c_str(), W_OK | X_OK) != 0) fail(folder, "write into the output folder", std::strerror(errno));
  demand_room_for_inputs(folder, inputs);
  RunLock lock(folder);
  remove_inputs(folder, inputs);
  for (const auto& name : own_files()) {
    if (name != k_log) remove_file(folder / name);
    remove_file(folder / (name + k_half_written));
  }
  remove_frames_after(folder / "trajectory", -1);
  remove_problems_after(folder / "problems", -1, -1);
  return lock;
}

void claim_folder(const fs::path& folder, bool force) {
  const RunLock lock = claim_run_folder(folder, force);
  remove_file(folder / k_log);
}

void clear_after(const fs::path& folder, long step, long worst_problem) {
  remove_file(folder / "summary.json");
  for (const auto& name : own_files()) remove_file(folder / (name + k_half_written));
  remove_frames_after(folder / "trajectory", step);
  remove_problems_after(folder / "problems", step, worst_problem);
}

}  // namespace nilas::output
