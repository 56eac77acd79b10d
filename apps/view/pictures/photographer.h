#pragma once
/// Pictures of the page of a run.
#include <filesystem>
#include <string>
#include <vector>

#include "apps/view/pictures/devtools.h"
#include "apps/view/pictures/scratch_folder.h"

namespace nilas::view {

/// How pictures look.
struct PictureLook {
  int width = 1600, height = 900;  ///< [pixels]
  bool plain = false;              ///< without the bar above and the legend
  std::string camera = "scene";    ///< a view of the page, or "x,y,z,x,y,z": its place and its target [m]
  std::vector<std::string> words;  ///< further words of the page's address, such as "color=force"
};

/// A browser that shows the page of a run and takes pictures of it. All methods throw FileError where the browser
/// fails, and Interruption.
class Photographer {
 public:
  /// `page`: the text of the page.
  Photographer(const std::string& page, const std::filesystem::path& browser, PictureLook look);

  double start() const { return start_; }  ///< time of the first frame [s]
  double end() const { return end_; }      ///< time of the last frame [s]

  /// The bytes of a PNG file that shows the frame at or before `time` [s]. Throws InputError where the page does not
  /// know a word.
  std::string still(double time);
  /// Sets up the camera for a film that begins at `time` [s]. Throws InputError as still() does.
  void begin_film(double time);
  /// The next picture of a film. Between two frames, bodies are on their way from one to the other.
  std::string film_frame(double time);

 private:
  void compose(double time, bool follows);

  PictureLook look_;
  ScratchFolder folder_;
  DevTools tools_;
  double start_ = 0, end_ = 0;
};

}  // namespace nilas::view
