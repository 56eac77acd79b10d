#include "apps/compare/workshop/study_folder.h"

#include <fmt/format.h>

#include <algorithm>
#include <vector>

#include "core/base/error.h"

namespace nilas::compare {

namespace fs = std::filesystem;

static std::vector<fs::path> entries(const fs::path& folder) {
  std::error_code error;
  std::vector<fs::path> all;
  if (!fs::exists(folder, error)) return all;
  for (const auto& entry : fs::directory_iterator(folder, error)) all.push_back(entry.path());
  if (error) throw FileError(folder.string() + ": " + error.message());
  return all;
}

StudyFolder StudyFolder::claim(fs::path path, const StudyFiles& files, bool force) {
  StudyFolder folder(std::move(path), files);
  const auto found = entries(folder.path_);
  if (!found.empty() && !force)
    throw InputError(folder.path_.string() + " is not empty; name another folder, or give --force to write there");
  const bool earlier = std::any_of(files.marks.begin(), files.marks.end(),
                                   [&](const std::string& mark) { return fs::exists(folder.path_ / mark); });
  for (const auto& entry : found)
    if (!earlier && fs::is_directory(entry) && files.owns(entry.filename().string()))
      throw InputError(fmt::format("{} holds a folder {} that no comparison wrote; name another folder",
                                   folder.path_.string(), entry.filename().string()));
  std::error_code error;
  fs::create_directories(folder.path_, error);
  if (error) throw FileError(folder.path_.string() + ": " + error.message());
  folder.lock_.emplace(folder.path_);
  if (earlier) folder.remove_own();
  return folder;
}

StudyFolder StudyFolder::open(fs::path path, const StudyFiles& files) {
  if (!fs::is_directory(path)) throw FileError("--resume: there is no folder " + path.string());
  if (!fs::exists(path / files.marks.front()))
    throw InputError("--resume: " + path.string() + " holds no comparison (it has no " + files.marks.front() + ")");
  StudyFolder folder(std::move(path), files);
  folder.lock_.emplace(folder.path_);
  return folder;
}

void StudyFolder::remove_own() const {
  std::error_code ignored;
  for (const auto& entry : entries(path_))
    if (files_.owns(entry.filename().string())) fs::remove_all(entry, ignored);
}

void StudyFolder::abandon() {
  remove_own();
  release();
  std::error_code ignored;
  fs::remove(path_, ignored);  // where nothing else is in it
}

void StudyFolder::release() {
  lock_.reset();
  std::error_code ignored;
  fs::remove(path_ / "nilas.log", ignored);
}

}  // namespace nilas::compare
