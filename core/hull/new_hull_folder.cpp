#include "core/hull/new_hull_folder.h"

#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstring>

#include "core/base/error.h"
#include "core/hull/hull_parts.h"

namespace nilas::hull {

namespace fs = std::filesystem;

namespace {

constexpr const char* k_staging = ".hull.part";  ///< left where the program was killed
constexpr const char* k_faults = "faults.png";   ///< all that a refused mesh leaves
constexpr const char* k_first = "fluid.stl";     ///< a folder without it is no hull

bool is_own(const std::string& name) {
  return name == k_first || name == "hull.json" || name == "hull.png" || name == k_faults || names_part(name);
}

[[noreturn]] void fail(const fs::path& path, const std::string& what, const std::string& reason) {
  throw FileError(path.string() + ": cannot " + what + ": " + reason);
}

void remove_file(const fs::path& file) {
  std::error_code error;
  if (fs::is_directory(fs::symlink_status(file, error))) fail(file, "replace it", "it is a folder");
  fs::remove(file, error);
  if (error) fail(file, "remove the file of an earlier hull", error.message());
}

void move_into(const fs::path& file, const fs::path& folder) {
  std::error_code error;
  fs::rename(file, folder / file.filename(), error);
  if (error) fail(folder / file.filename(), "write it", error.message());
}

void demand_free(const fs::path& folder, bool force) {
  const auto there = paths_in(folder);
  const bool free = std::all_of(there.begin(), there.end(), [](const fs::path& path) {
    return path.filename() == k_staging || path.filename() == k_faults;
  });
  if (!free && !force)
    throw InputError(folder.string() +
                     ": the output folder is not empty; choose another by --out, or give --force to replace an "
                     "earlier hull in it");
  part_files(folder);
}

}  // namespace

NewHullFolder::NewHullFolder(fs::path folder, bool force) : folder_(std::move(folder)), staging_(folder_ / k_staging) {
  std::error_code error;
  made_ = fs::create_directories(folder_, error);
  if (error) fail(folder_, "create the output folder", error.message());
  if (!fs::is_directory(folder_, error)) fail(folder_, "use it as the output folder", "it is not a folder");
  demand_free(folder_, force);
  if (::access(folder_.c_str(), W_OK | X_OK) != 0) fail(folder_, "write into the output folder", std::strerror(errno));
  fs::remove_all(staging_, error);
  fs::create_directory(staging_, error);
  if (error) fail(staging_, "create it", error.message());
}

NewHullFolder::~NewHullFolder() {
  std::error_code ignored;
  fs::remove_all(staging_, ignored);
  if (made_) fs::remove(folder_, ignored);  // fails, as it should, when the folder holds anything
}

bool NewHullFolder::replaces(const fs::path& file) const {
  std::error_code ignored;
  const fs::path beside = file.has_parent_path() ? file.parent_path() : fs::path(".");
  return is_own(file.filename().string()) && fs::equivalent(beside, folder_, ignored);
}

void NewHullFolder::publish() {
  // the first to go and the last to come is what makes the folder a hull
  remove_file(folder_ / k_first);
  for (const auto& path : paths_in(folder_))
    if (is_own(path.filename().string())) remove_file(path);
  for (const auto& path : paths_in(staging_))
    if (is_own(path.filename().string()) && path.filename() != k_first) move_into(path, folder_);
  std::error_code ignored;
  if (fs::exists(staging_ / k_first, ignored)) move_into(staging_ / k_first, folder_);
}

}  // namespace nilas::hull
