#include "fracture/failure.h"

#include <algorithm>
#include <cmath>

#include "core/base/error.h"
#include "fracture/bend/weakest_sections.h"
#include "fracture/split/splitting_table.h"

namespace nilas::fracture {

namespace {

/// Length of the starter crack over that of the whole crack: so short that the floe has its largest strength [-].
constexpr double k_starter_share = 1e-3;

double angle_of(const Vec2& direction) { return std::atan2(direction.y(), direction.x()); }

/// Westergaard's equivalent length (1926) of a load shorter than 1.724 h, from which stress has not yet spread through
/// the thickness. Its use for loads at an edge is a choice of this program.
double equivalent_length(double length, double h) {
  constexpr double k_thin = 1.724;
  return length < k_thin * h ? std::sqrt(1.6 * length * length + h * h) - 0.675 * h : length;
}

/// The extent of the outline across a direction [m].
double breadth(const std::vector<Vec2>& outline, const Vec2& direction) {
  const Vec2 across(-direction.y(), direction.x());
  double low = across.dot(outline.front()), high = low;
  for (const Vec2& p : outline) {
    low = std::min(low, across.dot(p));
    high = std::max(high, across.dot(p));
  }
  return high - low;
}

/// Whether the ice reaches beyond the circumferential crack in the middle of at least one wedge.
bool reaches_beyond(const std::vector<Vec2>& outline, const BendingState& state) {
  const WedgeFan& fan = state.fan;
  for (int i = 0; i < fan.wedges; ++i) {
    const std::vector<Chord> ahead =
        chords(outline, fan.apex, fan.direction + (i + 0.5 - 0.5 * fan.wedges) * fan.wedge_angle);
    const double radius = state.radii.empty() ? state.radius : state.radii[2 * i + 1];
    if (!ahead.empty() && (ahead.front().end - fan.apex).norm() > radius) return true;
  }
  return false;
}

double farthest_radius(const BendingState& state) {
  return state.radii.empty() ? state.radius : *std::max_element(state.radii.begin(), state.radii.end());
}

/// The cracks of a bending failure, up to the free edges. If these go on beyond the sides of the fan, the cracks that
/// end there follow, for floes that cannot be cut along the former.
std::vector<std::vector<std::vector<Vec2>>> bending_cracks(const std::vector<Vec2>& outline,
                                                           const BendingState& state) {
  const std::vector<std::vector<Vec2>> to_sides =
      state.radii.empty() ? wedge_cracks(state.fan) : wedge_cracks(state.fan, state.radii);
  std::vector<std::vector<std::vector<Vec2>>> ways{to_free_edges(outline, state.fan, to_sides)};
  if (ways.front() != to_sides) ways.push_back(to_sides);
  return ways;
}

/// The ice ahead of the load, up to the first edge.
std::optional<Chord> ice_ahead(const std::vector<Vec2>& outline, const EdgeContact& contact) {
  const std::vector<Chord> ahead = chords(outline, contact.edge_point, angle_of(contact.inward));
  return ahead.empty() ? std::nullopt : std::optional<Chord>(ahead.front());
}

}  // namespace

std::string name_of(FailureKind kind) {
  switch (kind) {
    case FailureKind::bending:
      return "bending";
    case FailureKind::splitting:
      return "splitting";
    case FailureKind::crushing:
      return "crushing";
  }
  return "";
}

FailureRules::FailureRules(const FailureSettings& settings)
    : settings_(settings), edge_(settings.poisson), wedge_(TipLoad::pressure) {
  NILAS_DEMAND(settings.wedge_angle > 0 && settings.wedge_angle < k_pi && settings.segment > 0);
  if (settings.splitting == SplittingModel::lefm) splitting_.emplace();
}

IcePlate FailureRules::plate(const IceAtContact& ice) const {
  return {ice.thickness, settings_.youngs_modulus, settings_.poisson, settings_.water_density, settings_.gravity};
}

BendingState FailureRules::bending_state(const std::vector<Vec2>& outline, const EdgeContact& contact,
                                         const IceAtContact& ice, double least) const {
  const IcePlate sheet = plate(ice);
  const double P = std::abs(contact.force.z()), h = ice.thickness;
  const double l_sheet = characteristic_length(sheet), l_wedge = beam_characteristic_length(sheet);
  const double b = equivalent_length(0.5 * contact.width, h);
  const double a_over_l = std::min(equivalent_length(contact.depth, h) / l_wedge, k_longest_tip_load);
  BendingState state;
  state.radius = bending_radius(wedge_, a_over_l, l_wedge, contact.speed, settings_.speed);
  state.fan = fan_across(outline, contact.edge_point, settings_.wedge_angle, state.radius, state.radius);
  state.radial = P / radial_crack_load(edge_, b, l_sheet, h, ice.flexural_strength);
  state.wedges =
      P / wedges_failure_load(wedge_, a_over_l, state.fan.wedge_angle, state.fan.wedges, h, ice.flexural_strength);
  if (state.radial < least || !curves(ice)) return state;
  WeakestSections weakest = weakest_sections(state.fan, a_over_l, ice.flexural_strength, *ice.around);
  state.wedges /= weakest.strength;
  state.radii = std::move(weakest.radii);
  return state;
}

bool FailureRules::curves(const IceAtContact& ice) const {
  return settings_.curved && ice.around != nullptr && !ice.around->is_uniform();
}

CrackPath FailureRules::path_from(const Vec2& start, const std::vector<Vec2>& outline, const EdgeContact& contact,
                                  const IceAtContact& ice) const {
  return crack_path(outline, start, angle_of(contact.inward), settings_.segment * ice.thickness, ice.fracture_toughness,
                    *ice.around);
}

/// The largest growth force along the crack [N]. Within a segment of one toughness it is at an end, or where H is
/// least.
double FailureRules::bearable_force(const CrackPath& path, const SplittingFloe& floe) const {
  const double all = path.length(), easiest = splitting_->least(floe.width / floe.length).crack;
  SplittingFloe segment = floe;
  double most = 0, from = 0;
  for (std::size_t i = 0; i < path.toughness.size(); ++i) {
    const double to = std::min(1 - k_starter_share, from + (path.points[i + 1] - path.points[i]).norm() / all);
    segment.toughness = path.toughness[i];
    for (const double share : {std::max(from, k_starter_share), std::clamp(easiest, from, to), to})
      if (share >= k_starter_share) most = std::max(most, growth_force(*splitting_, segment, share * floe.length));
    from = to;
  }
  return most;
}

std::optional<FailureRules::SplittingState> FailureRules::splitting_state(const std::vector<Vec2>& outline,
                                                                          const EdgeContact& contact,
                                                                          const IceAtContact& ice) const {
  NILAS_DEMAND(splitting_.has_value());
  if (!contact.pushes_in) return std::nullopt;
  const auto chord = ice_ahead(outline, contact);
  if (!chord) return std::nullopt;
  const double L = chord->length();
  const SplittingFloe floe{L, breadth(outline, contact.inward), ice.thickness, ice.fracture_toughness};
  // The table's widest floe is almost a half-plane. A wider one means that the chord only cuts off a corner.
  if (floe.width > splitting_table::widest * L) return std::nullopt;
  if (!curves(ice))
    return SplittingState{contact.opening / splitting_force(*splitting_, floe, k_starter_share * L),
                          {chord->start, chord->end}};
  CrackPath path = path_from(chord->start, outline, contact, ice);
  return SplittingState{contact.opening / bearable_force(path, floe), std::move(path.points)};
}

std::optional<Failure> FailureRules::geometric_split(const std::vector<Vec2>& outline, const EdgeContact& contact,
                                                     const BendingState& state, const IceAtContact& ice,
                                                     double least) const {
  if (state.radial < least || !contact.pushes_in) return std::nullopt;
  const SplitRule rule{state.radius, settings_.multiplier, settings_.min_area, settings_.max_aspect};
  const Split split = split_along(outline, contact.edge_point, angle_of(contact.inward), rule);
  if (split.verdict != SplitVerdict::splits) return std::nullopt;
  std::vector<Vec2> crack{split.chord.start, split.chord.end};
  if (curves(ice)) {
    crack = path_from(split.chord.start, outline, contact, ice).points;
    if (verdict_on_cut(outline, crack, rule) != SplitVerdict::splits) return std::nullopt;
  }
  return Failure{FailureKind::splitting, state.radial, contact.edge_point, state.radius, {std::move(crack)}};
}

double FailureRules::link(const IceAtContact& ice) const { return 0.5 * beam_characteristic_length(plate(ice)); }

std::vector<Failure> FailureRules::failures(const std::vector<Vec2>& outline, const EdgeContact& contact,
                                            const IceAtContact& ice, double least) const {
  std::vector<Failure> found;
  // Such a load is in the middle of the ice, not on its edge.
  if (contact.from_edge > link(ice) + 0.5 * contact.depth) return found;
  const BendingState state = bending_state(outline, contact, ice, least);
  if (settings_.splitting == SplittingModel::geometric)
    if (auto split = geometric_split(outline, contact, state, ice, least)) found.push_back(std::move(*split));
  if (settings_.splitting == SplittingModel::lefm)
    if (auto split = splitting_state(outline, contact, ice); split && split->ratio >= least)
      found.push_back({FailureKind::splitting, split->ratio, contact.edge_point, 0, {std::move(split->crack)}});
  const double bends = std::min(state.radial, state.wedges);
  if (settings_.bending && bends >= least && reaches_beyond(outline, state))
    for (auto& cracks : bending_cracks(outline, state))
      found.push_back({FailureKind::bending, bends, state.fan.apex, farthest_radius(state), std::move(cracks)});
  std::stable_sort(found.begin(), found.end(), [](const Failure& f, const Failure& g) { return f.ratio > g.ratio; });
  return found;
}

}  // namespace nilas::fracture
