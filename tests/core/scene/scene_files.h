#pragma once
/// Scenes in a folder that belongs to one test, and the results of reading them.
#include <gtest/gtest.h>

#include <filesystem>
#include <string>
#include <vector>

#include "core/base/error.h"
#include "core/scene/read/read_scene.h"
#include "tests/support/scratch_folder.h"

namespace nilas::testing {

/// A folder of scenes.
class SceneFolder : public test::ScratchFolder {
 public:
  scene::Scene read(const std::string& text, const scene::Overrides& overrides = {}) const {
    return scene::read_scene(write("scene.xml", text), overrides);
  }

  /// The faults of a scene; none when it reads.
  std::vector<Fault> faults(const std::string& text, const scene::Overrides& overrides = {}) const {
    try {
      read(text, overrides);
    } catch (const SceneError& error) {
      return error.faults();
    }
    return {};
  }
};

inline std::string in_scene(const std::string& content) { return "<scene version=\"1\">\n" + content + "\n</scene>\n"; }

/// All of the text of the faults, for messages and searches.
inline std::string text_of(const std::vector<Fault>& faults) {
  std::string text;
  for (const auto& fault : faults) text += fault.text() + "\n";
  return text;
}

/// Demands exactly one fault, at a line, with these words in its place and message.
inline void expect_fault(const std::vector<Fault>& faults, int line, const std::string& where,
                         const std::vector<std::string>& words) {
  ASSERT_EQ(faults.size(), 1u) << text_of(faults);
  EXPECT_EQ(faults[0].line, line) << text_of(faults);
  EXPECT_EQ(faults[0].where, where) << text_of(faults);
  for (const auto& word : words)
    EXPECT_NE(faults[0].message.find(word), std::string::npos) << "'" << word << "' is not in: " << text_of(faults);
}

}  // namespace nilas::testing
