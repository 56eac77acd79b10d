#pragma once
/// The files that a scene refers to.
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "core/scene/document/document.h"
#include "core/scene/scene.h"

namespace nilas {

/// In a run folder: where its input files are copied to, and the list of them there, as sha256sum writes it.
constexpr const char* k_input_folder = "inputs";
constexpr const char* k_input_sums = "nilas-inputs.sha256";

/// SHA-256 of a file's content in hexadecimal digits. Throws FileError when it cannot be read.
std::string file_sha256(const std::filesystem::path& file);
/// The same of a text.
std::string text_sha256(std::string_view text);

/// Checks on a resolved tree that every file named exists, and is still the one that an <input> element recorded.
void check_files(const SceneElement& root, std::vector<Fault>& faults);

/// The files that a resolved tree without faults refers to, in its order, each once; of a hull folder those that
/// matter. In the tree they are then named by their copies: relative paths that depend on the files' own names alone,
/// so that a tree that is read from a run folder comes out the same.
std::vector<InputFile> name_by_copies(SceneElement& root);

}  // namespace nilas
