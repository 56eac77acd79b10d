#pragma once
/// Names of touching features, and 64-bit keys made of them. A name holds numbers of vertices, edges and faces within
/// their parts only, so it lives as long as the features do.
#include <compare>
#include <cstdint>

namespace nilas {

/// What meets at a contact point.
enum class FeatureKind {
  vertex_a,      ///< a vertex of A on B's surface
  vertex_b,      ///< a vertex of B on A's surface
  crossing,      ///< edge of A, edge of B
  window_sides,  ///< two sides of the window that do not follow each other
  support_sets,  ///< nearest points of whole supporting features, by one vertex of each
  rim,           ///< of a cylinder
  edge,
  face,
  cover,   ///< the outline of the common area, where it comes out of another part of the same body
  witness  ///< a point that FCL gave
};

struct Feature {
  FeatureKind kind = FeatureKind::vertex_a;
  int first = -1, second = -1;
  friend auto operator<=>(const Feature&, const Feature&) = default;
};

/// SplitMix64's finaliser over both words [Steele, Lea, Flood 2014].
inline std::uint64_t mix(std::uint64_t seed, std::uint64_t word) {
  std::uint64_t z = seed ^ (word + 0x9e3779b97f4a7c15ULL + (seed << 6) + (seed >> 2));
  z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9ULL;
  z = (z ^ (z >> 27)) * 0x94d049bb133111ebULL;
  return z ^ (z >> 31);
}

/// `pair` names two parts.
inline std::uint64_t contact_key(std::uint64_t pair, const Feature& feature) {
  const auto first = static_cast<std::uint64_t>(static_cast<std::uint32_t>(feature.first));
  const auto second = static_cast<std::uint64_t>(static_cast<std::uint32_t>(feature.second));
  return mix(mix(pair, static_cast<std::uint64_t>(feature.kind)), first << 32 | second);
}

}  // namespace nilas
