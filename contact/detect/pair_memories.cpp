#include "contact/detect/pair_memories.h"

#include <algorithm>
#include <numeric>

namespace nilas::detect {

namespace {

/// Returns whether the parts have the features that made the axis.
bool is_of(const RememberedAxis& axis, const Part& a, const Part& b) {
  const auto has = [](const auto& features, int i) { return i >= 0 && static_cast<std::size_t>(i) < features.size(); };
  switch (axis.kind) {
    case AxisKind::face_a:
      return a.facets && has(a.facets->polytope->faces, axis.feature_a);
    case AxisKind::face_b:
      return b.facets && has(b.facets->polytope->faces, axis.feature_b);
    case AxisKind::edges:
      return a.facets && b.facets && has(a.facets->edges, axis.feature_a) && has(b.facets->edges, axis.feature_b);
    case AxisKind::unnamed:
    case AxisKind::direction:
      return true;
  }
  return false;
}

}  // namespace

void PairMemories::forget_gone(const std::vector<int>& new_part, const std::vector<Part>& parts) {
  std::vector<PartPair> pairs_kept;
  std::vector<PairMemory> memory_kept;
  for (std::size_t i = 0; i < pairs.size(); ++i) {
    const int a = new_part[pairs[i].part_a], b = new_part[pairs[i].part_b];
    if (a < 0 || b < 0) continue;
    pairs_kept.push_back({parts[a].body, parts[b].body, a, b});
    memory_kept.push_back(std::move(memory[i]));
  }
  pairs.swap(pairs_kept);
  memory.swap(memory_kept);
}

void PairMemories::save(StateWriter out) const {
  std::vector<int> names, axes, kept_counts, kept;
  std::vector<Vec3> separating;
  for (std::size_t i = 0; i < pairs.size(); ++i) {
    names.insert(names.end(), {pairs[i].part_a, pairs[i].part_b});
    const RememberedAxis& axis = memory[i].contact_axis;
    axes.insert(axes.end(), {static_cast<int>(axis.kind), axis.feature_a, axis.feature_b});
    separating.push_back(memory[i].separating);
    kept_counts.push_back(static_cast<int>(memory[i].kept.size()));
    for (const Feature& f : memory[i].kept) kept.insert(kept.end(), {static_cast<int>(f.kind), f.first, f.second});
  }
  out.add("parts", names);
  out.add("contact_axis", axes);
  out.add("separating", separating);
  out.add("kept_counts", kept_counts);
  out.add("kept", kept);
}

void PairMemories::restore(const std::vector<Part>& parts, const StateReader& in) {
  std::vector<int> names, axes, kept_counts, kept;
  std::vector<Vec3> separating;
  in.get("separating", separating);
  const std::size_t count = separating.size();
  in.get("parts", names, 2 * count);
  in.get("contact_axis", axes, 3 * count);
  in.get("kept_counts", kept_counts, count);
  const auto is_wrong = [](int n) { return n < 0 || n > static_cast<int>(k_most_points); };
  if (std::any_of(kept_counts.begin(), kept_counts.end(), is_wrong)) in.refuse("kept_counts", "is out of range");
  constexpr std::size_t k_kept_numbers = 3;
  in.get("kept", kept, k_kept_numbers * std::accumulate(kept_counts.begin(), kept_counts.end(), std::size_t{0}));
  const int* number = kept.data();
  pairs.clear();
  memory.clear();
  for (std::size_t i = 0; i < count; ++i) {
    const int a = names[2 * i], b = names[2 * i + 1];
    const auto known = [&](int part) { return part >= 0 && static_cast<std::size_t>(part) < parts.size(); };
    if (!known(a) || !known(b)) in.refuse("parts", "names a part that this scene does not have");
    const RememberedAxis axis{static_cast<AxisKind>(axes[3 * i]), axes[3 * i + 1], axes[3 * i + 2]};
    if (!is_of(axis, parts[a], parts[b])) in.refuse("contact_axis", "names a feature that its parts do not have");
    pairs.push_back({parts[a].body, parts[b].body, a, b});
    PairMemory& last = memory.emplace_back();
    last.separating = separating[i];
    last.contact_axis = axis;
    for (int k = 0; k < kept_counts[i]; ++k, number += k_kept_numbers)
      last.kept.push_back({static_cast<FeatureKind>(number[0]), number[1], number[2]});
  }
}

}  // namespace nilas::detect
