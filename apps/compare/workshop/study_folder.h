#pragma once
/// The folder of a study: taken for a new one or for the rest of one, and locked meanwhile.
#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "core/output/run/run_lock.h"

namespace nilas {

/// How a study knows its folder.
struct StudyFiles {
  std::vector<std::string> marks;  ///< files by which a study of the kind is known, the one that going on needs first
  /// Whether a study of this kind writes an entry of this name.
  std::function<bool(const std::string& name)> owns;
};

class StudyFolder {
 public:
  /// Takes a folder for a new study; one that holds anything is refused (InputError) unless `force`. With it, what an
  /// earlier study of the kind wrote there is removed and nothing else; where there was none, a folder of a name
  /// that the study would use is refused, too: it may be someone's runs. Throws FileError, also where another program
  /// is at work in it.
  static StudyFolder claim(std::filesystem::path path, const StudyFiles& files, bool force);
  /// Opens the folder of a study to go on. Throws FileError where it is not there or another program is at work in it,
  /// InputError where it holds no such study.
  static StudyFolder open(std::filesystem::path path, const StudyFiles& files);

  /// For a study that could not begin: removes what it made, and the folder when nothing else is in it.
  void abandon();
  /// Frees the folder and removes the lock's file.
  void release();
  const std::filesystem::path& path() const { return path_; }

 private:
  StudyFolder(std::filesystem::path path, StudyFiles files) : path_(std::move(path)), files_(std::move(files)) {}
  void remove_own() const;

  std::filesystem::path path_;
  StudyFiles files_;
  std::optional<RunLock> lock_;
};

}  // namespace nilas
