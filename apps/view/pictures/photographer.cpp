#include "apps/view/pictures/photographer.h"

#include <fmt/format.h>

#include "core/base/error.h"
#include "core/output/file/output_file.h"

namespace nilas::view {

namespace {

constexpr double k_read_s = 600, k_draw_s = 120;  // limits [s]

bool is_place(const std::string& camera) { return camera.find(',') != std::string::npos; }

}  // namespace

Photographer::Photographer(const std::string& page, const std::filesystem::path& browser, PictureLook look)
    : look_(std::move(look)), tools_(browser, folder_.path(), look_.width, look_.height) {
  const std::filesystem::path file = folder_.path() / "page.html";
  output::write_whole(file, page);
  tools_.open(file);
  tools_.evaluate("nilas.ready", k_read_s);
  const auto span = tools_.evaluate("nilas.span", k_draw_s);
  start_ = span.at(0).get<double>();
  end_ = span.at(1).get<double>();
}

/// Sets the page up at a time. `follows`: the camera goes along with the vessel, unless the user said otherwise.
void Photographer::compose(double time, bool follows) {
  std::string words = fmt::format("t={}&follow={}", time, follows ? 1 : 0);
  for (const auto& word : look_.words) words += "&" + word;
  words += "&view=" + (is_place(look_.camera) ? "scene&camera=" + look_.camera : look_.camera);
  const auto faults = tools_.evaluate(
      fmt::format("nilas.compose({}, {})", nlohmann::json(words).dump(), look_.plain ? "true" : "false"), k_draw_s);
  std::string text;
  for (const auto& fault : faults) text += (text.empty() ? "" : " ") + fault.get<std::string>();
  if (!text.empty()) throw InputError("--look: " + text);
}

std::string Photographer::still(double time) {
  compose(time, false);
  tools_.evaluate(fmt::format("nilas.shoot({}, false)", time), k_draw_s);
  return tools_.screenshot(false);
}

void Photographer::begin_film(double time) {
  const bool fixed =
      is_place(look_.camera) || (look_.camera == "scene" && tools_.evaluate("nilas.hasView", k_draw_s).get<bool>());
  compose(time, !fixed);
}

std::string Photographer::film_frame(double time) {
  tools_.evaluate(fmt::format("nilas.shoot({}, true)", time), k_draw_s);
  return tools_.screenshot(true);
}

}  // namespace nilas::view
