#include "core/output/run/run_inputs.h"

#include <algorithm>
#include <fstream>
#include <set>
#include <string>

#include "core/base/error.h"
#include "core/base/file_bytes.h"
#include "core/output/file/output_file.h"
#include "core/scene/read/input_files.h"

namespace nilas::output {

namespace fs = std::filesystem;

namespace {

/// Ending of a file that is being replaced; such files remain where a run was killed while writing.
constexpr const char* k_half_copied = ".part";

fs::path input_folder(const fs::path& folder) { return folder / scene::k_input_folder; }
fs::path list_file(const fs::path& folder) { return input_folder(folder) / scene::k_input_sums; }

bool is_real_folder(const fs::path& path) {
  std::error_code ignored;
  return fs::is_directory(fs::symlink_status(path, ignored));
}

/// Paths below inputs/ that the list names, without those that links lead elsewhere.
std::set<fs::path> listed(const fs::path& folder) {
  constexpr std::size_t k_digits = 64, k_blanks = 2;
  std::set<fs::path> files;
  std::error_code ignored;
  if (!is_real_folder(input_folder(folder)) || !fs::is_regular_file(fs::symlink_status(list_file(folder), ignored)))
    return files;
  std::ifstream in(list_file(folder));
  for (std::string line; std::getline(in, line);) {
    if (line.size() <= k_digits + k_blanks) continue;
    const fs::path file = line.substr(k_digits + k_blanks);
    const fs::path above = file.parent_path();
    // Copies are files in inputs/ or in a direct subfolder.
    if (file.is_absolute() || file.filename() == ".." || above.has_parent_path() || above == "..") continue;
    if (is_real_folder(input_folder(folder) / above)) files.insert(file);
  }
  return files;
}

/// The path of a copy below inputs/.
fs::path below(const scene::InputFile& input) { return fs::path(input.copy).lexically_relative(scene::k_input_folder); }

bool is_same_file(const fs::path& a, const fs::path& b) {
  std::error_code ignored;
  return fs::equivalent(a, b, ignored);
}

bool is_in_place(const fs::path& folder, const scene::InputFile& input) {
  return is_same_file(input.source, folder / input.copy);
}

void remove_copied_file(const fs::path& path) {
  std::error_code error;
  if (is_real_folder(path)) return;
  fs::remove(path, error);
  if (error) throw FileError(path.string() + ": cannot remove the file of an earlier run: " + error.message());
}

/// Removes an empty folder; on purpose fails silently when it is not empty.
void remove_empty(const fs::path& folder) {
  std::error_code ignored;
  if (is_real_folder(folder)) fs::remove(folder, ignored);
}

void remove_copies(const fs::path& folder, const std::set<fs::path>& copies) {
  std::set<fs::path> folders;
  for (const auto& copy : copies) {
    remove_copied_file(input_folder(folder) / copy);
    remove_copied_file(input_folder(folder) / (copy.string() + k_half_copied));
    if (copy.has_parent_path()) folders.insert(copy.parent_path());
  }
  for (const auto& one : folders) remove_empty(input_folder(folder) / one);
}

void remove_list(const fs::path& folder) {
  remove_copied_file(list_file(folder));
  remove_copied_file(list_file(folder).string() + k_half_copied);
  remove_empty(input_folder(folder));
}

void copy_one(const fs::path& folder, const scene::InputFile& input) {
  const std::string bytes = file_bytes(input.source);
  if (const std::string now = scene::text_sha256(bytes); now != input.sha256)
    throw InputError(input.source + ": the file has changed while the run began: its SHA-256 is " + now +
                     ", that of the scene's " + input.sha256);
  const fs::path copy = folder / input.copy;
  std::error_code error;
  fs::create_directories(copy.parent_path(), error);
  if (error) throw FileError(copy.parent_path().string() + ": cannot create the folder: " + error.message());
  write_whole(copy, bytes, Flush::now);
}

}  // namespace

void demand_room_for_inputs(const fs::path& folder, const std::vector<scene::InputFile>& inputs) {
  const auto copies = listed(folder);
  for (const auto& input : inputs) {
    const fs::path copy = folder / input.copy;
    std::error_code ignored;
    if (!fs::exists(fs::symlink_status(copy, ignored)) || is_in_place(folder, input)) continue;
    const auto reads_it = [&](const scene::InputFile& other) { return is_same_file(other.source, copy); };
    if (std::any_of(inputs.begin(), inputs.end(), reads_it))
      throw InputError(copy.string() + ": the run reads this file, and would replace it by its copy of " +
                       input.source + "; choose another folder by --out");
    if (copies.count(below(input)) == 0)
      throw InputError(copy.string() + ": is in the way of the run's copy of " + input.source +
                       ", and no earlier run made it; remove it, or choose another folder by --out");
  }
}

void remove_inputs(const fs::path& folder, const std::vector<scene::InputFile>& kept) {
  auto copies = listed(folder);
  bool keeps = false;
  for (const auto& input : kept)
    if (is_in_place(folder, input)) keeps = copies.erase(below(input)) > 0 || keeps;
  remove_copies(folder, copies);
  if (!keeps && is_real_folder(input_folder(folder))) remove_list(folder);
}

bool holds_copies_only(const fs::path& folder) {
  const fs::path inputs = input_folder(folder);
  if (!is_real_folder(inputs)) return true;
  const auto copies = listed(folder);
  std::error_code error;
  for (fs::recursive_directory_iterator entry(inputs, error), end; !error && entry != end; entry.increment(error)) {
    if (is_real_folder(entry->path())) continue;
    fs::path name = entry->path().lexically_relative(inputs);
    if (name.extension() == k_half_copied) name.replace_extension();
    if (name != scene::k_input_sums && copies.count(name) == 0) return false;
  }
  return !error;
}

void copy_inputs(const fs::path& folder, const std::vector<scene::InputFile>& inputs) {
  if (inputs.empty()) return;
  std::string list;
  std::vector<const scene::InputFile*> missing;
  for (const auto& input : inputs) {
    list += input.sha256 + "  " + below(input).string() + "\n";
    if (!is_in_place(folder, input)) missing.push_back(&input);
  }
  std::error_code error;
  fs::create_directories(input_folder(folder), error);
  if (error) throw FileError(input_folder(folder).string() + ": cannot create the folder: " + error.message());
  std::set<fs::path> copies;
  try {
    // first, so that files left by a killed run are recognised as its copies
    write_whole(list_file(folder), list, Flush::now);
    for (const scene::InputFile* input : missing) {
      copies.insert(below(*input));
      copy_one(folder, *input);
    }
  } catch (...) {
    remove_copies(folder, copies);
    if (missing.size() == inputs.size()) remove_list(folder);
    throw;
  }
}

}  // namespace nilas::output
