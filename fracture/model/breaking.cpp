#include "fracture/model/breaking.h"

#include <algorithm>
#include <limits>

#include "core/base/error.h"

namespace nilas::fracture {

namespace {

bool is_structure(const bodies::Bodies& bodies, int body) {
  const bodies::BodyKind kind = bodies.kind[body];
  return kind == bodies::BodyKind::vessel || kind == bodies::BodyKind::rigid;
}

}  // namespace

Breaking::Breaking(const BreakingSettings& settings) : rules_(settings.failure) {
  if (settings.damage) damage_.emplace(*settings.damage);
}

void Breaking::note_loads(const bodies::Bodies& bodies, const bodies::IceProperties& ice,
                          const contact::StepMotion& motion) {
  for (std::size_t i = 0; i < motion.points.size(); ++i) {
    const detect::ContactPoint& c = motion.points[i];
    const bool on_b = ice.is_breakable(c.b) && is_structure(bodies, c.a);
    if (!on_b && !(ice.is_breakable(c.a) && is_structure(bodies, c.b))) continue;
    const auto floe = static_cast<std::size_t>(on_b ? c.b : c.a);
    const double sign = on_b ? 1 : -1;
    const Mat3& R = motion.R[floe];
    const double closing = -c.n.dot(contact::relative_velocity(motion, motion.before, i));
    loads_[bodies.id[floe]].push_back({R.transpose() * (c.p - motion.p[floe]),
                                       sign * (R.transpose() * motion.impulses[i]),
                                       std::max(0.0, closing) * std::abs(R.col(2).dot(c.n)), c.crushes()});
  }
}

IceAtContact Breaking::ice_at(const bodies::Bodies& bodies, const bodies::IceProperties& ice, std::size_t b,
                              const Vec2& x, const LocalIce* around) {
  const Vec3 place(x.x(), x.y(), 0);
  return {bodies.shape[b]->thickness, ice.flexural_strength[b].at(place), ice.fracture_toughness[b].at(place), around};
}

/// The strengths and weak lines of a floe, for cracks that follow them.
static LocalIce local_ice(const bodies::IceProperties& ice, std::size_t b) {
  const auto in_plane = [](const bodies::FloeStrength& strength) {
    std::function<double(const Vec2&)> at;
    if (strength.at_xy) at = [&field = strength.at_xy](const Vec2& x) { return field(x.x(), x.y()); };
    return at;
  };
  return {in_plane(ice.flexural_strength[b]), in_plane(ice.fracture_toughness[b]), ice.weak_lines[b]};
}

/// The failure modes under a load. Damaged ice fails at the strength that is left. A load that it bears damages it.
std::vector<Failure> Breaking::ways_under(const EdgeContact& contact, std::int64_t floe,
                                          const std::vector<Vec2>& outline, const IceAtContact& ice) {
  if (!damage_) return rules_.failures(outline, contact, ice);
  const double reach = rules_.link(ice), left = 1 - damage_->at(floe, contact.edge_point, reach);
  std::vector<Failure> ways = rules_.failures(outline, contact, ice, std::min(left, damage_->endurance()));
  double share = 0;
  for (Failure& way : ways) {
    share = std::max(share, way.ratio);
    way.ratio /= left;
  }
  damage_->load(floe, contact.edge_point, reach, share);
  std::erase_if(ways, [](const Failure& way) { return way.ratio < 1; });
  return ways;
}

std::vector<FloeBreak> Breaking::take_breaks(const bodies::Bodies& bodies, const bodies::IceProperties& ice,
                                             double step) {
  std::vector<FloeBreak> breaks;
  for (auto& [id, loads] : loads_) {
    const std::size_t b = bodies.index_of(id);
    const std::vector<Vec2>& outline = bodies.shape[b]->outline;
    for (PointLoad& load : loads) load.force /= step;
    FloeBreak found{id, {}};
    const LocalIce around = rules_.has_curved_cracks() ? local_ice(ice, b) : LocalIce();
    const IceAtContact middle = ice_at(bodies, ice, b, {0, 0}, &around);
    for (const EdgeContact& contact : edge_contacts(outline, loads, {rules_.link(middle), middle.thickness}))
      for (Failure& way : ways_under(contact, id, outline, ice_at(bodies, ice, b, contact.edge_point, &around)))
        found.ways.push_back(std::move(way));
    if (found.ways.empty()) continue;
    std::stable_sort(found.ways.begin(), found.ways.end(),
                     [](const Failure& f, const Failure& g) { return f.ratio > g.ratio; });
    breaks.push_back(std::move(found));
  }
  loads_.clear();
  if (damage_) damage_->end_step();
  return breaks;
}

void Breaking::follow(const bodies::Bodies& bodies, const std::vector<NewPiece>& pieces) {
  if (!damage_) return;
  for (const NewPiece& piece : pieces)
    damage_->hand_on(piece.floe, piece.id, piece.place, bodies.shape[bodies.index_of(piece.id)]->bounding_radius);
  for (const NewPiece& piece : pieces) damage_->forget(piece.floe);
}

double Breaking::damage(std::int64_t floe) const {
  return damage_ ? damage_->at(floe, Vec2::Zero(), std::numeric_limits<double>::infinity()) : 0;
}

void Breaking::save(StateWriter out) const {
  if (damage_) damage_->save(out.group("damage"));
}

void Breaking::restore(const StateReader& in) {
  if (damage_) damage_->restore(in.group("damage"));
}

}  // namespace nilas::fracture
