#include "core/base/json_text.h"

#include "core/base/error.h"
#include "core/base/file_bytes.h"

namespace nilas {

bool is_nested_deeply(std::string_view json) {
  constexpr int k_most = 100;
  int depth = 0;
  bool quoted = false;
  for (std::size_t k = 0; k < json.size(); ++k) {
    const char c = json[k];
    if (quoted) {
      if (c == '\\') ++k;
      quoted = c != '"';
    } else if (c == '"') {
      quoted = true;
    } else if (c == '[' || c == '{') {
      if (++depth > k_most) return true;
    } else if (c == ']' || c == '}') {
      --depth;
    }
  }
  return false;
}

std::string json_file_text(const std::filesystem::path& file) {
  std::string text = file_bytes(file, k_most_text_bytes);
  if (is_nested_deeply(text)) throw InputError(file.string() + ": its brackets are nested more than 100 deep");
  return text;
}

}  // namespace nilas
