#include "fracture/model/floe_pieces.h"

namespace nilas::fracture {

namespace {

/// The strength of the floe in the frame of its piece at `place` [m].
bodies::FloeStrength moved(const bodies::FloeStrength& strength, const Vec2& place) {
  if (!strength.at_xy) return strength;
  return {strength.mean, [at = strength.at_xy, place](double x, double y) { return at(x + place.x(), y + place.y()); }};
}

FloeState state_of(const bodies::Bodies& bodies, std::size_t b) {
  FloeState floe;
  floe.outline = bodies.shape[b]->outline;
  floe.thickness = bodies.shape[b]->thickness;
  floe.mass = bodies.mass[b];
  floe.inertia_B = bodies.inertia_B[b];
  floe.pose.p = bodies.p_GB[b];
  floe.pose.q = bodies.q_GB[b];
  if (bodies.motion[b] == bodies::Motion::fixed) return floe;
  floe.v_GB = bodies.v_GB[b];
  floe.w_GB = bodies.w_GB[b];
  return floe;
}

}  // namespace

/// Whether a piece of a fixed floe stays fixed although it is not the largest.
static bool is_held(const FloePiece& piece, const Failure& way) {
  if (way.kind == FailureKind::splitting) return false;
  const std::vector<Vec2>& outline = piece.state.outline;
  double of_old_edge = 0, of_cracks = 0;
  for (std::size_t i = 0; i < outline.size(); ++i)
    (piece.crack[i] ? of_cracks : of_old_edge) += (outline[(i + 1) % outline.size()] - outline[i]).norm();
  constexpr double k_wedges = k_pi / 2;  // area of a half circle of radius R_bending, over R_bending^2
  return of_old_edge > of_cracks && piece.area > k_wedges * way.radius * way.radius;
}

std::vector<char> FloePieces::fixed_pieces(const FloeCut& cut, const Failure& way) {
  std::vector<char> fixed;
  std::size_t largest = 0;
  for (std::size_t k = 0; k < cut.pieces.size(); ++k) {
    fixed.push_back(is_held(cut.pieces[k], way) ? 1 : 0);
    if (cut.pieces[k].area > cut.pieces[largest].area) largest = k;
  }
  if (!fixed.empty()) fixed[largest] = 1;
  return fixed;
}

FloePieces::Origin FloePieces::origin_of(std::int64_t id) const {
  const auto found = origins_.find(id);
  return found == origins_.end() ? Origin{id, Vec2::Zero()} : found->second;
}

/// Appends the piece to the bodies, with the strengths of the scene's floe at its place.
void FloePieces::add_body(bodies::BodySpec spec, const Origin& origin, bodies::Bodies& bodies,
                          bodies::IceProperties& ice) {
  const Intact& intact = intact_.at(origin.floe);
  spec.name = intact.name + " piece " + std::to_string(bodies.next_id);
  spec.kind = bodies::BodyKind::floe;
  spec.material = intact.material;
  origins_[bodies.next_id] = origin;
  const auto b = static_cast<std::size_t>(bodies.add(spec));
  ice.resize(bodies.id.size());
  ice.breakable[b] = 1;
  ice.flexural_strength[b] = moved(intact.flexural, origin.place);
  ice.compressive_strength[b] = moved(intact.compressive, origin.place);
  ice.fracture_toughness[b] = moved(intact.toughness, origin.place);
  ice.weak_lines[b] = bodies::lines_near(intact.weak_lines, origin.place, bodies.shape[b]->outline);
}

void FloePieces::add_piece(const FloePiece& piece, std::size_t floe, bool fixed, bodies::Bodies& bodies,
                           bodies::IceProperties& ice) {
  const FloeState& state = piece.state;
  Origin origin = origin_of(bodies.id[floe]);
  origin.place += (bodies.R_GB[floe].transpose() * (state.pose.p - bodies.p_GB[floe])).head<2>();
  bodies::BodySpec spec;
  spec.motion = fixed ? bodies::Motion::fixed : bodies::Motion::free;
  spec.shape = std::make_shared<const geometry::Shape>(geometry::prism_shape(state.outline, state.thickness));
  spec.mass = state.mass;
  spec.inertia_B = state.inertia_B;
  spec.pose = state.pose;
  spec.v = state.v_GB;
  spec.w = state.w_GB;
  add_body(std::move(spec), origin, bodies, ice);
}

/// Keeps the properties that pieces inherit from a floe of the scene, before it leaves.
void FloePieces::keep_intact(std::size_t b, const bodies::Bodies& bodies, const bodies::IceProperties& ice) {
  if (origins_.count(bodies.id[b]) > 0) return;
  intact_[bodies.id[b]] = {bodies.name[b],
                           bodies.material_name(static_cast<int>(b)),
                           ice.flexural_strength[b],
                           ice.compressive_strength[b],
                           ice.fracture_toughness[b],
                           ice.weak_lines[b]};
}

void FloePieces::take_out(std::size_t b, bodies::Bodies& bodies, bodies::IceProperties& ice) {
  origins_.erase(bodies.id[b]);
  std::vector<char> gone(bodies.id.size(), 0);
  gone[b] = 1;
  bodies.remove(gone);
  ice.remove(gone);
}

FractureEvent FloePieces::put(const FloeBreak& broken, bodies::Bodies& bodies, bodies::IceProperties& ice,
                              WarningCounts& warnings, std::vector<NewPiece>& pieces) {
  const std::size_t b = bodies.index_of(broken.floe);
  FractureEvent event;
  event.floe = broken.floe;
  std::string refusal;
  for (const Failure& way : broken.ways) {
    const FloeCut cut = cut_floe(state_of(bodies, b), way.cracks, limits_, way.crushed);
    if (cut.status != FloeCutStatus::cut) {
      refusal = cut.message;
      continue;
    }
    const Vec3 point(way.point.x(), way.point.y(), 0);
    event.kind = name_of(way.kind);
    event.p_G = bodies.p_GB[b] + bodies.R_GB[b] * point;
    event.length = cut.crack_length;
    event.radius = way.radius;
    event.ratio = way.ratio;
    event.brash = cut.brash_account.mass;
    event.extruded = cut.extruded_account.mass;
    brash_mass_ += event.brash;
    extruded_mass_ += event.extruded;
    keep_intact(b, bodies, ice);
    const bool is_fixed = bodies.motion[b] == bodies::Motion::fixed;
    const std::vector<char> fixed = fixed_pieces(cut, way);
    for (std::size_t k = 0; k < cut.pieces.size(); ++k) {
      const Vec3 place = bodies.R_GB[b].transpose() * (cut.pieces[k].state.pose.p - bodies.p_GB[b]);
      event.pieces.push_back(bodies.next_id);
      pieces.push_back({bodies.next_id, broken.floe, place.head<2>()});
      add_piece(cut.pieces[k], b, is_fixed && fixed[k], bodies, ice);
    }
    take_out(b, bodies, ice);
    return event;
  }
  warnings.warn("floes that could not be cut",
                "'" + bodies.name[b] + "' would break, but could not be cut: " + refusal + "; it stays whole");
  return event;
}

}  // namespace nilas::fracture
