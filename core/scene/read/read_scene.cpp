#include "core/scene/read/read_scene.h"

#include <algorithm>
#include <tuple>

#include "core/base/file_bytes.h"
#include "core/scene/check/check_document.h"
#include "core/scene/check/cross_checks.h"
#include "core/scene/check/implausible_values.h"
#include "core/scene/document/places.h"
#include "core/scene/read/build_scene.h"
#include "core/scene/read/include_mooring.h"
#include "core/scene/read/input_files.h"
#include "core/scene/read/old_names.h"
#include "core/scene/read/overrides.h"
#include "core/scene/read/resolve.h"
#include "core/scene/read/scale_scene.h"

namespace nilas::scene {

static void drop_byte_order_mark(std::string& text) {
  const std::string byte_order_mark = "\xEF\xBB\xBF";
  if (text.rfind(byte_order_mark, 0) == 0) text.erase(0, byte_order_mark.size());
}

static void check_root_name(SceneElement& root, std::vector<Fault>& faults) {
  if (root.name == "scene") return;
  faults.push_back(fault_of(root, "found <" + root.name + "> as the root; allowed: <scene>"));
  // Continue only if the root is a misspelt <scene>.
  if (nearest_name(root.name, {"scene"}).empty()) throw SceneError(faults);
  root.name = "scene";
}

[[noreturn]] static void throw_sorted(std::vector<Fault> faults) {
  const auto place = [](const Fault& f) { return std::tuple(f.line, f.column); };
  std::stable_sort(faults.begin(), faults.end(), [&](const Fault& a, const Fault& b) { return place(a) < place(b); });
  throw SceneError(std::move(faults));
}

/// Changes a resolved tree to that of the scene as run: the present input files and their hashes replace those that it
/// may have recorded. Returns the files.
static std::vector<InputFile> record_inputs(SceneElement& root) {
  auto inputs = name_by_copies(root);
  std::erase_if(root.children, [](const SceneElement& child) { return child.name == "input"; });
  for (const auto& input : inputs) {
    SceneElement& element = root.children.emplace_back(make_element("input", &root, root.place));
    element.attributes = {{.name = "file", .value = input.copy}, {.name = "sha256", .value = input.sha256}};
  }
  return inputs;
}

static std::string fingerprint(SceneElement root) {
  const auto blank = [&](const char* child, const char* attribute) {
    if (SceneAttribute* found = attribute_of(*child_of(root, child), attribute)) found->value.clear();
  };
  restore_old_names(root);
  blank("time", "end");
  blank("output", "checkpoint_every");
  std::erase_if(child_of(root, "output")->attributes,
                [](const SceneAttribute& a) { return a.name == "statistics" || a.name == "peak_filter"; });
  return text_sha256(write_document(root));
}

Scene read_scene(const std::filesystem::path& file, const Overrides& overrides, double scale) {
  std::error_code ignored;
  if (const std::string moved = moved_scene(file); !moved.empty() && !std::filesystem::exists(file, ignored))
    throw FileError("cannot open scene file " + file.string() + moved);
  return read_scene_text(file_bytes(file, k_most_text_bytes), file, overrides, scale);
}

Scene read_scene_text(std::string text, const std::filesystem::path& file, const Overrides& overrides, double scale) {
  NILAS_DEMAND(scale > 0);
  std::vector<Fault> faults;
  SceneNotes notes;
  drop_byte_order_mark(text);
  SceneElement root = parse_document(text, file.string());
  check_root_name(root, faults);
  include_mooring(root, file, faults);
  apply_overrides(root, overrides, faults);
  std::vector<Fault> warnings = replace_old_names(root);
  check_document(root, faults);
  resolve_defaults(root, file, notes);
  if (scale != 1) scale_scene(root, scale, faults, notes);
  cross_check(root, faults);
  check_files(root, faults);
  if (!faults.empty()) throw_sorted(std::move(faults));
  Scene scene = build_scene(root);
  scene.file = file;
  scene.notes = std::move(notes.said_once);
  scene.derived = std::move(notes.derived);
  scene.warnings = std::move(warnings);
  for (Fault& warning : implausible_values(root)) scene.warnings.push_back(std::move(warning));
  scene.places = places_of(root);
  scene.inputs = record_inputs(root);
  scene.as_run = write_document(root);
  scene.fingerprint = fingerprint(std::move(root));
  return scene;
}

}  // namespace nilas::scene
