/// The house rule of architecture: includes point one way only.
///   apps -> core/output -> core/sim -> {fracture, hydro, contact, core/vessel, core/field} ->
///   core/{bodies,scene,numerics} -> core/base; apps -> core/mesh -> core/bodies
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <map>
#include <regex>
#include <set>
#include <string>
#include <vector>

namespace {

namespace fs = std::filesystem;

const std::map<std::string, std::set<std::string>>& allowed() {
  static const std::set<std::string> base{"core/base"};
  static const std::set<std::string> middle{"core/base", "core/bodies"};
  static const std::set<std::string> solving{"core/base", "core/bodies", "core/numerics"};
  static const std::set<std::string> sim{"core/base", "core/bodies", "core/numerics", "core/scene", "contact",
                                         "hydro",     "fracture",    "core/vessel",   "core/field"};
  static const std::set<std::string> output = [] {
    auto s = sim;
    s.insert("core/sim");
    return s;
  }();
  static const std::set<std::string> apps = [] {
    auto s = output;
    s.insert("core/output");
    s.insert("core/mesh");
    return s;
  }();
  static const std::map<std::string, std::set<std::string>> table{
      {"core/base", {}},     {"core/numerics", base},  {"core/scene", middle},
      {"core/bodies", base}, {"core/vessel", solving}, {"core/field", middle},
      {"contact", middle},   {"hydro", solving},       {"core/mesh", middle},
      {"fracture", middle},  {"core/sim", sim},        {"core/output", output},
      {"apps", apps}};
  return table;
}

/// The room a path belongs to: "core/<x>" or the top folder.
std::string room_of(const std::string& path) {
  const auto first = path.find('/');
  if (first == std::string::npos) return "";
  const std::string top = path.substr(0, first);
  if (top != "core") return top;
  const auto second = path.find('/', first + 1);
  return second == std::string::npos ? "" : path.substr(0, second);
}

std::vector<std::string> quoted_includes(const fs::path& file) {
  static const std::regex pattern(R"re(^\s*#\s*include\s*"([^"]+)")re");
  std::ifstream in(file);
  std::vector<std::string> found;
  for (std::string line; std::getline(in, line);) {
    std::smatch match;
    if (std::regex_search(line, match, pattern)) found.push_back(match[1]);
  }
  return found;
}

bool includes_angle(const fs::path& file, const std::string& start) {
  std::ifstream in(file);
  for (std::string line; std::getline(in, line);)
    if (line.rfind("#include <" + start, 0) == 0 || line.rfind("#include \"" + start, 0) == 0) return true;
  return false;
}

std::vector<fs::path> sources() {
  const fs::path root = NILAS_SOURCE_DIR;
  std::vector<fs::path> files;
  for (const char* top : {"core", "contact", "hydro", "fracture", "apps"}) {
    if (!fs::exists(root / top)) continue;
    for (const auto& entry : fs::recursive_directory_iterator(root / top))
      if (entry.path().extension() == ".h" || entry.path().extension() == ".cpp")
        files.push_back(fs::relative(entry.path(), root));
  }
  return files;
}

/// Adapters to other people's solvers, built on request only: they may use what those need.
bool is_peer(const fs::path& file) { return file.generic_string().rfind("contact/peers/", 0) == 0; }

TEST(House, IncludesPointOneWay) {
  ASSERT_GT(sources().size(), 20u);
  for (const auto& file : sources()) {
    const std::string room = room_of(file.generic_string());
    ASSERT_TRUE(allowed().count(room)) << file << " lies in no known room";
    if (is_peer(file)) continue;
    for (const auto& include : quoted_includes(fs::path(NILAS_SOURCE_DIR) / file)) {
      const std::string target = room_of(include);
      EXPECT_TRUE(target == room || allowed().at(room).count(target))
          << file.string() << " includes \"" << include << "\": " << room << " must not depend on " << target;
    }
  }
}

TEST(House, OnlyVesselKnowsSimbodyAndOnlyItsRoomsKnowTheOtherLibraries) {
  const std::vector<std::pair<std::string, std::set<std::string>>> owners{
      {"Simbody", {"core/vessel"}},    {"CGAL/", {"core/bodies", "core/field", "core/mesh", "fracture"}},
      {"fcl/", {"contact"}},           {"CLI/", {"apps"}},
      {"kinsol/", {"core/numerics"}},  {"cvode/", {"core/numerics"}},
      {"nvector/", {"core/numerics"}}, {"sundials/", {"core/numerics"}}};
  for (const auto& file : sources())
    for (const auto& [library, rooms] : owners) {
      const bool included = includes_angle(fs::path(NILAS_SOURCE_DIR) / file, library);
      if (is_peer(file)) continue;
      EXPECT_TRUE(!included || rooms.count(room_of(file.generic_string())) > 0) << file << " includes " << library;
    }
}

TEST(House, TheContactFolderKnowsNeitherSimbodyNorXml) {
  for (const auto& file : sources()) {
    if (room_of(file.generic_string()) != "contact" || is_peer(file)) continue;
    EXPECT_FALSE(includes_angle(fs::path(NILAS_SOURCE_DIR) / file, "tinyxml2")) << file;
    EXPECT_FALSE(includes_angle(fs::path(NILAS_SOURCE_DIR) / file, "Simbody")) << file;
  }
}

}  // namespace
