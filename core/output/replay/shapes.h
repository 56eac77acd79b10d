#pragma once
/// The surfaces of bodies for a replay, each written once.
#include <cstdint>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include "core/bodies/bodies.h"

namespace nilas::output::replay {

class Shapes {
 public:
  explicit Shapes(std::uint64_t first) : next_(first) {}
  /// The number of a body's shape plus 1, or 0 for a plane. Appends a shape that is new to the content of a piece of
  /// shapes: its surface, and for bodies other than floes the convex pieces that meet the ice.
  std::uint64_t number_of(const std::shared_ptr<const geometry::Shape>& shape, bool is_floe, std::string& content);
  /// Forgets shapes that no body has any more.
  void forget_unused();
  /// The number that the next shape gets.
  std::uint64_t next() const { return next_; }

 private:
  std::map<std::shared_ptr<const geometry::Shape>, std::uint64_t> numbers_;
  std::uint64_t next_;
};

}  // namespace nilas::output::replay
