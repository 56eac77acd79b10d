/// No switch over an enumeration of core/choices has a default. A default would silently take a choice that is added
/// later, where the compiler should refuse it (-Wswitch).
#include <gtest/gtest.h>

#include <filesystem>
#include <regex>
#include <set>
#include <string>
#include <vector>

#include "tests/support/file_text.h"

namespace choices_test {

namespace fs = std::filesystem;

std::vector<std::string> matches(const std::string& text, const std::regex& pattern) {
  std::vector<std::string> all;
  for (std::sregex_iterator match(text.begin(), text.end(), pattern), end; match != end; ++match)
    all.push_back((*match)[1]);
  return all;
}

std::set<std::string> choice_enumerations() {
  static const std::regex k_function(R"(constexpr ChoiceText choice_text\((\w+) value\))");
  std::set<std::string> names;
  for (const auto& entry : fs::directory_iterator(fs::path(NILAS_SOURCE_DIR) / "core/choices"))
    for (const std::string& name : matches(nilas::test::read_text(entry.path()), k_function)) names.insert(name);
  return names;
}

/// The enumerations of the cases before each default, searched back to its switch.
std::vector<std::string> enumerations_with_default(const std::string& text) {
  static const std::regex k_case(R"(case (?:\w+::)*(\w+)::)");
  std::vector<std::string> names;
  for (auto at = text.find("default:"); at != std::string::npos; at = text.find("default:", at + 1)) {
    const auto from = text.rfind("switch (", at);
    if (from == std::string::npos) continue;
    for (const std::string& name : matches(text.substr(from, at - from), k_case)) names.push_back(name);
  }
  return names;
}

TEST(Choices, NoSwitchOverThemHasADefault) {
  const auto lists = choice_enumerations();
  EXPECT_GT(lists.size(), 20u);
  for (const char* top : {"core", "contact", "hydro", "fracture", "apps"})
    for (const auto& entry : fs::recursive_directory_iterator(fs::path(NILAS_SOURCE_DIR) / top)) {
      if (entry.path().extension() != ".cpp" && entry.path().extension() != ".h") continue;
      for (const std::string& name : enumerations_with_default(nilas::test::read_text(entry.path())))
        EXPECT_EQ(lists.count(name), 0u) << entry.path() << ": a default in a switch over " << name;
    }
}

TEST(Choices, ADefaultWouldBeSeen) {
  EXPECT_EQ(enumerations_with_default("switch (x) { case Law::ccp: return 1; default: return 2; }"),
            std::vector<std::string>{"Law"});
}

}  // namespace choices_test
