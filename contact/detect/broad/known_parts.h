#pragma once
/// The convex parts of the bodies that a detector knows.
#include <cstdint>
#include <memory>
#include <vector>

#include "contact/detect/broad/part.h"
#include "core/bodies/bodies.h"

namespace nilas::detect {

/// Parts in the order of the bodies; those of one body follow each other.
struct KnownParts {
  std::vector<std::int64_t> ids;  ///< ids of the bodies
  std::vector<std::shared_ptr<const geometry::Shape>> shapes;
  std::vector<double> thickness;  ///< diameter of the largest ball inside a part of each body [m]
  std::vector<Part> parts;
  std::vector<double>
      touching;  ///< distance below which other parts of the same body touch a part, 0 without other parts [m]

  /// Drops the parts of bodies that are gone or have another shape. Returns each part's new index, -1 for one that is
  /// gone; empty where none is gone. Demands that the bodies stand in the order in which they came.
  std::vector<int> forget_gone(const bodies::Bodies& bodies);
  /// Adds the parts of the bodies that follow the known ones.
  void add_new(const bodies::Bodies& bodies);
  /// Returns the range of a body's parts: the first, and the one past the last.
  std::pair<std::vector<Part>::const_iterator, std::vector<Part>::const_iterator> of_body(int body) const;

 private:
  std::vector<int> keep(const std::vector<char>& gone);
};

}  // namespace nilas::detect
