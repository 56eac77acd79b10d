#pragma once
/// Reads the files that comparisons write.
#include <gtest/gtest.h>

#include <map>
#include <nlohmann/json.hpp>
#include <string>

#include "tests/apps/small_scenes.h"
#include "tests/support/program.h"

namespace nilas_test {

inline nlohmann::json json_of(const fs::path& file) { return nlohmann::json::parse(read_text(file)); }

/// Row numbers of a table, such as that of settings.csv, by the text of a column.
inline std::map<std::string, std::size_t> rows_by(const Table& table, const std::string& column) {
  std::map<std::string, std::size_t> rows;
  for (std::size_t k = 0; k < table.rows(); ++k) rows[table.text(column)[k]] = k;
  return rows;
}

inline std::string block(const std::string& more) {
  return "compare '" + shipped_scene("verify/block.xml").string() + "' --out out --force --seeds 1 --quiet " + more;
}

inline void expect_page(const fs::path& folder, const std::string& words) {
  const std::string page = read_text(folder / "compare.html");
  EXPECT_NE(page.find(words), std::string::npos) << page.substr(0, 3000);
  EXPECT_NE(page.find("</html>"), std::string::npos);
}

}  // namespace nilas_test
