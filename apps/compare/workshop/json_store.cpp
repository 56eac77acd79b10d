#include "apps/compare/workshop/json_store.h"

#include <cmath>

#include "core/base/json_text.h"
#include "core/output/file/output_file.h"

namespace nilas::compare {

Json number_or_null(double value) { return std::isfinite(value) ? Json(value) : Json(nullptr); }

std::string json_text(const Json& json) {
  constexpr int k_indent = 2;  // as all other commands
  return json.dump(k_indent, ' ', false, Json::error_handler_t::replace) + "\n";
}

void write_json(const std::filesystem::path& file, const Json& json) {
  output::write_whole(file, json_text(json), output::Flush::now);
}

Json read_json(const std::filesystem::path& file) { return Json::parse(json_file_text(file), nullptr, false); }

}  // namespace nilas::compare
