#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "core/base/error.h"
#include "core/field/exchange.h"
#include "core/field/field.h"
#include "core/field/fitting.h"
#include "core/field/floe_shapes.h"
#include "core/field/floe_sizes.h"
#include "core/field/keep_out.h"
#include "core/field/overlaps.h"
#include "core/field/packed_spec.h"
#include "core/field/place_floes.h"
#include "core/field/relaxation.h"

namespace nilas {

namespace {

/// Wanted gap between floes, of the mean size: a run then starts without touching floes. Costs 0.2 % of the area.
constexpr double k_gap = 1e-3;
constexpr double k_accepted_lack = 0.9;  ///< of the wanted gap: what is left is a gap, not an overlap
constexpr double k_reach = 0.05;         ///< of the mean size; see RelaxationSettings

constexpr double k_first_scale = 0.85;  ///< floes start so much smaller and grow between passes
constexpr double k_growth = 0.002;      ///< of the scale per pass
constexpr int k_settling_passes = 150;  ///< at full size

constexpr int k_exchange_rounds = 250;         ///< of shaking, exchanging places and relaxing
constexpr int k_exchange_runs = 3;             ///< of so many rounds, each shaken anew
constexpr int k_exchange_rounds_polygon = 20;  ///< before outlines are fitted
constexpr int k_passes_per_round = 20;
constexpr int k_trials_per_floe = 20;
constexpr double k_shake = 0.03;        ///< first shaking: standard deviation, floe sizes and radians
constexpr double k_shaken_share = 0.8;  ///< of the rounds; the shaking fades to nothing over these

constexpr int k_fitting_rounds = 400;
constexpr int k_passes_per_fitting = 10;

constexpr double k_shrink = 0.99;  ///< of the areas per step, to find what concentration can be reached
constexpr int k_shrink_rounds = 15;

const char* name_of(FloeShape shape) {
  switch (shape) {
    case FloeShape::rectangle:
      return "rectangles";
    case FloeShape::square:
      return "squares";
    case FloeShape::parallelogram:
      return "parallelograms";
    case FloeShape::disc:
      return "discs";
    case FloeShape::polygon:
      break;
  }
  return "polygons";
}

class Packing {
 public:
  explicit Packing(const PackedSpec& spec)
      : spec_(spec),
        gap_(k_gap * spec.mean),
        bounds_(field_bounds(spec)),
        floes_(draw_floes()),
        relaxation_(floes_, bounds_, {gap_, k_reach * spec.mean}) {}

  FieldResult run() {
    if (!pack()) accept_or_refuse();
    FieldResult result;
    for (ConvexOutline& outline : placed_outlines(floes_)) result.floes.push_back({std::move(outline.corners)});
    result.concentration = concentration();
    result.worst_overlap = deepest_overlap(floes_, bounds_);
    result.passes = passes_;
    result.fitted = static_cast<int>(fitted_.size());
    return result;
  }

 private:
  static FieldBounds field_bounds(const PackedSpec& spec) {
    FieldBounds bounds{spec.low, spec.high, {}};
    for (auto& outline : grown_outlines(spec.keep_out, spec.keep_out_margin))
      bounds.obstacles.push_back(obstacle(std::move(outline)));
    return bounds;
  }

  std::vector<LooseFloe> draw_floes() {
    std::vector<std::vector<Vec2>> outlines;
    for (const Obstacle& o : bounds_.obstacles) outlines.push_back(o.outline.corners);
    free_area_ = free_area(spec_.low, spec_.high, outlines);
    RandomStream sizes(spec_.seed, "field sizes"), shapes(spec_.seed, "field shapes"),
        places(spec_.seed, "field places");
    std::vector<LooseFloe> floes;
    for (const double area : draw_areas(spec_, spec_.concentration * free_area_, sizes))
      floes.push_back(draw_floe(spec_, area, shapes));
    if (floes.empty())
      throw InputError(
          fmt::format("packed field: concentration {} of {:.3g} m^2 of free water is less than half a floe",
                      spec_.concentration, free_area_));
    place_floes(floes, bounds_, places);
    return floes;
  }

  double concentration() const {
    double ice = 0;
    for (const LooseFloe& floe : floes_) ice += floe.area;
    return ice / free_area_;
  }

  bool pack() {
    if (grow()) return true;
    if (spec_.shape == FloeShape::polygon) return exchange(k_exchange_rounds_polygon) || fit();
    for (int run = 0; run < k_exchange_runs; ++run)
      if (exchange(k_exchange_rounds) || overlaps_are_tolerated()) return true;
    return false;
  }

  bool overlaps_are_tolerated() const {
    return deepest_overlap(floes_, bounds_) <= spec_.overlap_tolerance * spec_.mean;
  }

  bool relax(double scale, int passes) {
    const double accepted = k_accepted_lack * gap_;
    for (int k = 0; k < passes; ++k) {
      ++passes_;
      if (relaxation_.pass(scale, accepted) <= accepted) return true;
    }
    return false;
  }

  bool grow() {
    for (double scale = k_first_scale; scale < 1; scale += k_growth) relax(scale, 1);
    return relax(1, k_settling_passes);
  }

  void shake(double amount) {
    for (LooseFloe& floe : floes_) {
      const double dx = shaking_.normal(), dy = shaking_.normal();
      floe.centre += amount * std::sqrt(floe.area) * Vec2(dx, dy);
      floe.angle += amount * shaking_.normal();
    }
  }

  bool exchange(int rounds) {
    Exchange places(floes_, bounds_, gap_, exchanges_);
    for (int round = 0; round < rounds; ++round) {
      const double fading = 1 - round / (k_shaken_share * rounds);
      if (fading > 0) shake(k_shake * fading);
      places.run(k_trials_per_floe * static_cast<int>(floes_.size()));
      relaxation_.restart();
      if (relax(1, k_passes_per_round)) return true;
    }
    return false;
  }

  bool fit() {
    for (int round = 0; round < k_fitting_rounds; ++round) {
      for (const std::size_t i : fit_outlines(floes_, bounds_, {gap_, spec_.vertices_min, spec_.vertices_max}))
        fitted_.insert(i);
      relaxation_.restart();
      if (relax(1, k_passes_per_fitting)) return true;
    }
    return false;
  }

  /// Overlaps within the spec's tolerance are left; else says what concentration the same floes, made smaller, reach.
  void accept_or_refuse() {
    if (overlaps_are_tolerated()) return;
    const std::size_t wanted = floes_.size();
    do {
      for (LooseFloe& floe : floes_) floe = with_area(floe, k_shrink * floe.area);
      relaxation_.restart();
    } while (!exchange(k_shrink_rounds));
    throw InputError(
        fmt::format("packed field: concentration: found {}, but {} {} block each other at about {:.2f} (after {} "
                    "passes); lower it or "
                    "spread the sizes wider",
                    spec_.concentration, wanted, name_of(spec_.shape), concentration(), passes_));
  }

  const PackedSpec& spec_;
  double gap_;  ///< wanted [m]
  FieldBounds bounds_;
  double free_area_ = 0;          ///< [m^2]
  std::vector<LooseFloe> floes_;  ///< largest first
  Relaxation relaxation_;
  RandomStream shaking_{spec_.seed, "field shaking"}, exchanges_{spec_.seed, "field exchanges"};
  int passes_ = 0;
  std::set<std::size_t> fitted_;
};

}  // namespace

FieldResult pack_field(const PackedSpec& spec) {
  check_packed_spec(spec);
  return Packing(spec).run();
}

}  // namespace nilas
