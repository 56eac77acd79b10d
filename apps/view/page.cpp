#include "apps/view/page.h"

#include <nlohmann/json.hpp>

#include "apps/view/block_text.h"
#include "apps/view/page_template.h"
#include "core/base/error.h"
#include "core/output/text/html.h"
#include "core/output/text/script_json.h"

namespace nilas::view {

namespace {

/// Browsers handle several texts of this size better than one of ten times the size.
constexpr std::size_t k_block_bytes = k_block_text_bytes << 19;

void replace(std::string& page, std::string_view name, const std::string& text) {
  const auto at = page.find(name);
  NILAS_DEMAND(at != std::string::npos);
  page.replace(at, name.size(), text);
}

std::string filled(const std::string& title, const nlohmann::ordered_json& facts, const std::string& blocks) {
  demand_page();
  std::string page(page_file("page.html"));
  // Blocks first: a title may hold the name of another place.
  replace(page, "@NILAS_BLOCKS@", blocks);
  replace(page, "@NILAS_FACTS@", output::script_json(facts));
  replace(page, "@NILAS_TITLE@", output::html_text(title));
  return page;
}

}  // namespace

void demand_page() {
  if (page_file("page.html").empty())
    throw InputError(
        "this program was built without the page of the viewer, since npm or its packages were not there. Install npm, "
        "remove the build folder and build again. ParaView opens trajectory.pvd of the run folder");
}

std::string live_page(const std::string& title, const std::string& token) {
  return filled(title, {{"title", title}, {"live", true}, {"token", token}}, "");
}

std::string replay_page(const std::string& title, std::string_view bytes) {
  std::string blocks;
  for (std::size_t at = 0, k = 0; at < bytes.size(); at += k_block_bytes, ++k) {
    blocks += "<script type=\"application/octet-stream\" id=\"replay-" + std::to_string(k) + "\">";
    add_block_text(bytes.substr(at, k_block_bytes), blocks);
    blocks += "</script>\n";
  }
  return filled(title, {{"title", title}, {"live", false}}, blocks);
}

std::string report_page(const std::string& title, const std::string& body, const nlohmann::ordered_json& data) {
  demand_page();
  std::string page(page_file("report.html"));
  // From the last place to the first: what stands in one may hold the name of another.
  replace(page, "@NILAS_DATA@", output::script_json(data));
  replace(page, "@NILAS_BODY@", body);
  replace(page, "@NILAS_TITLE@", output::html_text(title));
  return page;
}

}  // namespace nilas::view
