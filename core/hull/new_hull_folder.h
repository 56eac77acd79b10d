#pragma once
/// A hull folder in the making.
#include <filesystem>

namespace nilas::hull {

/// Takes a folder for a hull without harming what else is there. What is written into `staging()` takes the place of
/// the earlier hull when published: whoever reads meanwhile, or after a kill, finds the old hull, none, or the new.
class NewHullFolder {
 public:
  /// Makes the folder and its parents. Throws InputError when it holds anything but the picture of a refused mesh,
  /// unless `force`; and where it holds a part-*.stl that is no part-NNNN.stl, which no hull may have beside it. Throws
  /// FileError when it cannot be made or written.
  NewHullFolder(std::filesystem::path folder, bool force);
  /// Removes what was not published, and a folder that was made for nothing.
  ~NewHullFolder();
  NewHullFolder(const NewHullFolder&) = delete;
  NewHullFolder& operator=(const NewHullFolder&) = delete;

  const std::filesystem::path& path() const { return folder_; }
  /// An empty folder within, for fluid.stl, part-NNNN.stl, hull.json, hull.png; or for faults.png alone.
  const std::filesystem::path& staging() const { return staging_; }
  /// Whether publishing removes or replaces the file.
  bool replaces(const std::filesystem::path& file) const;
  /// Removes the files of an earlier hull, or of one refused, and puts the staged ones there. Throws FileError.
  void publish();

 private:
  std::filesystem::path folder_, staging_;
  bool made_ = false;
};

}  // namespace nilas::hull
