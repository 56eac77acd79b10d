#include "contact/detect/detector.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <numeric>

#include "contact/detect/broad_phase.h"
#include "contact/detect/fcl_query.h"
#include "contact/detect/narrow_phase.h"
#include "contact/detect/reach.h"
#include "contact/detect/seam_points.h"
#include "core/base/error.h"
#include "core/base/parallel.h"

namespace nilas {

namespace {

/// Stretches of the pair list per thread, so that a stretch with many hull contacts does not keep the others waiting.
constexpr std::ptrdiff_t k_stretches_per_thread = 8;

/// What one stretch of the pair list works with and finds, in cache lines of its own.
struct alignas(64) Stretch {
  AxisSearchRoom room;
  std::vector<ContactPoint> points;
  DetectorCounts counts;

  void count(const PairContacts& contacts) {
    counts.cached_separations += contacts.separated_by_memory ? 1 : 0;
    counts.kept_axes += contacts.search.kept;
    counts.fcl_queries += contacts.search.fcl_queries;
    counts.fallbacks += contacts.search.fallbacks;
  }
};

/// Where a pair's points stand.
struct FoundPoints {
  int stretch = 0, count = 0;
  std::ptrdiff_t first = 0;
  double left_depth = 0;  ///< see PairContacts
};

/// Whether the parts have the features that made the axis.
bool is_of(const RememberedAxis& axis, const Part& a, const Part& b) {
  const auto has = [](const auto& features, int i) { return i >= 0 && static_cast<std::size_t>(i) < features.size(); };
  switch (axis.kind) {
    case AxisKind::face_a:
      return a.facets && has(a.facets->polytope->faces, axis.feature_a);
    case AxisKind::face_b:
      return b.facets && has(b.facets->polytope->faces, axis.feature_b);
    case AxisKind::edges:
      return a.facets && b.facets && has(a.facets->edges, axis.feature_a) && has(b.facets->edges, axis.feature_b);
    case AxisKind::direction:
      return true;
  }
  return false;
}

/// Two parts of a fast pair of bodies.
struct PartsOnTheirWay {
  const Part* a = nullptr;
  const Part* b = nullptr;
  double width = 0, way = 0;
};

/// No point of the one goes as far as the balls around both are apart.
bool stay_apart(const Bodies& bodies, const PartsOnTheirWay& pair) {
  const auto centre = [&](const Part& part) -> Vec3 {
    return bodies.p_GB[part.body] + bodies.R_GB[part.body] * part.centre;
  };
  const double radii = pair.a->bounding_radius + pair.b->bounding_radius;
  return (centre(*pair.b) - centre(*pair.a)).norm() - radii > pair.way;
}

/// A search among numbers that are none need not end.
void demand_finite(const Bodies& bodies) {
  for (std::size_t b = 0; b < bodies.id.size(); ++b)
    NILAS_DEMAND(bodies.p_GB[b].allFinite() && bodies.R_GB[b].allFinite());
}

struct BodyOrder {
  bool operator()(const Part& part, int body) const { return part.body < body; }
  bool operator()(int body, const Part& part) const { return body < part.body; }
};

}  // namespace

struct ContactDetector::Implementation {
  int threads = 1;
  std::vector<std::int64_t> ids;  ///< bodies whose parts are known
  std::vector<std::shared_ptr<const Shape>> shapes;
  std::vector<Part> parts;
  std::vector<double> thickness;  ///< per body: of the widest of the balls inside its parts [m]
  std::vector<double> touching;  ///< per part: others of its body nearer than this touch it [m]; 0 where there are none
  BroadPhase broad;
  FclShapes fcl;
  std::vector<PartPair> pairs, last_pairs;
  std::vector<PairMemory> memory, last_memory;
  std::vector<std::ptrdiff_t> last_starts;  ///< where the last pairs of each first body begin
  std::vector<int> order;                   ///< in which the pairs are searched
  std::vector<Stretch> stretches;
  std::vector<FoundPoints> found;
  DetectorCounts counts;

  void forget_all();
  void forget_gone(const Bodies& bodies);
  std::vector<int> keep_parts(const std::vector<char>& gone);
  void learn_bodies(const Bodies& bodies);
  void index_last_pairs();
  /// Moves out what the pair had at the last call, if it was there.
  PairMemory take_remembered(const PartPair& pair);
  void list_pairs(const Bodies& bodies, double margin);
  void search_pairs(const Bodies& bodies, const std::vector<double>& margins);
  void add_up_counts();
  bool is_deep(std::size_t i) const;
  void find_deep(const Bodies& bodies, std::size_t first, std::size_t last, double margin,
                 std::vector<ContactPoint>& points);
  std::vector<ContactPoint> collect(const Bodies& bodies, const std::vector<double>& margins);
  std::vector<PartsOnTheirWay> parts_of(const Bodies& bodies, const std::vector<FastPair>& fast) const;
  void save_pairs(StateWriter out) const;
  void restore_pairs(const StateReader& in);
};

void ContactDetector::Implementation::forget_all() {
  const int kept = threads;
  *this = {};
  threads = kept;
}

/// Parts of bodies that are not gone; returns each part's new place, -1: gone.
std::vector<int> ContactDetector::Implementation::keep_parts(const std::vector<char>& gone) {
  std::vector<int> new_body, new_part;
  int bodies_kept = 0, parts_kept = 0;
  for (const char body : gone) new_body.push_back(body ? -1 : bodies_kept++);
  std::vector<char> gone_parts;
  for (Part& part : parts) {
    gone_parts.push_back(gone[part.body]);
    new_part.push_back(gone[part.body] ? -1 : parts_kept++);
    part.body = new_body[part.body];
  }
  remove_marked(gone_parts, parts);
  remove_marked(gone_parts, touching);
  remove_marked(gone, ids);
  remove_marked(gone, shapes);
  remove_marked(gone, thickness);
  return new_part;
}

/// The tree is made anew, as it is for the new bodies.
void ContactDetector::Implementation::forget_gone(const Bodies& bodies) {
  std::vector<char> gone;
  std::size_t kept = 0;
  for (std::size_t b = 0; b < ids.size(); ++b) {
    const bool is_there = kept < bodies.id.size() && bodies.id[kept] == ids[b] && bodies.shape[kept] == shapes[b];
    gone.push_back(is_there ? 0 : 1);
    kept += is_there ? 1 : 0;
  }
  if (kept == ids.size()) return;
  const std::vector<int> new_part = keep_parts(gone);
  broad = BroadPhase();
  fcl = FclShapes();
  std::vector<PartPair> pairs_kept;
  std::vector<PairMemory> memory_kept;
  for (std::size_t i = 0; i < pairs.size(); ++i) {
    const int a = new_part[pairs[i].part_a], b = new_part[pairs[i].part_b];
    if (a < 0 || b < 0) continue;
    pairs_kept.push_back({parts[a].body, parts[b].body, a, b});
    memory_kept.push_back(memory[i]);
  }
  pairs.swap(pairs_kept);
  memory.swap(memory_kept);
}

void ContactDetector::Implementation::learn_bodies(const Bodies& bodies) {
  demand_finite(bodies);
  forget_gone(bodies);
  for (std::size_t b = ids.size(); b < bodies.id.size(); ++b) {
    ids.push_back(bodies.id[b]);
    shapes.push_back(bodies.shape[b]);
    thickness.push_back(0);
    for (Part& part : make_parts(bodies, static_cast<int>(b))) {
      touching.push_back(part.cover ? part.cover->tolerance : 0);
      thickness.back() = std::max(thickness.back(), 2 * part.inner_radius);
      parts.push_back(std::move(part));
    }
  }
}

PairMemory ContactDetector::Implementation::take_remembered(const PartPair& pair) {
  const auto begin = last_pairs.begin() + last_starts[pair.body_a],
             end = last_pairs.begin() + last_starts[pair.body_a + 1];
  const auto last = std::lower_bound(begin, end, pair);
  return last != end && *last == pair ? std::move(last_memory[last - last_pairs.begin()]) : PairMemory{};
}

void ContactDetector::Implementation::index_last_pairs() {
  last_starts.assign(ids.size() + 1, 0);
  for (const PartPair& pair : last_pairs) ++last_starts[pair.body_a + 1];
  std::partial_sum(last_starts.begin(), last_starts.end(), last_starts.begin());
}

void ContactDetector::Implementation::list_pairs(const Bodies& bodies, double margin) {
  learn_bodies(bodies);
  last_pairs.swap(pairs);
  last_memory.swap(memory);
  broad.list_pairs(bodies, parts, margin, threads, pairs, order);
  index_last_pairs();
  memory.resize(pairs.size());
}

void ContactDetector::Implementation::search_pairs(const Bodies& bodies, const std::vector<double>& margins) {
  const auto count = static_cast<std::ptrdiff_t>(pairs.size());
  const std::ptrdiff_t wanted = threads > 1 ? threads * k_stretches_per_thread : 1;
  stretches.resize(static_cast<std::size_t>(wanted));
  found.resize(pairs.size());
  parallel_pieces(wanted, threads, [&](std::ptrdiff_t s) {
    Stretch& stretch = stretches[s];
    stretch.points.clear();
    stretch.counts = {};
    for (std::ptrdiff_t k = s * count / wanted; k < (s + 1) * count / wanted; ++k) {
      const int i = order[k];
      memory[i] = take_remembered(pairs[i]);
      const auto first = static_cast<std::ptrdiff_t>(stretch.points.size());
      const PairContacts contacts = find_pair_contacts(bodies, parts[pairs[i].part_a], parts[pairs[i].part_b],
                                                       margins[i], fcl, stretch.room, memory[i], stretch.points);
      found[i] = {static_cast<int>(s), contacts.count, first, contacts.left_depth};
      stretch.count(contacts);
    }
  });
}

void ContactDetector::Implementation::add_up_counts() {
  counts = {};
  counts.candidate_pairs = static_cast<long>(pairs.size());
  for (const Stretch& stretch : stretches) {
    counts.cached_separations += stretch.counts.cached_separations;
    counts.kept_axes += stretch.counts.kept_axes;
    counts.fcl_queries += stretch.counts.fcl_queries;
    counts.fallbacks += stretch.counts.fallbacks;
  }
}

/// Whether the parts of a pair, whose contact is for other parts, are so far in each other that those may not have it
/// either. Near the end of a seam parts overlap a little along it without being in each other's way.
bool ContactDetector::Implementation::is_deep(std::size_t i) const {
  constexpr double k_deep_share = 0.25;  // of the thinner body
  return found[i].left_depth > k_deep_share * std::min(thickness[pairs[i].body_a], thickness[pairs[i].body_b]);
}

/// Of two bodies so deep in each other that each of their pairs of parts, [first, last), leaves the contact to another:
/// the shallowest way out of one pair, and what the others have along it.
void ContactDetector::Implementation::find_deep(const Bodies& bodies, std::size_t first, std::size_t last,
                                                double margin, std::vector<ContactPoint>& points) {
  AxisSearchRoom room;
  std::vector<ContactPoint> deep;
  for (std::size_t i = first; i < last; ++i) {
    PairMemory none;
    if (is_deep(i))
      find_pair_contacts(bodies, parts[pairs[i].part_a], parts[pairs[i].part_b], margin, fcl, room, none, deep, true);
  }
  double shallowest = -std::numeric_limits<double>::infinity();
  Vec3 n = Vec3::Zero();
  for (std::size_t i = 0; i < deep.size();) {
    double deepest = 0;
    const Vec3& of_pair = deep[i].n;
    const int part_a = deep[i].part_a, part_b = deep[i].part_b;
    for (; i < deep.size() && deep[i].part_a == part_a && deep[i].part_b == part_b; ++i)
      deepest = std::min(deepest, deep[i].gap);
    if (deepest <= shallowest) continue;
    shallowest = deepest;
    n = of_pair;
  }
  std::erase_if(deep, [&](const ContactPoint& c) { return c.n.dot(n) <= 0; });
  points.insert(points.end(), deep.begin(), deep.end());
}

std::vector<ContactPoint> ContactDetector::Implementation::collect(const Bodies& bodies,
                                                                   const std::vector<double>& margins) {
  add_up_counts();
  std::size_t count = 0;
  for (const Stretch& stretch : stretches) count += stretch.points.size();
  std::vector<ContactPoint> points;
  points.reserve(count);
  std::size_t of_bodies = 0;  // where the points of the present two bodies begin
  double touches = 0;
  std::size_t first_pair = 0;
  bool left = false;
  for (std::size_t i = 0; i < pairs.size(); ++i) {
    const FoundPoints& pair = found[i];
    const bool same_bodies = i > 0 && pairs[i].body_a == pairs[i - 1].body_a && pairs[i].body_b == pairs[i - 1].body_b;
    if (!same_bodies) {
      of_bodies = points.size();
      touches = 0;
      first_pair = i;
      left = false;
    }
    left = left || is_deep(i);
    touches = std::max({touches, touching[pairs[i].part_a], touching[pairs[i].part_b]});
    const auto first = stretches[pair.stretch].points.begin() + pair.first;
    points.insert(points.end(), first, first + pair.count);
    const bool last =
        i + 1 == pairs.size() || pairs[i + 1].body_a != pairs[i].body_a || pairs[i + 1].body_b != pairs[i].body_b;
    const auto overlaps = [](const ContactPoint& c) { return c.gap < 0; };
    if (last && left && std::none_of(points.begin() + static_cast<std::ptrdiff_t>(of_bodies), points.end(), overlaps))
      find_deep(bodies, first_pair, i + 1, margins[i], points);
    if (last && touches > 0) join_at_seams(bodies, touches, margins[i], of_bodies, points);
  }
  return points;
}

void ContactDetector::Implementation::save_pairs(StateWriter out) const {
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

void ContactDetector::Implementation::restore_pairs(const StateReader& in) {
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

ContactDetector::ContactDetector(int threads) : implementation_(std::make_unique<Implementation>()) {
  implementation_->threads = threads;
}
ContactDetector::~ContactDetector() = default;
ContactDetector::ContactDetector(ContactDetector&&) noexcept = default;
ContactDetector& ContactDetector::operator=(ContactDetector&&) noexcept = default;

std::vector<ContactPoint> ContactDetector::detect(const Bodies& bodies, double margin) {
  Implementation& work = *implementation_;
  work.list_pairs(bodies, margin);
  const std::vector<double> margins(work.pairs.size(), margin);
  work.search_pairs(bodies, margins);
  return work.collect(bodies, margins);
}

std::vector<ContactPoint> ContactDetector::detect(const Bodies& bodies, const std::vector<double>& own_reach,
                                                  double margin) {
  NILAS_DEMAND(own_reach.size() == static_cast<std::size_t>(bodies.size()));
  // pairs farther apart are not listed, however far one that is pushed could reach
  std::vector<double> farthest = own_reach;
  farthest.resize(std::max<std::size_t>(farthest.size(), 2), 0);
  std::partial_sort(farthest.begin(), farthest.begin() + 2, farthest.end(), std::greater<>());
  Implementation& work = *implementation_;
  const double listed = std::max(farthest[0] + farthest[1], margin);
  work.list_pairs(bodies, listed);
  std::vector<double> margins = pair_margins(bodies, own_reach, work.pairs);
  for (double& of_pair : margins) of_pair = std::clamp(of_pair, margin, listed);
  work.search_pairs(bodies, margins);
  std::vector<ContactPoint> points = work.collect(bodies, margins);
  drop_out_of_reach(bodies, own_reach, points, margin);
  return points;
}

/// The parts of a body follow each other.
std::vector<PartsOnTheirWay> ContactDetector::Implementation::parts_of(const Bodies& bodies,
                                                                       const std::vector<FastPair>& fast) const {
  const auto of_body = [&](int b) { return std::equal_range(parts.begin(), parts.end(), b, BodyOrder{}); };
  std::vector<PartsOnTheirWay> on_ways;
  for (const FastPair& pair : fast) {
    const auto [first_a, last_a] = of_body(pair.a);
    const auto [first_b, last_b] = of_body(pair.b);
    for (auto a = first_a; a != last_a; ++a)
      for (auto b = first_b; b != last_b; ++b)
        if (const PartsOnTheirWay on_way{&*a, &*b, pair.width, pair.way}; !stay_apart(bodies, on_way))
          on_ways.push_back(on_way);
  }
  return on_ways;
}

std::vector<SweptPair> ContactDetector::sweep(const Bodies& bodies, const std::vector<BodyMotion>& motions,
                                              const std::vector<FastPair>& fast, double depth) {
  if (fast.empty()) return {};
  Implementation& work = *implementation_;
  work.learn_bodies(bodies);
  const std::vector<PartsOnTheirWay> on_ways = work.parts_of(bodies, fast);
  std::vector<SweptPair> swept(on_ways.size());
  constexpr std::ptrdiff_t k_pairs_per_chunk = 8;
  parallel_chunks(
      static_cast<std::ptrdiff_t>(on_ways.size()), k_pairs_per_chunk, work.threads,
      [&](std::ptrdiff_t, std::ptrdiff_t first, std::ptrdiff_t last) {
        AxisSearchRoom room;
        for (std::ptrdiff_t k = first; k < last; ++k) {
          const Part &a = *on_ways[k].a, &b = *on_ways[k].b;
          swept[k] = {a.body,
                      b.body,
                      a.index,
                      b.index,
                      time_of_impact(a, motions[a.body], b, motions[b.body], work.fcl, room, depth * on_ways[k].width),
                      {}};
        }
      });
  for (const SweptPair& pair : swept) {
    work.counts.fcl_queries += pair.first.search.fcl_queries;
    work.counts.fallbacks += pair.first.search.fallbacks;
  }
  if (std::none_of(swept.begin(), swept.end(), [](const SweptPair& pair) { return pair.first.hit; })) return swept;
  Bodies there = bodies;
  AxisSearchRoom room;
  for (std::size_t k = 0; k < swept.size(); ++k) {
    const TimeOfImpact& first = swept[k].first;
    if (!first.hit || first.t == 0) continue;
    for (const int body : {swept[k].a, swept[k].b}) {
      there.p_GB[body] = motions[body].position(first.t);
      there.R_GB[body] = motions[body].attitude(first.t);
    }
    PairMemory none;
    const double margin = std::max((1 - first.t) * on_ways[k].way, 2 * std::abs(first.distance));
    find_pair_contacts(there, *on_ways[k].a, *on_ways[k].b, margin, work.fcl, room, none, swept[k].points);
  }
  return swept;
}

void ContactDetector::follow(const Bodies& bodies) { implementation_->learn_bodies(bodies); }

const DetectorCounts& ContactDetector::counts() const { return implementation_->counts; }

void ContactDetector::save(StateWriter out) const {
  const Implementation& work = *implementation_;
  work.broad.save(out.group("boxes"));
  work.save_pairs(out.group("pairs"));
}

void ContactDetector::restore(const Bodies& bodies, const StateReader& in) {
  Implementation& work = *implementation_;
  work.forget_all();
  work.learn_bodies(bodies);
  work.broad.restore(bodies, work.parts, in.group("boxes"));
  work.restore_pairs(in.group("pairs"));
}

}  // namespace nilas
