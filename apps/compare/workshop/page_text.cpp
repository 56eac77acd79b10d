#include "apps/compare/workshop/page_text.h"

#include "apps/compare/workshop/templates.h"
#include "apps/view/page_template.h"
#include "core/output/text/fill_template.h"

namespace nilas::compare {

std::string page_text(std::string_view body, nlohmann::ordered_json data) {
  data["style"] = std::string(view::page_file("theme.css")) + std::string(compare_template("page.css"));
  data["script"] = view::page_file("compare.js");
  std::string text(compare_template("page_head.html"));
  text += compare_template(body);
  return output::fill_template(text, data, output::Escape::html);
}

}  // namespace nilas::compare
