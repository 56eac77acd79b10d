#pragma once
/// Scenes in a folder of their own for one test, and what reading them says.
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

#include "core/base/error.h"
#include "core/scene/read_scene.h"

namespace nilas::testing {

/// A new empty folder that goes away with the object.
class ScratchFolder {
 public:
  ScratchFolder() {
    std::string pattern = (std::filesystem::temp_directory_path() / "nilas-scene-XXXXXX").string();
    path_ = mkdtemp(pattern.data());
  }
  ~ScratchFolder() { std::filesystem::remove_all(path_); }
  ScratchFolder(const ScratchFolder&) = delete;
  ScratchFolder& operator=(const ScratchFolder&) = delete;

  const std::filesystem::path& path() const { return path_; }

  std::filesystem::path write(const std::string& name, const std::string& text) const {
    const auto file = path_ / name;
    std::filesystem::create_directories(file.parent_path());
    // Some file systems wait for the disk when a file is overwritten, not when it is new.
    std::filesystem::remove(file);
    std::ofstream(file, std::ios::binary) << text;
    return file;
  }

  Scene read(const std::string& text, const Overrides& overrides = {}) const {
    return read_scene(write("scene.xml", text), overrides);
  }

  /// The faults of a scene; none when it reads.
  std::vector<Fault> faults(const std::string& text, const Overrides& overrides = {}) const {
    try {
      read(text, overrides);
    } catch (const SceneError& error) {
      return error.faults();
    }
    return {};
  }

 private:
  std::filesystem::path path_;
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
