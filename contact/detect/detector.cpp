#include "contact/detect/detector.h"

#include <algorithm>

#include "contact/detect/broad_phase.h"
#include "contact/detect/fcl_query.h"
#include "contact/detect/narrow_phase.h"
#include "core/base/parallel.h"

namespace nilas {

namespace {

/// Stretches of the pair list per thread, so that a stretch with many hull contacts does not keep the others waiting.
constexpr std::ptrdiff_t k_stretches_per_thread = 8;

}  // namespace

struct ContactDetector::Implementation {
  int threads = 1;
  std::vector<std::int64_t> ids;  ///< bodies whose parts are known
  std::vector<std::shared_ptr<const Shape>> shapes;
  std::vector<Part> parts;
  BroadPhase broad;
  FclShapes fcl;
  std::vector<PartPair> pairs, last_pairs;
  std::vector<PairMemory> memory, last_memory;
  std::vector<PairContacts> contacts;
  std::vector<AxisSearchRoom> rooms;
  DetectorCounts counts;

  void forget_all();
  void learn_bodies(const Bodies& bodies);
  void carry_memory_over();
  void search_pairs(const Bodies& bodies, double margin);
  std::vector<ContactPoint> collect();
};

void ContactDetector::Implementation::forget_all() {
  const int kept = threads;
  *this = {};
  threads = kept;
}

void ContactDetector::Implementation::learn_bodies(const Bodies& bodies) {
  const bool same_start = ids.size() <= bodies.id.size() && std::equal(ids.begin(), ids.end(), bodies.id.begin()) &&
                          std::equal(shapes.begin(), shapes.end(), bodies.shape.begin());
  if (!same_start) forget_all();
  for (std::size_t b = ids.size(); b < bodies.id.size(); ++b) {
    ids.push_back(bodies.id[b]);
    shapes.push_back(bodies.shape[b]);
    for (Part& part : make_parts(bodies, static_cast<int>(b))) parts.push_back(std::move(part));
  }
}

/// Both lists are sorted: one pass finds the pairs that were there before.
void ContactDetector::Implementation::carry_memory_over() {
  memory.assign(pairs.size(), {});
  std::size_t last = 0;
  for (std::size_t i = 0; i < pairs.size(); ++i) {
    while (last < last_pairs.size() && last_pairs[last] < pairs[i]) ++last;
    if (last < last_pairs.size() && last_pairs[last] == pairs[i]) memory[i] = last_memory[last];
  }
}

void ContactDetector::Implementation::search_pairs(const Bodies& bodies, double margin) {
  const auto count = static_cast<std::ptrdiff_t>(pairs.size());
  const std::ptrdiff_t stretches = threads > 1 ? threads * k_stretches_per_thread : 1;
  rooms.resize(static_cast<std::size_t>(stretches));
  if (contacts.size() < pairs.size()) contacts.resize(pairs.size());
  parallel_for(stretches, threads, [&](std::ptrdiff_t s) {
    for (std::ptrdiff_t i = s * count / stretches; i < (s + 1) * count / stretches; ++i)
      find_pair_contacts(bodies, parts[pairs[i].part_a], parts[pairs[i].part_b], margin, fcl, rooms[s], memory[i],
                         contacts[i]);
  });
}

std::vector<ContactPoint> ContactDetector::Implementation::collect() {
  std::vector<ContactPoint> points;
  counts = {};
  counts.candidate_pairs = static_cast<long>(pairs.size());
  for (std::size_t i = 0; i < pairs.size(); ++i) {
    const PairContacts& found = contacts[i];
    points.insert(points.end(), found.points.begin(), found.points.begin() + found.count);
    counts.cached_separations += found.separated_by_memory ? 1 : 0;
    counts.fcl_queries += found.search.fcl_queries;
    counts.fallbacks += found.search.fallbacks;
  }
  return points;
}

ContactDetector::ContactDetector(int threads) : implementation_(std::make_unique<Implementation>()) {
  implementation_->threads = threads;
}
ContactDetector::~ContactDetector() = default;
ContactDetector::ContactDetector(ContactDetector&&) noexcept = default;
ContactDetector& ContactDetector::operator=(ContactDetector&&) noexcept = default;

std::vector<ContactPoint> ContactDetector::detect(const Bodies& bodies, double margin) {
  Implementation& work = *implementation_;
  work.learn_bodies(bodies);
  work.last_pairs.swap(work.pairs);
  work.last_memory.swap(work.memory);
  work.pairs = work.broad.candidates(bodies, work.parts, margin);
  work.carry_memory_over();
  work.search_pairs(bodies, margin);
  return work.collect();
}

const DetectorCounts& ContactDetector::counts() const { return implementation_->counts; }

}  // namespace nilas
