#pragma once
/// Scenes to compare, and what comparisons leave.
#include <gtest/gtest.h>

#include <map>
#include <nlohmann/json.hpp>
#include <string>

#include "tests/support/program.h"

namespace nilas_test {

inline constexpr const char* k_ship = R"(<scene version="1" name="ship">
  <time step="0.01" end="1"/>
  <contact law="coulomb" solver="auto" tolerance="1e-6">
    <friction between="hull ice" static="0.2" kinetic="0.1"/>
    <friction between="ice ice" static="0.3" kinetic="0.3"/>
  </contact>
  <water density="1005"/>
  <hydro><buoyancy/><drag form="1" skin="0.005"/></hydro>
  <vessel name="ship" position="0 0">
    <hull generate="icebreaker" length="3" beam="0.8" draught="0.2" depth="0.4" triangles="300"/>
    <mass draught="0.2"/>
    <carriage speed="0.5" ramp="0.05"/>
  </vessel>
  <ice thickness="0.05">
    <floe name="port" outline="2.9 0.02 3.4 0.02 3.4 0.5 2.9 0.5"/>
    <floe name="starboard" outline="2.95 -0.6 3.4 -0.6 3.4 -0.02 2.95 -0.02"/>
  </ice>
</scene>
)";

inline nlohmann::json json_of(const fs::path& file) { return nlohmann::json::parse(read_text(file)); }

/// Of settings.csv, by label.
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
