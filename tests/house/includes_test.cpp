/// Rules about folders that a file's includes show. The top folders depend on each other in one direction only:
///   apps -> core/output -> core/sim -> fracture -> contact -> core/{bodies, hdf5};
///   core/sim -> {hydro, core/vessel, core/hull, core/field, core/scene}; apps -> core/mesh -> core/geometry ->
///   core/base; python -> nilas -> core/output. Choices and defaults that the scene and the modules share lie in
///   core/choices, above core/base.
/// No two folders at any depth include each other, directly or indirectly, and no folder is crowded.
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <functional>
#include <map>
#include <regex>
#include <set>
#include <string>
#include <vector>

namespace includes_test {

namespace fs = std::filesystem;

using Rooms = std::set<std::string>;

Rooms joined(Rooms rooms, const Rooms& more) {
  rooms.insert(more.begin(), more.end());
  return rooms;
}

/// The folders that each top folder may include besides itself.
const std::map<std::string, Rooms>& allowed() {
  static const Rooms base{"core/base", "core/choices"};
  static const Rooms geometry = joined(base, {"core/geometry"});
  static const Rooms bodies = joined(geometry, {"core/bodies"});
  static const Rooms solving = joined(bodies, {"core/numerics"});
  static const Rooms contact = joined(bodies, {"core/hdf5"});
  static const Rooms fracture = joined(bodies, {"contact"});
  static const Rooms water = joined(solving, {"core/hdf5"});
  static const Rooms sim = joined(
      solving, {"core/scene", "core/hdf5", "contact", "hydro", "fracture", "core/vessel", "core/hull", "core/field"});
  static const Rooms output = joined(sim, {"core/sim"});
  static const Rooms apps = joined(output, {"core/output", "core/mesh"});
  static const std::map<std::string, Rooms> table{{"core/base", {}},       {"core/choices", {"core/base"}},
                                                  {"core/numerics", base}, {"core/hdf5", base},
                                                  {"core/geometry", base}, {"core/bodies", geometry},
                                                  {"core/mesh", bodies},   {"core/scene", bodies},
                                                  {"core/hull", bodies},   {"core/vessel", solving},
                                                  {"core/field", bodies},  {"contact", contact},
                                                  {"hydro", water},        {"fracture", fracture},
                                                  {"core/sim", sim},       {"core/output", output},
                                                  {"apps", apps},          {"nilas", joined(output, {"core/output"})},
                                                  {"python", {"nilas"}}};
  return table;
}

/// The top folder of a path: "core/<x>" or the first folder.
std::string room_of(const std::string& path) {
  const auto first = path.find('/');
  if (first == std::string::npos) return "";
  const std::string top = path.substr(0, first);
  if (top != "core") return top;
  const auto second = path.find('/', first + 1);
  return second == std::string::npos ? "" : path.substr(0, second);
}

std::string folder_of(const std::string& path) { return fs::path(path).parent_path().generic_string(); }

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

const Rooms k_product{"core", "contact", "hydro", "fracture", "apps", "nilas", "python"};

/// Headers and sources below these top folders, relative to the repository.
std::vector<std::string> sources(const Rooms& tops) {
  const fs::path root = NILAS_SOURCE_DIR;
  std::vector<std::string> files;
  for (const std::string& top : tops)
    for (const auto& entry : fs::recursive_directory_iterator(root / top))
      if (entry.path().extension() == ".h" || entry.path().extension() == ".cpp")
        files.push_back(fs::relative(entry.path(), root).generic_string());
  std::sort(files.begin(), files.end());
  return files;
}

/// Whether a file is an adapter to a third-party solver. Adapters are built on request only and may use what those
/// need.
bool is_peer(const std::string& file) { return file.rfind("contact/peers/", 0) == 0; }

/// The folders that the files of each folder include.
std::map<std::string, Rooms> folder_graph() {
  std::map<std::string, Rooms> graph;
  for (const std::string& file : sources(k_product))
    for (const std::string& include : quoted_includes(fs::path(NILAS_SOURCE_DIR) / file))
      if (folder_of(include) != folder_of(file)) graph[folder_of(file)].insert(folder_of(include));
  return graph;
}

/// The folders of a cycle in the order in which they include each other; empty where there is none.
std::vector<std::string> cycle_of(const std::map<std::string, Rooms>& graph) {
  Rooms done;
  std::vector<std::string> path;
  const std::function<bool(const std::string&)> leads_back = [&](const std::string& folder) {
    if (const auto seen = std::find(path.begin(), path.end(), folder); seen != path.end()) {
      path.erase(path.begin(), seen);
      return true;
    }
    if (!done.insert(folder).second) return false;
    path.push_back(folder);
    if (const auto found = graph.find(folder); found != graph.end())
      for (const std::string& next : found->second)
        if (leads_back(next)) return true;
    path.pop_back();
    return false;
  };
  for (const auto& [folder, targets] : graph)
    if (leads_back(folder)) return path;
  return {};
}

TEST(House, IncludesPointOneWay) {
  ASSERT_GT(sources(k_product).size(), 20u);
  for (const std::string& file : sources(k_product)) {
    const std::string room = room_of(file);
    ASSERT_TRUE(allowed().count(room)) << file << " lies in no known room";
    if (is_peer(file)) continue;
    for (const auto& include : quoted_includes(fs::path(NILAS_SOURCE_DIR) / file)) {
      const std::string target = room_of(include);
      EXPECT_TRUE(target == room || allowed().at(room).count(target))
          << file << " includes \"" << include << "\": " << room << " must not depend on " << target;
    }
  }
}

TEST(House, NoFoldersIncludeEachOther) {
  std::string cycle;
  for (const std::string& folder : cycle_of(folder_graph())) cycle += folder + " -> ";
  EXPECT_TRUE(cycle.empty()) << cycle << "...";
}

TEST(House, ACycleOverSeveralFoldersIsFound) {
  EXPECT_EQ(cycle_of({{"a", {"b", "c"}}, {"b", {"c"}}, {"c", {"d"}}}), std::vector<std::string>());
  EXPECT_EQ(cycle_of({{"a", {"b"}}, {"b", {"c"}}, {"c", {"d"}}, {"d", {"b"}}}),
            (std::vector<std::string>{"b", "c", "d"}));
}

TEST(House, NoFolderIsCrowded) {
  constexpr std::size_t k_most = 20;
  // A header and its source count once.
  std::map<std::string, Rooms> stems;
  Rooms tops = k_product;
  tops.insert("tests");
  for (const std::string& file : sources(tops)) stems[folder_of(file)].insert(fs::path(file).stem().string());
  for (const auto& [folder, names] : stems) EXPECT_LE(names.size(), k_most) << folder;
}

TEST(House, OnlyItsRoomsKnowALibrary) {
  const std::vector<std::pair<std::string, Rooms>> owners{
      {"Simbody", {"core/vessel"}},
      {"CGAL/", {"core/geometry", "core/field", "core/mesh", "fracture"}},
      {"fcl/", {"contact"}},
      {"hdf5", {"core/hdf5"}},
      {"tinyxml2", {"core/scene", "core/output", "apps"}},
      {"CLI/", {"apps"}},
      {"kinsol/", {"core/numerics"}},
      {"cvode/", {"core/numerics"}},
      {"nvector/", {"core/numerics"}},
      {"sundials/", {"core/numerics"}}};
  for (const std::string& file : sources(k_product))
    for (const auto& [library, rooms] : owners) {
      const bool included = includes_angle(fs::path(NILAS_SOURCE_DIR) / file, library);
      if (is_peer(file)) continue;
      EXPECT_TRUE(!included || rooms.count(room_of(file)) > 0) << file << " includes " << library;
    }
}

}  // namespace includes_test
