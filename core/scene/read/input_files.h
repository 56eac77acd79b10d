#pragma once
/// The files that a scene refers to.
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "core/scene/document/document.h"
#include "core/scene/scene.h"

namespace nilas::scene {

/// Subfolder of a run folder with copies of the input files, and the list in it, in the format of sha256sum.
constexpr const char* k_input_folder = "inputs";
constexpr const char* k_input_sums = "nilas-inputs.sha256";

/// SHA-256 of a file's content in hexadecimal digits. Throws FileError when it cannot be read.
std::string file_sha256(const std::filesystem::path& file);
/// The same of a text.
std::string text_sha256(std::string_view text);

/// Checks on a resolved tree that every named file exists and has the hash that an <input> element recorded.
void check_files(const SceneElement& root, std::vector<Fault>& faults);

/// The files that a resolved tree without faults refers to, in its order, each once; for a hull folder the files that
/// are used. Replaces their names in the tree by those of their copies: relative paths that depend on the files' names
/// alone. A tree read from a run folder is therefore the same.
std::vector<InputFile> name_by_copies(SceneElement& root);

}  // namespace nilas::scene
