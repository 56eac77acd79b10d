#pragma once
/// Fetches the geometry of parts into the processor's cache before a search reads it. That of a thousand floes does not
/// fit there, and a search would wait for it longer than it computes.
#include <cstddef>

#include "contact/detect/broad/part.h"

namespace nilas::detect {

/// Fetches `count` items from `first` on. Any address may be given.
template <class Item>
void fetch(const Item* first, std::size_t count) {
  constexpr std::size_t k_line = 64;  // [bytes]
  const char* const from = reinterpret_cast<const char*>(first);
  for (std::size_t b = 0; b < count * sizeof(Item); b += k_line) __builtin_prefetch(from + b);
}

/// Fetches the addresses of a part's lists, for a later call of fetch_facets().
inline void fetch_part(const Part& part) {
  if (part.facets) fetch(part.facets.get(), 1);
}

/// Fetches lists with their bounds.
template <class Item>
void fetch(const ItemLists<Item>& lists) {
  fetch(lists.bounds().data(), lists.bounds().size());
  fetch(lists.items().data(), lists.items().size());
}

/// Fetches the vertices of a small polytope and, unless only these are read, its faces and edges.
inline void fetch_facets(const Part& part, bool only_vertices) {
  if (!part.facets || !part.facets->start_vertices.empty()) return;
  const FacetedGeometry& facets = *part.facets;
  fetch(facets.vertices.data(), static_cast<std::size_t>(facets.vertices.size()));
  if (only_vertices) return;
  fetch(facets.offsets.data(), static_cast<std::size_t>(facets.offsets.size()));
  fetch(facets.normals.data(), static_cast<std::size_t>(facets.normals.size()));
  fetch(facets.face_corners);
  fetch(facets.vertex_faces);
  fetch(facets.edges.data(), facets.edges.size());
}

}  // namespace nilas::detect
