#pragma once
/// Contact points of one pair of parts, by name.
#include <vector>

#include "contact/detect/broad/contact_key.h"
#include "contact/detect/broad/contact_point.h"
#include "contact/detect/broad/part.h"
#include "contact/detect/surface/point_reduction.h"

namespace nilas::detect {

inline std::uint64_t pair_key(const bodies::Bodies& bodies, const Part& a, const Part& b) {
  std::uint64_t key = mix(0, static_cast<std::uint64_t>(bodies.id[a.body]));
  key = mix(key, static_cast<std::uint64_t>(a.index));
  key = mix(key, static_cast<std::uint64_t>(bodies.id[b.body]));
  return mix(key, static_cast<std::uint64_t>(b.index));
}

inline ContactPoint& add_point(const Part& a, const Part& b, std::vector<ContactPoint>& points) {
  ContactPoint& point = points.emplace_back();
  point.a = a.body;
  point.b = b.body;
  point.part_a = a.index;
  point.part_b = b.index;
  return point;
}

/// Stores in `kept` the features of the first `count` of `points`.
template <class AnyPoint>
void remember(const std::vector<AnyPoint>& points, std::size_t count, std::vector<Feature>& kept) {
  kept.clear();
  if (count < k_spread_points) return;
  for (std::size_t k = 0; k < count; ++k) kept.push_back(points[k].feature);
}

}  // namespace nilas::detect
