#pragma once
/// The convex parts of the bodies that a detector knows.
#include <cstdint>
#include <memory>
#include <vector>

#include "contact/detect/broad/part.h"
#include "core/bodies/bodies.h"

namespace nilas {

/// Parts in the order of the bodies; those of one body follow each other.
struct KnownParts {
  std::vector<std::int64_t> ids;  ///< of the bodies
  std::vector<std::shared_ptr<const Shape>> shapes;
  std::vector<double> thickness;  ///< per body: of the widest of the balls inside its parts [m]
  std::vector<Part> parts;
  std::vector<double> touching;  ///< per part: others of its body nearer than this touch it [m]; 0 where there are none

  /// Drops the parts of bodies that are gone or have another shape; returns each part's new place, -1: gone. Empty
  /// where all are there. Demands that the bodies stand in the order in which they came.
  std::vector<int> forget_gone(const Bodies& bodies);
  /// Adds the parts of the bodies behind the known ones.
  void add_new(const Bodies& bodies);
  /// First and past the last part of a body.
  std::pair<std::vector<Part>::const_iterator, std::vector<Part>::const_iterator> of_body(int body) const;

 private:
  std::vector<int> keep(const std::vector<char>& gone);
};

}  // namespace nilas
