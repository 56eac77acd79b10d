#include "contact/detect/detector.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <span>
#include <tuple>

#include "contact/detect/broad/broad_phase.h"
#include "contact/detect/broad/fetch_ahead.h"
#include "contact/detect/broad/known_parts.h"
#include "contact/detect/broad/reach.h"
#include "contact/detect/narrow_phase.h"
#include "contact/detect/pair_memories.h"
#include "contact/detect/round_pair.h"
#include "contact/detect/search/fcl_query.h"
#include "contact/detect/search/seam_points.h"
#include "core/base/error.h"
#include "core/base/parallel.h"

namespace nilas::detect {

namespace {

/// Number of stretches of the pair list per thread: several, so that a stretch with many hull contacts does not delay
/// the others.
constexpr std::ptrdiff_t k_stretches_per_thread = 8;

/// Storage and results of one stretch of the pair list, in cache lines of its own.
struct alignas(64) Stretch {
  AxisSearchRoom room;
  std::vector<ContactPoint> points;
  DetectorCounts counts;

  void count(const PairContacts& contacts) {
    counts.cached_separations += contacts.separated_by_memory ? 1 : 0;
    counts.closed_forms += contacts.closed_form ? 1 : 0;
    counts.kept_axes += contacts.search.kept;
    counts.fcl_queries += contacts.search.fcl_queries;
    counts.by_fcl += contacts.search.by_fcl;
    counts.corrected += contacts.search.corrected;
    counts.searched += contacts.search.searched;
    counts.fallbacks += contacts.search.fallbacks;
  }
};

/// The place of a pair's points in the list of its stretch.
struct FoundPoints {
  int stretch = 0, count = 0;
  bool left = false;  ///< the pair is left to the caller
  std::ptrdiff_t first = 0;
  double left_depth = 0;  ///< see PairContacts
};

/// Two parts of a fast pair of bodies.
struct PartsOnTheirWay {
  const Part* a = nullptr;
  const Part* b = nullptr;
  double width = 0, way = 0;
};

/// Returns whether no point of one part moves as far against the other as the distance between the bounding balls of
/// both.
bool stay_apart(const bodies::Bodies& bodies, const PartsOnTheirWay& pair) {
  const auto centre = [&](const Part& part) -> Vec3 {
    return bodies.p_GB[part.body] + bodies.R_GB[part.body] * part.centre;
  };
  const double radii = pair.a->bounding_radius + pair.b->bounding_radius;
  return (centre(*pair.b) - centre(*pair.a)).norm() - radii > pair.way;
}

/// A search with poses that are not finite might never end.
void demand_finite(const bodies::Bodies& bodies, int threads) {
  parallel_chunks(bodies.size(), k_chunk, threads, [&](std::ptrdiff_t, std::ptrdiff_t first, std::ptrdiff_t last) {
    for (std::ptrdiff_t b = first; b < last; ++b)
      NILAS_DEMAND(bodies.p_GB[b].allFinite() && bodies.R_GB[b].allFinite());
  });
}

}  // namespace

struct ContactDetector::Implementation {
  int threads = 1;
  NarrowPhase narrow = NarrowPhase::nilas;
  KnownParts known;
  BroadPhase broad;
  FclShapes fcl;
  PairMemories now, before;
  std::vector<std::ptrdiff_t> last_place;  ///< place of each pair in the pairs of the last call, -1: not there
  std::vector<Stretch> stretches;
  std::vector<FoundPoints> found;
  std::vector<std::pair<int, int>> left_out;  ///< pairs of bodies that are left to the caller
  DetectorCounts counts;

  void forget_all();
  void learn_bodies(const bodies::Bodies& bodies);
  void find_last_pairs();
  /// Moves out the memory that pair i has of the last call, if any.
  PairMemory take_remembered(std::size_t i);
  /// Fetches what the pairs after pair i read, up to pair `end`.
  void fetch_ahead(std::ptrdiff_t i, std::ptrdiff_t end) const;
  /// The pair's memory of this call.
  PairMemory remembered(const Part& a, const Part& b) const;
  void list_pairs(const bodies::Bodies& bodies, double margin);
  void search_pairs(const bodies::Bodies& bodies, const std::vector<double>& margins, const PairFilter& left);
  void list_left_out();
  void add_up_counts();
  bool is_deep(std::size_t i) const;
  void find_deep(const bodies::Bodies& bodies, std::size_t first, std::size_t last, double margin,
                 std::vector<ContactPoint>& points);
  std::vector<ContactPoint> collect(const bodies::Bodies& bodies, const std::vector<double>& margins);
  std::vector<PartsOnTheirWay> parts_of(const bodies::Bodies& bodies, const std::vector<FastPair>& fast) const;
};

void ContactDetector::Implementation::forget_all() {
  const auto [kept_threads, kept_narrow] = std::pair(threads, narrow);
  *this = {};
  threads = kept_threads;
  narrow = kept_narrow;
}

/// Rebuilds the tree when bodies are gone. New bodies are added to it.
void ContactDetector::Implementation::learn_bodies(const bodies::Bodies& bodies) {
  demand_finite(bodies, threads);
  if (const std::vector<int> new_part = known.forget_gone(bodies); !new_part.empty()) {
    broad = BroadPhase();
    fcl = FclShapes();
    now.forget_gone(new_part, known.parts);
  }
  known.add_new(bodies);
}

PairMemory ContactDetector::Implementation::take_remembered(std::size_t i) {
  return last_place[i] >= 0 ? std::move(before.memory[last_place[i]]) : PairMemory{};
}

void ContactDetector::Implementation::fetch_ahead(std::ptrdiff_t i, std::ptrdiff_t end) const {
  constexpr std::ptrdiff_t k_soon = 2, k_later = 5;  // a pair takes about as long as a few reads from memory
  if (i + k_later < end) {
    fetch_part(known.parts[now.pairs[i + k_later].part_a]);
    fetch_part(known.parts[now.pairs[i + k_later].part_b]);
  }
  if (i + k_soon >= end) return;
  const PartPair& pair = now.pairs[i + k_soon];
  const std::ptrdiff_t last = last_place[i + k_soon];
  const bool was_apart = last >= 0 && !before.memory[last].separating.isZero(0);
  fetch_facets(known.parts[pair.part_a], was_apart);
  fetch_facets(known.parts[pair.part_b], was_apart);
}

PairMemory ContactDetector::Implementation::remembered(const Part& a, const Part& b) const {
  const auto index = [&](const Part& part) { return static_cast<int>(&part - known.parts.data()); };
  const PartPair pair{a.body, b.body, index(a), index(b)};
  const auto at = std::lower_bound(now.pairs.begin(), now.pairs.end(), pair);
  return at != now.pairs.end() && *at == pair ? now.memory[at - now.pairs.begin()] : PairMemory{};
}

/// Both lists rise, so one pass over them serves.
void ContactDetector::Implementation::find_last_pairs() {
  last_place.resize(now.pairs.size());
  std::size_t last = 0;
  for (std::size_t i = 0; i < now.pairs.size(); ++i) {
    while (last < before.pairs.size() && before.pairs[last] < now.pairs[i]) ++last;
    const bool known_then = last < before.pairs.size() && before.pairs[last] == now.pairs[i];
    last_place[i] = known_then ? static_cast<std::ptrdiff_t>(last) : -1;
  }
}

void ContactDetector::Implementation::list_pairs(const bodies::Bodies& bodies, double margin) {
  learn_bodies(bodies);
  before.pairs.swap(now.pairs);
  before.memory.swap(now.memory);
  broad.list_pairs(bodies, known.parts, margin, threads, now.pairs);
  find_last_pairs();
  now.memory.resize(now.pairs.size());
}

void ContactDetector::Implementation::search_pairs(const bodies::Bodies& bodies, const std::vector<double>& margins,
                                                   const PairFilter& left) {
  const auto count = static_cast<std::ptrdiff_t>(now.pairs.size());
  const std::ptrdiff_t wanted = threads > 1 ? threads * k_stretches_per_thread : 1;
  stretches.resize(static_cast<std::size_t>(wanted));
  found.resize(now.pairs.size());
  parallel_pieces(wanted, threads, [&](std::ptrdiff_t s) {
    Stretch& stretch = stretches[s];
    stretch.points.clear();
    stretch.counts = {};
    const std::ptrdiff_t end = (s + 1) * count / wanted;
    for (std::ptrdiff_t i = s * count / wanted; i < end; ++i) {
      fetch_ahead(i, end);
      if (left && left(now.pairs[i].body_a, now.pairs[i].body_b)) {
        now.memory[i] = {};
        found[i] = {static_cast<int>(s), 0, true, 0, 0};
        continue;
      }
      now.memory[i] = take_remembered(i);
      const auto first = static_cast<std::ptrdiff_t>(stretch.points.size());
      const PairContacts contacts =
          find_pair_contacts(bodies, known.parts[now.pairs[i].part_a], known.parts[now.pairs[i].part_b], margins[i],
                             {narrow, fcl}, stretch.room, now.memory[i], stretch.points);
      found[i] = {static_cast<int>(s), contacts.count, false, first, contacts.left_depth};
      stretch.count(contacts);
    }
  });
}

void ContactDetector::Implementation::list_left_out() {
  left_out.clear();
  for (std::size_t i = 0; i < now.pairs.size(); ++i) {
    const std::pair bodies(now.pairs[i].body_a, now.pairs[i].body_b);
    if (found[i].left && (left_out.empty() || left_out.back() != bodies)) left_out.push_back(bodies);
  }
}

void ContactDetector::Implementation::add_up_counts() {
  counts = {};
  counts.candidate_pairs = static_cast<long>(now.pairs.size());
  for (const Stretch& stretch : stretches) counts += stretch.counts;
}

/// Returns whether the parts of a pair that leaves its contact to other parts overlap so deep that those may not have
/// it either. Near the end of a seam, parts may overlap a little along it without obstructing each other.
bool ContactDetector::Implementation::is_deep(std::size_t i) const {
  constexpr double k_deep_share = 0.25;  // share of the thickness of the thinner body
  return found[i].left_depth >
         k_deep_share * std::min(known.thickness[now.pairs[i].body_a], known.thickness[now.pairs[i].body_b]);
}

/// Finds the points of two bodies that overlap so deep that each of their pairs of parts, [first, last), leaves the
/// contact to another pair. The pair with the smallest penetration keeps its axis, and the others keep the points they
/// have along it.
void ContactDetector::Implementation::find_deep(const bodies::Bodies& bodies, std::size_t first, std::size_t last,
                                                double margin, std::vector<ContactPoint>& points) {
  AxisSearchRoom room;
  std::vector<ContactPoint> deep;
  for (std::size_t i = first; i < last; ++i) {
    PairMemory none;
    if (is_deep(i))
      find_pair_contacts(bodies, known.parts[now.pairs[i].part_a], known.parts[now.pairs[i].part_b], margin,
                         {narrow, fcl}, room, none, deep, true);
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

std::vector<ContactPoint> ContactDetector::Implementation::collect(const bodies::Bodies& bodies,
                                                                   const std::vector<double>& margins) {
  add_up_counts();
  list_left_out();
  std::size_t count = 0;
  for (const Stretch& stretch : stretches) count += stretch.points.size();
  std::vector<ContactPoint> points;
  points.reserve(count);
  std::size_t of_bodies = 0;  // where the points of the present pair of bodies begin
  double touches = 0;
  std::size_t first_pair = 0;
  bool left = false;
  for (std::size_t i = 0; i < now.pairs.size(); ++i) {
    const FoundPoints& pair = found[i];
    const bool same_bodies =
        i > 0 && now.pairs[i].body_a == now.pairs[i - 1].body_a && now.pairs[i].body_b == now.pairs[i - 1].body_b;
    if (!same_bodies) {
      of_bodies = points.size();
      touches = 0;
      first_pair = i;
      left = false;
    }
    left = left || is_deep(i);
    touches = std::max({touches, known.touching[now.pairs[i].part_a], known.touching[now.pairs[i].part_b]});
    const auto first = stretches[pair.stretch].points.begin() + pair.first;
    points.insert(points.end(), first, first + pair.count);
    const bool last = i + 1 == now.pairs.size() || now.pairs[i + 1].body_a != now.pairs[i].body_a ||
                      now.pairs[i + 1].body_b != now.pairs[i].body_b;
    const auto overlaps = [](const ContactPoint& c) { return c.gap < 0; };
    if (last && left && std::none_of(points.begin() + static_cast<std::ptrdiff_t>(of_bodies), points.end(), overlaps))
      find_deep(bodies, first_pair, i + 1, margins[i], points);
    if (last && touches > 0) join_at_seams(bodies, touches, margins[i], of_bodies, points);
  }
  return points;
}

ContactDetector::ContactDetector(int threads, NarrowPhase narrow)
    : implementation_(std::make_unique<Implementation>()) {
  implementation_->threads = threads;
  implementation_->narrow = narrow;
}
ContactDetector::~ContactDetector() = default;
ContactDetector::ContactDetector(ContactDetector&&) noexcept = default;
ContactDetector& ContactDetector::operator=(ContactDetector&&) noexcept = default;

std::vector<ContactPoint> ContactDetector::detect(const bodies::Bodies& bodies, double margin, const PairFilter& left) {
  Implementation& work = *implementation_;
  work.list_pairs(bodies, margin);
  const std::vector<double> margins(work.now.pairs.size(), margin);
  work.search_pairs(bodies, margins, left);
  return work.collect(bodies, margins);
}

std::vector<ContactPoint> ContactDetector::detect(const bodies::Bodies& bodies, const std::vector<double>& own_reach,
                                                  double margin, const PairFilter& left) {
  NILAS_DEMAND(own_reach.size() == static_cast<std::size_t>(bodies.size()));
  // pairs farther apart than the two largest reaches together cannot close, even by chains of pushes
  std::vector<double> farthest = own_reach;
  farthest.resize(std::max<std::size_t>(farthest.size(), 2), 0);
  std::partial_sort(farthest.begin(), farthest.begin() + 2, farthest.end(), std::greater<>());
  Implementation& work = *implementation_;
  const double listed = std::max(farthest[0] + farthest[1], margin);
  work.list_pairs(bodies, listed);
  const std::vector<double> margins = pair_margins(bodies, own_reach, work.now.pairs, margin, listed, work.threads);
  work.search_pairs(bodies, margins, left);
  std::vector<ContactPoint> points = work.collect(bodies, margins);
  drop_out_of_reach(bodies, own_reach, points, margin);
  return points;
}

std::vector<PartsOnTheirWay> ContactDetector::Implementation::parts_of(const bodies::Bodies& bodies,
                                                                       const std::vector<FastPair>& fast) const {
  std::vector<PartsOnTheirWay> on_ways;
  for (const FastPair& pair : fast) {
    const auto [first_a, last_a] = known.of_body(pair.a);
    const auto [first_b, last_b] = known.of_body(pair.b);
    for (auto a = first_a; a != last_a; ++a)
      for (auto b = first_b; b != last_b; ++b)
        if (const PartsOnTheirWay on_way{&*a, &*b, pair.width, pair.way}; !stay_apart(bodies, on_way))
          on_ways.push_back(on_way);
  }
  return on_ways;
}

std::vector<SweptPair> ContactDetector::sweep(const bodies::Bodies& bodies, const std::vector<BodyMotion>& motions,
                                              const std::vector<FastPair>& fast, const SoughtOverlap& overlap) {
  if (fast.empty()) return {};
  Implementation& work = *implementation_;
  work.learn_bodies(bodies);
  const std::vector<PartsOnTheirWay> on_ways = work.parts_of(bodies, fast);
  std::vector<SweptPair> swept(on_ways.size());
  constexpr std::ptrdiff_t k_pairs_per_chunk = 8;
  parallel_chunks(static_cast<std::ptrdiff_t>(on_ways.size()), k_pairs_per_chunk, work.threads,
                  [&](std::ptrdiff_t, std::ptrdiff_t first, std::ptrdiff_t last) {
                    AxisSearchRoom room;
                    for (std::ptrdiff_t k = first; k < last; ++k) {
                      const Part &a = *on_ways[k].a, &b = *on_ways[k].b;
                      const double width = on_ways[k].width;
                      swept[k] = {a.body,
                                  b.body,
                                  a.index,
                                  b.index,
                                  time_of_impact(a, motions[a.body], b, motions[b.body], work.fcl, room,
                                                 {overlap.deeper * width, overlap.most * width}),
                                  {}};
                    }
                  });
  for (const SweptPair& pair : swept) {
    work.counts.fcl_queries += pair.first.search.fcl_queries;
    work.counts.fallbacks += pair.first.search.fallbacks;
  }
  if (std::none_of(swept.begin(), swept.end(), [](const SweptPair& pair) { return pair.first.hit; })) return swept;
  bodies::Bodies there = bodies;
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
    find_pair_contacts(there, *on_ways[k].a, *on_ways[k].b, margin, {NarrowPhase::nilas, work.fcl}, room, none,
                       swept[k].points);
  }
  return swept;
}

void ContactDetector::measure_round(const bodies::Bodies& bodies, std::vector<ContactPoint>& points) {
  Implementation& work = *implementation_;
  AxisSearchRoom room;
  for (std::size_t i = 0, last = 0; i < points.size(); i = last) {
    const auto names = [](const ContactPoint& c) { return std::tuple(c.a, c.b, c.part_a, c.part_b); };
    while (last < points.size() && names(points[last]) == names(points[i])) ++last;
    if (points[i].crushes() || !(is_round(*bodies.shape[points[i].a]) || is_round(*bodies.shape[points[i].b])))
      continue;
    const Part& a = work.known.of_body(points[i].a).first[points[i].part_a];
    const Part& b = work.known.of_body(points[i].b).first[points[i].part_b];
    measure_round_pair(bodies, a, b, {work.narrow, work.fcl}, room, work.remembered(a, b),
                       std::span(points).subspan(i, last - i));
  }
}

void ContactDetector::follow(const bodies::Bodies& bodies) { implementation_->learn_bodies(bodies); }

const std::vector<std::pair<int, int>>& ContactDetector::pairs_left() const { return implementation_->left_out; }

const DetectorCounts& ContactDetector::counts() const { return implementation_->counts; }

void ContactDetector::save(StateWriter out) const {
  const Implementation& work = *implementation_;
  work.broad.save(out.group("boxes"));
  work.now.save(out.group("pairs"));
}

void ContactDetector::restore(const bodies::Bodies& bodies, const StateReader& in) {
  Implementation& work = *implementation_;
  work.forget_all();
  work.learn_bodies(bodies);
  work.broad.restore(bodies, work.known.parts, in.group("boxes"));
  work.now.restore(work.known.parts, in.group("pairs"));
}

}  // namespace nilas::detect
