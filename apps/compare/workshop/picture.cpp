#include "apps/compare/workshop/picture.h"

#include "apps/compare/workshop/json_store.h"
#include "apps/compare/workshop/templates.h"
#include "core/output/text/fill_template.h"

namespace nilas::compare {

std::string script_of(const Picture& picture) {
  constexpr double k_font = 12;
  const std::string drawing =
      output::fill_template(compare_template(picture.script), picture.data, output::Escape::gnuplot);
  Json formats = Json::array();
  for (const bool vector : {true, false}) {
    const double factor = vector ? 1 : picture.png_factor;
    formats.push_back({{"terminal", vector ? "svg" : "pngcairo"},
                       {"width", static_cast<int>(factor * picture.width)},
                       {"height", static_cast<int>(factor * picture.height)},
                       {"font", factor * k_font},
                       {"line_width", factor},
                       {"file", picture.name + (vector ? ".svg" : ".png")},
                       {"drawing", drawing}});
  }
  return output::fill_template(compare_template("formats.gnuplot"), {{"formats", formats}}, output::Escape::gnuplot);
}

}  // namespace nilas::compare
