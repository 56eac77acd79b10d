#pragma once
/// Defaults that follow from the size and speed of a scene's contents: docs/reference/scales.md.
#include <filesystem>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "core/scene/document/document.h"

namespace nilas::scene {

class ScaleDefaults {
 public:
  /// Analyses a scene. `root`: checked, not yet resolved. `folder`: that of the scene file, to which paths are
  /// relative. A hull that cannot be read has no length here; building it reports the fault.
  ScaleDefaults(const SceneElement& root, const std::filesystem::path& folder);

  /// The default of an attribute that follows the scale; empty for others. Remembers that it was taken.
  std::optional<std::string> take(const std::string& element, const std::string& attribute);
  /// The defaults taken, with reasons: "<time step>: 0.05 s is taken, by ..." without the full stop.
  std::vector<std::string> notes() const;

 private:
  void choose_preset(const SceneElement& ice);
  std::optional<std::string> of_ice(const std::string& element, const std::string& attribute) const;

  std::optional<double> length_;  ///< length of the hull [m]
  std::string preset_, preset_reason_;
  double speed_ = 0;  ///< largest speed that the scene names [m/s]
  bool has_ice_ = false, fractures_ = false;
  std::map<std::string, std::string> taken_;  ///< value by "element attribute"
};

}  // namespace nilas::scene
