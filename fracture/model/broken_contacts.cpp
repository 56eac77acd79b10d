#include "fracture/model/broken_contacts.h"

#include <algorithm>
#include <limits>
#include <set>

#include "contact/problem/row_of.h"
#include "core/base/order_free_sum.h"

namespace nilas::fracture {

namespace {

/// The largest distance of a piece's point from the floe's point whose impulse it takes, over the ice's thickness [-].
constexpr double k_reach_share = 2;
/// Distances that differ by less than this share of the reach are equal [-].
constexpr double k_same = 1e-9;

/// The place of a contact point a time h [s] earlier, carried back by the mean of both bodies' velocities [m].
Vec3 place_before(const bodies::Bodies& bodies, const detect::ContactPoint& c, double h) {
  const auto velocity = [&](int body) -> Vec3 {
    if (bodies.motion[body] == bodies::Motion::fixed) return Vec3::Zero();
    return bodies.velocity_at(body, c.p);
  };
  return c.p - 0.5 * h * (velocity(c.a) + velocity(c.b));
}

}  // namespace

/// A contact point of a piece, which may take impulses of the floe.
struct BrokenContacts::Taker {
  std::size_t point = 0;
  std::int64_t a = 0, b = 0;  ///< Ids of its bodies before the break.
  Vec3 p = Vec3::Zero();      ///< Its place before the last substep, in G [m].
  Vec3 n = Vec3::UnitX();
  double reach = 0;  ///< [m]
  OrderFreeVectorSum impulse = {};

  /// The impulse of the load on the point's body b [N s]. It is zero where the point does not take the load.
  Vec3 part_of(const Load& load) const {
    const bool same = load.a == a && load.b == b;
    if (!same && !(load.a == b && load.b == a)) return Vec3::Zero();
    if ((load.p - p).squaredNorm() > reach * reach) return Vec3::Zero();
    const Vec3 on_b = same ? load.impulse : Vec3(-load.impulse);
    return n.dot(on_b) > 0 ? on_b : Vec3(Vec3::Zero());
  }
};

void BrokenContacts::note(const contact::SolvedProblem& last, const std::vector<FractureEvent>& broken) {
  forget();
  h_ = last.problem.h;
  std::set<std::int64_t> floes;
  for (const FractureEvent& event : broken) {
    floes.insert(event.floe);
    for (const std::int64_t piece : event.pieces) floe_of_[piece] = event.floe;
  }
  for (std::size_t i = 0; i < last.points.size(); ++i) {
    const std::int64_t a = last.touching[i][0].id, b = last.touching[i][1].id;
    if (last.impulses[i].isZero(0) || (floes.count(a) == 0 && floes.count(b) == 0)) continue;
    loads_.push_back({a, b, last.points[i].p, last.impulses[i]});
  }
}

std::int64_t BrokenContacts::broken_or_self(std::int64_t id) const {
  const auto found = floe_of_.find(id);
  return found == floe_of_.end() ? id : found->second;
}

std::vector<BrokenContacts::Taker> BrokenContacts::takers(const bodies::Bodies& bodies,
                                                          const std::vector<detect::ContactPoint>& points) const {
  std::vector<Taker> found;
  for (std::size_t i = 0; i < points.size(); ++i) {
    const auto a = static_cast<std::size_t>(points[i].a), b = static_cast<std::size_t>(points[i].b);
    Taker taker{i, broken_or_self(bodies.id[a]), broken_or_self(bodies.id[b])};
    for (const auto& [body, was] : {std::pair(a, taker.a), std::pair(b, taker.b)})
      if (was != bodies.id[body]) taker.reach = std::max(taker.reach, k_reach_share * bodies.shape[body]->thickness);
    if (taker.reach == 0) continue;
    taker.p = place_before(bodies, points[i], h_);
    taker.n = points[i].n;
    found.push_back(taker);
  }
  return found;
}

void BrokenContacts::add_to(const bodies::Bodies& bodies, const std::vector<detect::ContactPoint>& points,
                            const std::vector<Mat3>& C, VecX& guess) const {
  if (loads_.empty()) return;
  std::vector<Taker> all = takers(bodies, points);
  for (const Load& load : loads_) {
    double nearest = std::numeric_limits<double>::infinity();
    std::vector<Taker*> able, taking;
    for (Taker& taker : all)
      if (!taker.part_of(load).isZero(0)) able.push_back(&taker);
    for (const Taker* taker : able) nearest = std::min(nearest, (load.p - taker->p).norm());
    for (Taker* taker : able)
      if ((load.p - taker->p).norm() <= nearest + k_same * taker->reach) taking.push_back(taker);
    for (Taker* taker : taking) taker->impulse.add(taker->part_of(load) / static_cast<double>(taking.size()));
  }
  for (const Taker& taker : all)
    guess.segment<3>(contact::row_of(taker.point)) += C[taker.point].transpose() * taker.impulse.value();
}

void BrokenContacts::save(StateWriter out) const {
  std::vector<std::int64_t> pieces, between;
  std::vector<Vec3> places, impulses;
  for (const auto& [piece, floe] : floe_of_) pieces.insert(pieces.end(), {piece, floe});
  for (const Load& load : loads_) {
    between.insert(between.end(), {load.a, load.b});
    places.push_back(load.p);
    impulses.push_back(load.impulse);
  }
  out.add("h", h_);
  out.add("piece_of", pieces);
  out.add("between", between);
  out.add("place", places);
  out.add("impulse", impulses);
}

void BrokenContacts::restore(const StateReader& in) {
  forget();
  std::vector<std::int64_t> pieces, between;
  std::vector<Vec3> places, impulses;
  in.get("h", h_);
  in.get("piece_of", pieces);
  if (pieces.size() % 2 != 0) in.refuse("piece_of", "it has no whole number of pairs");
  for (std::size_t k = 0; k < pieces.size(); k += 2) floe_of_[pieces[k]] = pieces[k + 1];
  in.get("place", places);
  in.get("impulse", impulses, places.size());
  in.get("between", between, 2 * places.size());
  for (std::size_t k = 0; k < places.size(); ++k)
    loads_.push_back({between[2 * k], between[2 * k + 1], places[k], impulses[k]});
}

}  // namespace nilas::fracture
