#pragma once
/// Films as MP4 files, by ffmpeg.
#include <filesystem>
#include <optional>
#include <string>

#include "apps/view/pictures/piped_child.h"
#include "apps/view/pictures/scratch_folder.h"

namespace nilas::view {

/// A film (H.264) that grows by pictures of one size. Until finish() the file does not exist or is the old one; where
/// there is no finish(), nothing is left behind.
class Film {
 public:
  /// `ffmpeg`: the program; `fps`: pictures a second. Throws FileError.
  Film(std::filesystem::path file, double fps, const std::filesystem::path& ffmpeg);
  ~Film();
  Film(const Film&) = delete;
  Film& operator=(const Film&) = delete;

  /// Adds a picture, the bytes of a PNG file. Width and height must be even. Throws FileError, Interruption.
  void add(const std::string& png);
  /// Waits for the last picture and gives the file its name. Throws FileError, Interruption.
  void finish();

 private:
  std::filesystem::path file_, part_;
  ScratchFolder folder_;
  std::optional<PipedChild> child_;
};

}  // namespace nilas::view
