#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "core/base/error.h"
#include "core/field/field.h"
#include "core/field/pack/exchange.h"
#include "core/field/pack/fitting.h"
#include "core/field/pack/overlaps.h"
#include "core/field/pack/place_floes.h"
#include "core/field/pack/relaxation.h"
#include "core/field/rows.h"
#include "core/field/shapes/floe_shapes.h"
#include "core/field/shapes/power_diagram.h"
#include "core/field/sizes/floe_sizes.h"
#include "core/field/spec/keep_out.h"
#include "core/field/spec/packed_spec.h"

namespace nilas::field {

namespace {

/// Required gap between floes, as a share of the mean size, so that a run starts without contacts. Costs 0.2 % of the
/// area.
constexpr double k_gap = 1e-3;
constexpr double k_accepted_lack = 0.9;  ///< share of the required gap that may lack: a gap remains
constexpr double k_reach = 0.05;         ///< share of the mean size; see RelaxationSettings

constexpr double k_first_scale = 0.85;  ///< initial scale of the floes, which grow between passes
constexpr double k_growth = 0.002;      ///< growth of the scale per pass
constexpr int k_settling_passes = 150;  ///< passes at full size

constexpr int k_exchange_rounds = 250;       ///< rounds of shaking, exchanging places and relaxing
constexpr int k_exchange_runs = 3;           ///< runs of that many rounds, each shaken anew
constexpr int k_short_exchange_rounds = 20;  ///< rounds before outlines are fitted, or equal floes laid in rows
constexpr int k_passes_per_round = 20;
constexpr int k_trials_per_floe = 20;
constexpr double k_shake = 0.03;        ///< first shaking: standard deviation, floe sizes and radians
constexpr double k_shaken_share = 0.8;  ///< share of the rounds over which shaking fades to nothing

/// Concentration above which polygons and equal floes always block each other, so that long exchange is skipped at
/// first.
constexpr double k_densest_drawn = 0.88;
constexpr int k_short_settling_passes = 30;

constexpr double k_row_gap = 0.3;  ///< gap between equal floes in rows, as a share of the required gap

constexpr int k_fitting_rounds = 40;
constexpr int k_passes_per_fitting = 10;
constexpr int k_lloyd_rounds = 3;  ///< rounds of the power diagram, which is used where fitting stalls
constexpr double k_cell_tolerance = 1e-3;

constexpr double k_shrink = 0.99;  ///< factor of the areas per step, to find a concentration that can be reached
constexpr int k_shrink_rounds = 15;

const char* plural_of(FloeShape shape) {
  switch (shape) {
    case FloeShape::rectangle:
      return "rectangles";
    case FloeShape::square:
      return "squares";
    case FloeShape::parallelogram:
      return "parallelograms";
    case FloeShape::disc:
      return "discs";
    case FloeShape::library:
      return "outlines of the library";
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
    for (const LooseFloe& floe : floes_) result.floes.push_back({placed_ice(floe)});
    result.concentration = concentration();
    result.worst_overlap = deepest_overlap(floes_, bounds_);
    result.passes = passes_;
    result.fitted = static_cast<int>(fitted_.size());
    return result;
  }

 private:
  std::vector<LooseFloe> draw_floes() {
    free_area_ = free_area(bounds_);
    RandomStream places(spec_.seed, "field places");
    std::vector<LooseFloe> floes = drawn(spec_.concentration * free_area_);
    if (floes.empty())
      throw InputError(
          fmt::format("packed field: concentration {} of {:.3g} m^2 of free water is less than half a floe",
                      spec_.concentration, free_area_));
    place_floes(floes, bounds_, places);
    return floes;
  }

  std::vector<LooseFloe> drawn(double area) const {
    RandomStream sizes(spec_.seed, "field sizes"), shapes(spec_.seed, "field shapes");
    if (spec_.distribution == SizeDistribution::as_library) return draw_library_floes(spec_, area, sizes);
    std::vector<LooseFloe> floes;
    for (const double each : draw_areas(spec_, area, sizes)) floes.push_back(draw_floe(spec_, each, shapes));
    // convex hulls of concave outlines of similar size differ in area
    std::stable_sort(floes.begin(), floes.end(), [](const auto& a, const auto& b) { return a.area > b.area; });
    return floes;
  }

  double concentration() const {
    double ice = 0;
    for (const LooseFloe& floe : floes_) ice += floe.area * floe.fill;
    return ice / free_area_;
  }

  bool pack() {
    if (grow()) return true;
    if (spec_.shape == FloeShape::polygon)
      return (!is_dense() && exchange(k_short_exchange_rounds)) || fit() || fit_to_cells();
    if (floes_are_equal() && ((!is_dense() && exchange(k_short_exchange_rounds)) || lay_in_rows())) return true;
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

  /// Whether the concentration requires fitted polygons or rows of equal floes.
  bool is_dense() const {
    return spec_.concentration > k_densest_drawn && (spec_.shape == FloeShape::polygon || floes_are_equal());
  }

  bool grow() {
    for (double scale = k_first_scale; scale < 1; scale += k_growth) relax(scale, 1);
    return relax(1, is_dense() ? k_short_settling_passes : k_settling_passes);
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
      for (const std::size_t i : fit_outlines(floes_, bounds_, limits())) fitted_.insert(i);
      relaxation_.restart();
      if (relax(1, k_passes_per_fitting)) return true;
    }
    return false;
  }

  /// Whether all floes have four corners and one size.
  bool floes_are_equal() const {
    const bool four_corners = spec_.shape == FloeShape::square || spec_.shape == FloeShape::rectangle ||
                              spec_.shape == FloeShape::parallelogram;
    return four_corners && (spec_.distribution == SizeDistribution::fixed || spec_.min == spec_.max);
  }

  bool lay_in_rows() {
    in_rows_ = place_in_rows(floes_, bounds_, k_row_gap * gap_, rows_);
    relaxation_.restart();
    return in_rows_ >= static_cast<int>(floes_.size()) && relax(1, k_passes_per_round);
  }

  FittingLimits limits() const { return {gap_, spec_.vertices_min, spec_.vertices_max}; }

  /// Gives every floe the shape of its cell in the power diagram of the present centres, with cell areas in proportion
  /// to the floes'. Then fits again, since cells can have more corners than floes may.
  bool fit_to_cells() {
    PowerSites sites;
    std::vector<double> areas;
    for (const LooseFloe& floe : floes_) {
      sites.points.push_back(floe.centre);
      sites.weights.push_back(0);
      areas.push_back(floe.area);
    }
    const auto cells = cells_with_areas(sites, areas, bounds_, k_lloyd_rounds, k_cell_tolerance);
    for (std::size_t i = 0; i < floes_.size(); ++i) {
      if (cells[i].outline.empty()) continue;
      std::vector<Vec2> outline = cells[i].outline;
      limit_corners(outline, floes_[i].area, limits());
      floes_[i] = with_area(loose_floe(std::move(outline)), floes_[i].area);
      fitted_.insert(i);
    }
    relaxation_.restart();
    return relax(1, k_passes_per_fitting) || fit();
  }

  /// Accepts overlaps within the spec's tolerance. Otherwise throws with the concentration that the same floes reach
  /// when shrunk.
  void accept_or_refuse() {
    if (overlaps_are_tolerated()) return;
    const std::size_t wanted = floes_.size();
    const std::string cure = cure_of_blocking();
    const double in_rows = in_rows_ * floes_.front().area / free_area_;
    do {
      for (LooseFloe& floe : floes_) floe = with_area(floe, k_shrink * floe.area);
      relaxation_.restart();
    } while (!exchange(k_shrink_rounds));
    const double reached = std::max(in_rows, concentration());
    if (wanted == 1)
      throw InputError(
          fmt::format("packed field: concentration: found {}, which makes one floe, and it does not fit; {}",
                      spec_.concentration, cure));
    throw InputError(
        fmt::format("packed field: concentration: found {}, but {} {} block each other at about {:.2f} (after {} "
                    "passes); {}",
                    spec_.concentration, wanted, plural_of(spec_.shape), reached, passes_, cure));
  }

  std::string cure_of_blocking() const {
    double largest = 0;
    for (const LooseFloe& floe : floes_) largest = std::max(largest, std::sqrt(floe.area));
    const double breadth = (spec_.high - spec_.low).minCoeff();
    if (floes_.size() > 1 && largest <= breadth) return "lower it or spread the sizes wider";
    return fmt::format(
        "the largest floe is {:.3g} m across (the root of its area), the region {:.3g} m broad: choose smaller floes "
        "or a larger region",
        largest, breadth);
  }

  const PackedSpec& spec_;
  double gap_;  ///< required gap [m]
  FieldBounds bounds_;
  double free_area_ = 0;          ///< [m^2]
  std::vector<LooseFloe> floes_;  ///< largest first
  Relaxation relaxation_;
  RandomStream shaking_{spec_.seed, "field shaking"}, exchanges_{spec_.seed, "field exchanges"},
      rows_{spec_.seed, "field rows"};
  int in_rows_ = 0;  ///< number of equal floes that rows hold
  int passes_ = 0;
  std::set<std::size_t> fitted_;
};

}  // namespace

FieldResult pack_field(const PackedSpec& spec) {
  check_packed_spec(spec);
  return Packing(spec).run();
}

}  // namespace nilas::field
