#pragma once
/// Names of touching features, and 64-bit keys made of them. A name holds numbers of vertices, edges and faces within
/// their parts only, so it lives as long as the features do.
#include <compare>
#include <cstdint>

namespace nilas::detect {

/// The kinds of features that meet at a contact point.
enum class FeatureKind {
  vertex_a,      ///< a vertex of A on B's surface
  vertex_b,      ///< a vertex of B on A's surface
  crossing,      ///< an edge of A crosses an edge of B
  window_sides,  ///< two sides of the clipping window that do not follow each other
  support_sets,  ///< nearest points of whole supporting features, named by one vertex of each
  rim,           ///< rim of a cylinder
  edge,
  face,
  cover,   ///< where the outline of the common area comes out of another part of the same body
  witness  ///< a point that FCL gave
};

struct Feature {
  FeatureKind kind = FeatureKind::vertex_a;
  int first = -1, second = -1;
  friend auto operator<=>(const Feature&, const Feature&) = default;
};

/// Mixes two words by SplitMix64's finaliser [Steele, Lea, Flood 2014].
inline std::uint64_t mix(std::uint64_t seed, std::uint64_t word) {
  std::uint64_t z = seed ^ (word + 0x9e3779b97f4a7c15ULL + (seed << 6) + (seed >> 2));
  z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9ULL;
  z = (z ^ (z >> 27)) * 0x94d049bb133111ebULL;
  return z ^ (z >> 31);
}

/// Returns the contact key of a feature; `pair` identifies the two parts.
inline std::uint64_t contact_key(std::uint64_t pair, const Feature& feature) {
  const auto first = static_cast<std::uint64_t>(static_cast<std::uint32_t>(feature.first));
  const auto second = static_cast<std::uint64_t>(static_cast<std::uint32_t>(feature.second));
  return mix(mix(pair, static_cast<std::uint64_t>(feature.kind)), first << 32 | second);
}

}  // namespace nilas::detect
