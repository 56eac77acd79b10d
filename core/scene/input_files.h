#pragma once
/// The files that a scene refers to.
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "core/scene/document.h"
#include "core/scene/scene.h"

namespace nilas {

/// SHA-256 of a file's content in hexadecimal digits. Throws FileError when it cannot be read.
std::string file_sha256(const std::filesystem::path& file);
/// The same of a text.
std::string text_sha256(std::string_view text);

/// Checks on a resolved tree that every file named exists, and is still the one that an <input> element recorded.
void check_files(const SceneElement& root, std::vector<Fault>& faults);

/// The files that a resolved tree without faults refers to, in its order, each once; of a hull folder those that
/// matter.
std::vector<InputFile> input_files(const SceneElement& root);

}  // namespace nilas
