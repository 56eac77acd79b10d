#pragma once
/// 64-bit names of touching features. A name is made of ids and the numbers of features only, so it lives as long as the features do.
#include <cstdint>

namespace nilas {

/// SplitMix64's finaliser over both words [Steele, Lea, Flood 2014].
inline std::uint64_t mix(std::uint64_t seed, std::uint64_t word) {
  std::uint64_t z = seed ^ (word + 0x9e3779b97f4a7c15ULL + (seed << 6) + (seed >> 2));
  z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9ULL;
  z = (z ^ (z >> 27)) * 0x94d049bb133111ebULL;
  return z ^ (z >> 31);
}

/// What meets at a contact point.
enum class FeatureKind : std::uint64_t {
  vertex_a = 1,
  vertex_b,
  crossing,      ///< edge of A and edge of B
  support_sets,  ///< nearest points of whole supporting features
  rim,           ///< of a cylinder
  face
};

/// Numbers of vertices, edges or faces within their parts.
inline std::uint64_t feature_tag(FeatureKind kind, std::int64_t first, std::int64_t second = 0) {
  return mix(mix(static_cast<std::uint64_t>(kind), static_cast<std::uint64_t>(first)),
             static_cast<std::uint64_t>(second));
}

}  // namespace nilas
