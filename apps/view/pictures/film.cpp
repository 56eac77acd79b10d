#include "apps/view/pictures/film.h"

#include <fmt/format.h>

#include "core/base/error.h"

namespace nilas::view {

namespace {

constexpr double k_take_s = 120, k_finish_s = 600;  // limits [s]

/// The unfinished film, in the folder of the film so that it can be renamed.
std::filesystem::path part_of(const std::filesystem::path& file) {
  return file.parent_path() / fmt::format(".{}.part", file.filename().string());
}

std::vector<std::string> ffmpeg_command(const std::filesystem::path& ffmpeg, double fps,
                                        const std::filesystem::path& part) {
  return {ffmpeg.string(), "-hide_banner", "-loglevel", "error", "-y", "-f", "image2pipe", "-c:v", "png", "-framerate",
          fmt::format("{}", fps), "-i", "pipe:0", "-c:v", "libx264", "-crf", "18",
          // What browsers and phones show, with the colours of high definition.
          "-pix_fmt", "yuv420p", "-vf", "scale=out_color_matrix=bt709:out_range=tv", "-colorspace", "bt709",
          "-color_primaries", "bt709", "-color_trc", "bt709", "-movflags", "+faststart",
          // No date and no version: the same pictures give the same file.
          "-map_metadata", "-1", "-fflags", "+bitexact", "-flags:v", "+bitexact", "-f", "mp4", "file:" + part.string()};
}

}  // namespace

Film::Film(std::filesystem::path file, double fps, const std::filesystem::path& ffmpeg)
    : file_(std::filesystem::absolute(file)),
      part_(part_of(file_)),
      child_(std::in_place, ffmpeg_command(ffmpeg, fps, part_), ChildEnds{.reads = 0}, folder_.path() / "ffmpeg.log") {}

Film::~Film() {
  child_.reset();  // first, since it writes the part
  std::error_code error;
  std::filesystem::remove(part_, error);
}

void Film::add(const std::string& png) { child_->write(png, k_take_s); }

void Film::finish() {
  const int code = child_->finish(k_finish_s);
  if (code != 0) throw FileError(fmt::format("ffmpeg ended with code {}. It printed:\n{}", code, child_->last_words()));
  std::filesystem::rename(part_, file_);
}

}  // namespace nilas::view
