#include "core/hull/hull_lines.h"

#include <fmt/format.h>

#include <cmath>
#include <limits>

#include "core/base/error.h"
#include "core/hull/hull_bow.h"

namespace nilas::hull {

namespace {

constexpr double k_transom_share = 0.6;  ///< transom's beam over the beam, design waterline
constexpr double k_transom_rake = 1.0;   ///< horizontal over vertical: 45 degrees
constexpr double k_bilge_share = 0.25;   ///< bilge radius over the draught

bool wedge(const HullForm& form) { return form.kind == HullKind::wedge; }

/// Abscissae at the design waterline.
struct Stations {
  double transom, run_end, shoulder, stem;
};

Stations stations(const HullForm& form) {
  const double above = form.depth - form.draught;
  Stations s{};
  s.transom = wedge(form) ? 0 : k_transom_rake * above;
  s.stem = wedge(form) ? form.length : form.length - above / std::tan(form.stem_angle);
  s.run_end = wedge(form) ? 0 : s.transom + form.stern_length;
  s.shoulder = s.stem - form.bow_length;
  return s;
}

/// The design waterline: transom's centre, transom's corner, run, parallel body, forebody, stem.
Waterline design_waterline(const HullForm& form, const HullFineness& n) {
  const Stations s = stations(form);
  const double half = 0.5 * form.beam;
  Waterline line{{s.transom, 0}};
  if (wedge(form)) {
    line.emplace_back(s.transom, half);
  } else {
    line.emplace_back(s.transom, half * k_transom_share);
    for (int k = 1; k < n.stern; ++k) {
      const double t = 1 - static_cast<double>(k) / n.stern;  // 1 at the transom
      line.emplace_back(s.run_end - t * form.stern_length, half * (1 - (1 - k_transom_share) * t * t));
    }
    line.emplace_back(s.run_end, half);
  }
  const double drop = wedge(form) ? half : form.bow_length * std::tan(form.entrance_angle);
  const auto bow = bow_points(form, n.bow);
  const double shoulder = s.shoulder + bow.front().t * form.bow_length;
  for (int k = 1; k <= n.middle; ++k) line.emplace_back(s.run_end + (shoulder - s.run_end) * k / n.middle, half);
  for (std::size_t k = 1; k + 1 < bow.size(); ++k)
    line.emplace_back(s.shoulder + bow[k].t * form.bow_length, half - drop * bow[k].drop);
  line.emplace_back(s.stem, 0);
  return line;
}

/// Bilge: what the half breadth loses at height z, a quarter circle.
double bilge_loss(const HullForm& form, double z) {
  const double radius = k_bilge_share * form.draught;
  if (z >= radius) return 0;
  const double down = radius - z;
  return radius - std::sqrt(std::max(0.0, radius * radius - down * down));
}

/// Half breadth over that of the design waterline: concave in z, so the solid is convex.
double breadth_ratio(const HullForm& form, double z) {
  if (wedge(form)) return 1;
  return 1 + (std::tan(form.flare_angle) * (z - form.draught) - bilge_loss(form, z)) / (0.5 * form.beam);
}

}  // namespace

std::vector<double> waterline_heights(const HullForm& form, const HullFineness& n) {
  std::vector<double> heights;
  const double bilge = wedge(form) ? 0 : k_bilge_share * form.draught;
  if (!wedge(form))
    for (int k = 0; k < n.bilge; ++k) {
      // half by turn, half by height: rows of equal turn alone are so low at the keel that float32 rounding tilts them
      const double share = static_cast<double>(k) / n.bilge;
      heights.push_back(bilge * 0.5 * (1 - std::cos(0.5 * k_pi * share) + share));
    }
  for (int k = 0; k <= n.side; ++k) heights.push_back(bilge + (form.depth - bilge) * k / n.side);
  return heights;
}

Waterline waterline(const HullForm& form, const HullFineness& n, double z) {
  Waterline line = design_waterline(form, n);
  const Stations s = stations(form);
  const double up = wedge(form) ? 0 : z - form.draught, ratio = breadth_ratio(form, z);
  const double middle = 0.5 * (s.run_end + s.shoulder);
  // forebody and run shrink about stem and transom, so that their edges keep their directions
  for (auto& p : line) {
    const bool aft = p.x() < middle;
    const double origin = aft ? s.transom : s.stem;
    const double moved = aft ? origin - k_transom_rake * up : origin + up / std::tan(form.stem_angle);
    p = {moved + ratio * (p.x() - origin), ratio * p.y()};
  }
  // points of the straight side spread evenly between its ends, which move with bow and stern
  const std::size_t first = wedge(form) ? 1 : static_cast<std::size_t>(n.stern) + 1;
  const Vec2 a = line[first], b = line[first + static_cast<std::size_t>(n.middle)];
  for (int k = 1; k < n.middle; ++k) line[first + static_cast<std::size_t>(k)] = a + (b - a) * k / n.middle;
  return line;
}

namespace {

[[noreturn]] void refuse(const std::string& name, double found, const std::string& allowed) {
  throw InputError(fmt::format("hull form: {} is {:.6g}; allowed: {}", name, found, allowed));
}

void demand_lengths(const HullForm& form) {
  const auto positive = [](const char* name, double x) {
    if (!(x > 0) || !std::isfinite(x)) refuse(name, x, "> 0 m");
  };
  positive("length", form.length);
  positive("beam", form.beam);
  positive("draught", form.draught);
  positive("bow_length", form.bow_length);
  if (!wedge(form)) positive("stern_length", form.stern_length);
  if (!(form.depth > form.draught) || !std::isfinite(form.depth))
    refuse("depth", form.depth, fmt::format("more than the draught of {:.6g} m", form.draught));
}

void demand_angles(const HullForm& form) {
  const auto between = [](const char* name, double x, double low, double high) {
    if (!(x >= low * k_deg && x <= high * k_deg)) refuse(name, x / k_deg, fmt::format("{} to {} degrees", low, high));
  };
  constexpr double k_flattest_stem = 10, k_finest_entrance = 5, k_bluntest_entrance = 80, k_most_flare = 45;  // [deg]
  between("stem_angle_deg", form.stem_angle, k_flattest_stem, 90);
  between("entrance_angle_deg", form.entrance_angle, k_finest_entrance, k_bluntest_entrance);
  between("flare_angle_deg", form.flare_angle, 0, k_most_flare);
  if (bow_fullness(form) > 1)
    refuse("entrance_angle_deg", form.entrance_angle / k_deg,
           fmt::format("at least {:.6g} degrees for this beam and bow_length (a straight wedge)",
                       std::atan2(0.5 * form.beam, form.bow_length) / k_deg));
}

/// The flat bottom keeps at least a small breadth under the flare and the bilge.
void demand_bottom(const HullForm& form) {
  constexpr double k_least_bottom = 0.05;  // of the beam
  const double room = (1 - k_least_bottom) * 0.5 * form.beam - k_bilge_share * form.draught;
  if (room < 0)
    refuse("draught", form.draught,
           fmt::format("at most {:.6g} m for this beam, or the bilges meet",
                       (1 - k_least_bottom) * 0.5 * form.beam / k_bilge_share));
  if (std::tan(form.flare_angle) * form.draught > room)
    refuse("flare_angle_deg", form.flare_angle / k_deg,
           fmt::format("at most {:.6g} degrees for this beam and draught, or the bottom vanishes",
                       std::atan2(room, form.draught) / k_deg));
}

/// Bow and run must leave a parallel body at every height. Its length is convex in z, with a kink on top of the bilge.
void demand_parallel_body(const HullForm& form) {
  constexpr double k_least_body = 0.01;  // of the length
  const Stations s = stations(form);
  double most = std::numeric_limits<double>::infinity();
  for (const double z : waterline_heights(form, {})) {
    const double up = z - form.draught;
    const double stem = s.stem + (wedge(form) ? 0 : up / std::tan(form.stem_angle));
    const double transom = s.transom - (wedge(form) ? 0 : k_transom_rake * up);
    most = std::min(most, (stem - transom - k_least_body * form.length) / breadth_ratio(form, z));
  }
  const double stern = wedge(form) ? 0 : form.stern_length;
  if (form.bow_length + stern > most)
    refuse(wedge(form) ? "bow_length" : "bow_length + stern_length", form.bow_length + stern,
           most > 0 ? fmt::format("at most {:.6g} m, which leaves a parallel body from keel to deck", most)
                    : "none: stem_angle_deg and depth leave no length at the keel");
}

}  // namespace

void demand_sensible(const HullForm& form) {
  constexpr int k_fewest = 200, k_most = 200000;
  if (form.triangles < k_fewest || form.triangles > k_most)
    refuse("triangles", form.triangles, fmt::format("{} to {}", k_fewest, k_most));
  demand_lengths(form);
  if (!wedge(form)) {
    demand_angles(form);
    demand_bottom(form);
  }
  demand_parallel_body(form);
}

}  // namespace nilas::hull
