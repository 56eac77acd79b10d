#pragma once
/// The folder of a study. It is taken for a new study or to continue one, and is locked meanwhile.
#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "core/output/run/run_lock.h"

namespace nilas::compare {

/// The files by which a kind of study recognises its folder.
struct StudyFiles {
  std::vector<std::string> marks;  ///< names of files that show a study of the kind; the first is needed to resume it
  /// Whether a study of this kind writes an entry of this name.
  std::function<bool(const std::string& name)> owns;
};

class StudyFolder {
 public:
  /// Takes a folder for a new study. With `force` the folder may hold files: those of an earlier study of the kind are
  /// removed, and no others. Throws InputError if the folder holds anything without `force`, or if it holds no earlier
  /// study but a folder of a name that the study would use, since that may hold someone's runs. Throws FileError, also
  /// if another program uses the folder.
  static StudyFolder claim(std::filesystem::path path, const StudyFiles& files, bool force);
  /// Opens the folder of a study to continue it. Throws FileError if there is no such folder or another program uses
  /// it, and InputError if it holds no such study.
  static StudyFolder open(std::filesystem::path path, const StudyFiles& files);

  /// Removes what a study that could not begin made, and the folder if nothing else is in it.
  void abandon();
  /// Unlocks the folder and removes the file of the lock.
  void release();
  const std::filesystem::path& path() const { return path_; }

 private:
  StudyFolder(std::filesystem::path path, StudyFiles files) : path_(std::move(path)), files_(std::move(files)) {}
  void remove_own() const;

  std::filesystem::path path_;
  StudyFiles files_;
  std::optional<output::RunLock> lock_;
};

}  // namespace nilas::compare
