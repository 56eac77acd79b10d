#include "core/scene/read/input_files.h"

#include <openssl/evp.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <fstream>
#include <map>
#include <memory>
#include <set>

#include "core/base/file_bytes.h"
#include "core/choices/database_files.h"
#include "core/scene/schema/attribute_values.h"
#include "core/scene/schema/schema.h"

namespace nilas::scene {

namespace fs = std::filesystem;

static std::string hexadecimal(const unsigned char* bytes, unsigned count) {
  static constexpr char k_digits[] = "0123456789abcdef";
  std::string text;
  for (unsigned i = 0; i < count; ++i) {
    text += k_digits[bytes[i] >> 4U];
    text += k_digits[bytes[i] & 0xFU];
  }
  return text;
}

namespace {

class Sha256 {
 public:
  Sha256() { NILAS_DEMAND(context_ && EVP_DigestInit_ex(context_.get(), EVP_sha256(), nullptr) == 1); }
  void add(std::string_view bytes) { NILAS_DEMAND(EVP_DigestUpdate(context_.get(), bytes.data(), bytes.size()) == 1); }
  std::string digits() {
    std::array<unsigned char, EVP_MAX_MD_SIZE> digest{};
    unsigned size = 0;
    NILAS_DEMAND(EVP_DigestFinal_ex(context_.get(), digest.data(), &size) == 1);
    return hexadecimal(digest.data(), size);
  }

 private:
  std::unique_ptr<EVP_MD_CTX, void (*)(EVP_MD_CTX*)> context_{EVP_MD_CTX_new(), EVP_MD_CTX_free};
};

}  // namespace

std::string file_sha256(const fs::path& file) {
  std::ifstream in(file, std::ios::binary);
  if (!in) throw FileError("cannot open " + file.string());
  Sha256 hash;
  std::array<char, 1 << 16> buffer{};
  while (in.read(buffer.data(), buffer.size()) || in.gcount() > 0)
    hash.add({buffer.data(), static_cast<std::size_t>(in.gcount())});
  if (in.bad()) throw FileError("cannot read " + file.string());
  return hash.digits();
}

std::string text_sha256(std::string_view text) {
  Sha256 hash;
  hash.add(text);
  return hash.digits();
}

/// Calls for every attribute of the tree that names a file: with element, attribute and type.
template <class Element, class Call>
static void for_each_path(Element& element, const Call& call) {
  const ElementSpec& spec = *find_element(element.name);
  for (auto& attribute : element.attributes) {
    const ValueType type = find_attribute(spec, attribute.name)->type;
    if (attribute.valid && (type == ValueType::path || type == ValueType::hull)) call(element, attribute, type);
  }
  for (auto& child : element.children) for_each_path(child, call);
}

static std::string lower(std::string text) {
  std::transform(text.begin(), text.end(), text.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return text;
}

static bool is_stl(const fs::path& path) { return lower(path.extension().string()) == ".stl"; }

/// The fault of a file that a scene names; an empty message: no fault.
struct FileProblem {
  std::string message;
  bool unreadable = false;
};

/// Checks whether a file exists and can be opened.
static FileProblem readable(const fs::path& path) {
  std::error_code fault;
  const fs::file_status found = fs::status(path, fault);
  if (found.type() == fs::file_type::not_found) return {nothing_there(path, "file").what(), true};
  if (fault) return {path.string() + ": cannot be opened: " + fault.message(), true};
  if (!fs::is_regular_file(found)) return {path.string() + ": is no file", true};
  if (!std::ifstream(path)) return {"file cannot be opened: " + path.string(), true};
  return {};
}

static FileProblem hull_problem(const fs::path& path) {
  std::error_code ignored;
  if (fs::is_directory(path, ignored)) return readable(path / "fluid.stl");
  const FileProblem problem = readable(path);
  if (problem.unreadable || is_stl(path)) return problem;
  return {"found " + path.string() + "; allowed: a hull folder or a file ending in .stl"};
}

static FileProblem file_problem(const fs::path& path) {
  std::error_code ignored;
  if (fs::is_directory(path, ignored)) return {"found a folder: " + path.string() + "; allowed: a file"};
  return readable(path);
}

static void check_unchanged(const SceneElement& input, std::vector<Fault>& faults) {
  const auto recorded = text_of(input, "sha256");
  if (!recorded) return;
  const std::string now = file_sha256(*text_of(input, "file"));
  if (now != *recorded)
    faults.push_back(
        fault_of(input, "sha256", "the file has changed: its SHA-256 is " + now + ", recorded is " + *recorded));
}

void check_files(const SceneElement& root, std::vector<Fault>& faults) {
  for_each_path(root, [&](const SceneElement& element, const SceneAttribute& attribute, ValueType type) {
    const FileProblem problem = type == ValueType::hull ? hull_problem(attribute.value) : file_problem(attribute.value);
    if (!problem.message.empty()) {
      faults.push_back(fault_of(element, attribute.name, problem.message));
      faults.back().unreadable = problem.unreadable;
    } else if (element.name == "input") {
      check_unchanged(element, faults);
    }
  });
}

/// Files of a hull folder that a run reads: fluid.stl, part-*.stl, hull.json, by name.
static std::vector<fs::path> hull_files(const fs::path& path) {
  std::vector<fs::path> files;
  for (const auto& entry : fs::directory_iterator(path)) {
    const std::string name = entry.path().filename().string();
    const bool part = name.rfind("part-", 0) == 0 && entry.path().extension() == ".stl";
    if (part || name == "fluid.stl" || name == "hull.json") files.push_back(entry.path());
  }
  std::sort(files.begin(), files.end());
  return files;
}

namespace {

/// Unique names for copies of files and folders, also on file systems that ignore case.
class CopyNames {
 public:
  /// The name for a path; always the same for the same path, with or without a trailing slash.
  std::string of(const fs::path& written) {
    const fs::path path = written.has_filename() ? written : written.parent_path();
    const auto known = names_.find(path);
    return known != names_.end() ? known->second : names_.emplace(path, free_name(path.filename())).first->second;
  }

 private:
  std::string free_name(const fs::path& last) {
    const std::string stem = portable(last.stem().string()), ending = portable(last.extension().string());
    std::string name = stem + ending;
    for (int k = 2; !taken_.insert(lower(name)).second; ++k) name = stem + "-" + std::to_string(k) + ending;
    return name;
  }

  /// The name with '_' for characters that some file systems refuse.
  static std::string portable(std::string name) {
    const std::string refused = "<>:\"/\\|?*";
    std::replace_if(
        name.begin(), name.end(),
        [&](unsigned char c) {
          return std::iscntrl(c) != 0 || refused.find(static_cast<char>(c)) != std::string::npos;
        },
        '_');
    return name;
  }

  std::map<fs::path, std::string> names_;
  std::set<std::string> taken_{lower(k_input_sums)};
};

}  // namespace

std::vector<InputFile> name_by_copies(SceneElement& root) {
  std::vector<InputFile> inputs;
  CopyNames names;
  const auto add = [&](const fs::path& file, const std::string& copy) {
    const auto same = [&](const InputFile& input) { return input.copy == copy; };
    if (std::none_of(inputs.begin(), inputs.end(), same)) inputs.push_back({file.string(), copy, file_sha256(file)});
  };
  for_each_path(root, [&](const SceneElement& element, SceneAttribute& attribute, ValueType type) {
    if (element.name == "input") return;
    const std::string copy = k_input_folder + ("/" + names.of(attribute.value));
    if (element.name == "database")
      for (const auto& file : database_files(attribute.value))
        add(file, fs::path(copy).replace_extension(file.extension()).string());
    if (type == ValueType::hull && fs::is_directory(attribute.value))
      for (const auto& file : hull_files(attribute.value)) add(file, copy + "/" + file.filename().string());
    else
      add(attribute.value, copy);
    attribute.value = copy;
  });
  return inputs;
}

}  // namespace nilas::scene
