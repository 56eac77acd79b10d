#pragma once
/// A scene: what a run simulates, with every default filled in.
#include <filesystem>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "nilas/export.h"

namespace nilas {

/// A value that replaces one of the scene, as (contact/@tolerance, 1e-8). docs/reference/command-line.md describes
/// --set.
using Setting = std::pair<std::string, std::string>;

class NILAS_API Scene {
 public:
  /// Reads a scene file. Lengths grow by `scale` and all else by Froude's and Cauchy's laws. Throws Error with every
  /// fault, with its line, element and what is allowed.
  static Scene read(const std::filesystem::path& file, const std::vector<Setting>& settings = {}, double scale = 1);
  /// The same from a text. `name`: the name of the text in messages; its paths are relative to the folder of this name.
  static Scene parse(const std::string& xml, const std::filesystem::path& name,
                     const std::vector<Setting>& settings = {}, double scale = 1);

  Scene(const Scene& other);
  Scene(Scene&& other) noexcept;
  Scene& operator=(const Scene& other);
  Scene& operator=(Scene&& other) noexcept;
  ~Scene();

  const std::string& name() const;
  double start() const;                       ///< [s]
  double end() const;                         ///< [s]
  double step() const;                        ///< [s]
  std::string xml() const;                    ///< the scene with every default written out
  std::string fingerprint() const;            ///< SHA-256 of all that the states of a run depend on
  std::vector<std::string> notes() const;     ///< stand-ins and defaults that follow from the scene, as sentences
  std::vector<std::string> warnings() const;  ///< values that are valid but implausible, with their places

  struct Content;
  const Content& content() const { return *content_; }  ///< for the library itself

 private:
  explicit Scene(std::unique_ptr<Content> content);
  std::unique_ptr<Content> content_;
};

}  // namespace nilas
