#include "fracture/failure.h"

#include <algorithm>
#include <cmath>

#include "core/base/error.h"
#include "fracture/splitting_table.h"

namespace nilas {

namespace {

/// A starter crack this short, of the crack's whole length, leaves the floe its largest strength [-].
constexpr double k_starter_share = 1e-3;

double angle_of(const Vec2& direction) { return std::atan2(direction.y(), direction.x()); }

/// Where stress does not yet spread through the thickness, a load counts as wider than it is: Westergaard's equivalent
/// radius (1926), for loads of less than 1.724 h.
double equivalent_length(double length, double h) {
  constexpr double k_thin = 1.724;
  return length < k_thin * h ? std::sqrt(1.6 * length * length + h * h) - 0.675 * h : length;
}

/// Extent of the outline across a direction [m].
double breadth(const std::vector<Vec2>& outline, const Vec2& direction) {
  const Vec2 across(-direction.y(), direction.x());
  double low = across.dot(outline.front()), high = low;
  for (const Vec2& p : outline) {
    low = std::min(low, across.dot(p));
    high = std::max(high, across.dot(p));
  }
  return high - low;
}

/// How far the ice goes from the apex, at most of the wedges' middles [m].
double reach(const std::vector<Vec2>& outline, const WedgeFan& fan) {
  double farthest = 0;
  for (int i = 0; i < fan.wedges; ++i) {
    const std::vector<Chord> ahead =
        chords(outline, fan.apex, fan.direction + (i + 0.5 - 0.5 * fan.wedges) * fan.wedge_angle);
    if (!ahead.empty()) farthest = std::max(farthest, (ahead.front().end - fan.apex).norm());
  }
  return farthest;
}

/// The ice ahead of the load, up to the first edge.
std::optional<Chord> ice_ahead(const std::vector<Vec2>& outline, const EdgeContact& contact) {
  const std::vector<Chord> ahead = chords(outline, contact.edge_point, angle_of(contact.inward));
  return ahead.empty() ? std::nullopt : std::optional<Chord>(ahead.front());
}

}  // namespace

std::string name_of(FailureKind kind) { return kind == FailureKind::bending ? "bending" : "splitting"; }

FailureRules::FailureRules(const FailureSettings& settings)
    : settings_(settings), edge_(settings.poisson), wedge_(TipLoad::pressure) {
  NILAS_DEMAND(settings.wedge_angle > 0 && settings.wedge_angle < k_pi);
  if (settings.splitting == SplittingModel::lefm) splitting_.emplace();
}

IcePlate FailureRules::plate(const IceAtContact& ice) const {
  return {ice.thickness, settings_.youngs_modulus, settings_.poisson, settings_.water_density, settings_.gravity};
}

BendingState FailureRules::bending_state(const std::vector<Vec2>& outline, const EdgeContact& contact,
                                         const IceAtContact& ice) const {
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
  return state;
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
  // the table's widest floe is all but half infinite; a chord across a corner is none of it
  if (floe.width > splitting_table::widest * L) return std::nullopt;
  return SplittingState{contact.opening / splitting_force(*splitting_, floe, k_starter_share * L), *chord};
}

std::optional<Failure> FailureRules::seed_split(const std::vector<Vec2>& outline, const EdgeContact& contact,
                                                const BendingState& state) const {
  if (state.radial < 1 || !contact.pushes_in) return std::nullopt;
  const Split split = split_along(outline, contact.edge_point, angle_of(contact.inward),
                                  {state.radius, settings_.multiplier, settings_.min_area, settings_.max_aspect});
  if (split.verdict != SplitVerdict::splits) return std::nullopt;
  return Failure{
      FailureKind::splitting, state.radial, contact.edge_point, state.radius, {{split.chord.start, split.chord.end}}};
}

double FailureRules::link(const IceAtContact& ice) const { return 0.5 * beam_characteristic_length(plate(ice)); }

std::vector<Failure> FailureRules::failures(const std::vector<Vec2>& outline, const EdgeContact& contact,
                                            const IceAtContact& ice) const {
  std::vector<Failure> found;
  // in the middle of the ice it is no load on an edge
  if (contact.from_edge > link(ice) + 0.5 * contact.depth) return found;
  const BendingState state = bending_state(outline, contact, ice);
  if (settings_.splitting == SplittingModel::seed_geometric)
    if (auto split = seed_split(outline, contact, state)) found.push_back(std::move(*split));
  if (settings_.splitting == SplittingModel::lefm)
    if (const auto split = splitting_state(outline, contact, ice); split && split->ratio >= 1)
      found.push_back(
          {FailureKind::splitting, split->ratio, contact.edge_point, 0, {{split->chord.start, split->chord.end}}});
  const double bends = std::min(state.radial, state.wedges);
  if (settings_.bending && bends >= 1 && reach(outline, state.fan) > state.radius)
    found.push_back({FailureKind::bending, bends, state.fan.apex, state.radius, wedge_cracks(state.fan)});
  std::stable_sort(found.begin(), found.end(), [](const Failure& f, const Failure& g) { return f.ratio > g.ratio; });
  return found;
}

}  // namespace nilas
