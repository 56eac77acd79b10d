#include "apps/compare/workshop/page_text.h"

#include "apps/compare/workshop/templates.h"
#include "core/output/text/fill_template.h"

namespace nilas::compare {

std::string page_text(std::string_view body, nlohmann::ordered_json view) {
  view["style"] = compare_template("page.css");
  std::string text(compare_template("page_head.html"));
  text += compare_template(body);
  return output::fill_template(text, view, output::Escape::html);
}

}  // namespace nilas::compare
