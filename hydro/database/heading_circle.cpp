#include "hydro/database/heading_circle.h"

#include <algorithm>
#include <cmath>

namespace nilas::hydro {

/// Share of the modes' scales below which a term counts as zero: BEM results have three to four digits.
constexpr double k_same = 1e-3;

double body_size(const Database& database) {
  double mass = 0;
  for (const Mat6& a : database.added_mass) mass = std::max(mass, a.diagonal().head<3>().cwiseAbs().sum());
  return std::cbrt(mass / database.density);
}

Vec6 mode_scale(const Database& database, const std::vector<Mat6>& matrices) {
  Vec6 peak = Vec6::Zero();
  for (const Mat6& matrix : matrices) peak = peak.cwiseMax(Vec6(matrix.diagonal().cwiseAbs()));
  const double translation = peak.head<3>().maxCoeff(), size = body_size(database);
  const double rotation = std::max(peak.tail<3>().maxCoeff(), translation * size * size);
  Vec6 scale;
  scale << Vec3::Constant(translation), Vec3::Constant(rotation);
  return scale;
}

/// Damping and loads come from differences and phases, whose digits are fewer.
constexpr double k_same_load = 1e-2;

namespace {

bool sides_are_uncoupled(const Database& database, const std::vector<Mat6>& matrices, double share) {
  const Vec6 scale = mode_scale(database, matrices);
  for (const Mat6& a : matrices)
    for (const int i : {0, 2, 4})
      for (const int j : {1, 3, 5})
        if (std::max(std::abs(a(i, j)), std::abs(a(j, i))) > share * std::sqrt(scale[i] * scale[j])) return false;
  return true;
}

ComplexVec6 mirror_image(ComplexVec6 load) {
  for (const int i : {1, 3, 5}) load[i] = -load[i];
  return load;
}

/// Largest load over all frequencies and headings, for forces and for moments.
Vec6 load_scale(const Database& database) {
  double force = 0, moment = 0;
  for (const auto& of_frequency : database.excitation)
    for (const ComplexVec6& load : of_frequency) {
      force = std::max(force, load.head<3>().cwiseAbs().maxCoeff());
      moment = std::max(moment, load.tail<3>().cwiseAbs().maxCoeff());
    }
  Vec6 scale;
  scale << Vec3::Constant(force), Vec3::Constant(std::max(moment, force * body_size(database)));
  return scale;
}

/// Whether loads of headings that are mirror images of each other, or of themselves, are mirror images too.
bool loads_are_mirrored(const Database& database) {
  constexpr double k_on_plane = 1e-4;  // [rad]
  if (database.excitation.empty()) return true;
  const Vec6 allowed = k_same_load * load_scale(database);
  for (std::size_t h = 0; h < database.heading.size(); ++h)
    for (std::size_t other = h; other < database.heading.size(); ++other) {
      const double apart = std::remainder(database.heading[h] + database.heading[other], 2 * k_pi);
      if (std::abs(apart) > k_on_plane) continue;
      for (const auto& loads : database.excitation)
        if (((loads[h] - mirror_image(loads[other])).cwiseAbs().array() > allowed.array()).any()) return false;
    }
  return true;
}

}  // namespace

bool is_symmetric_port_starboard(const Database& database) {
  return sides_are_uncoupled(database, database.added_mass, k_same) &&
         sides_are_uncoupled(database, database.damping, k_same_load) && loads_are_mirrored(database);
}

bool is_round(const Database& database) {
  const Vec6 scale = mode_scale(database, database.added_mass);
  return std::all_of(database.added_mass.begin(), database.added_mass.end(), [&](const Mat6& a) {
    return std::abs(a(0, 0) - a(1, 1)) <= k_same * scale[0] && std::abs(a(3, 3) - a(4, 4)) <= k_same * scale[3] &&
           std::abs(a(0, 4) + a(1, 3)) <= k_same * std::sqrt(scale[0] * scale[3]);
  });
}

namespace {

/// A body of revolution has loads with one harmonic, whose squares have two; four directions integrate them exactly.
std::vector<CircleHeading> turned_circle(const Database& database) {
  constexpr int k_directions = 4;
  std::vector<CircleHeading> circle;
  for (int n = 0; n < k_directions; ++n) {
    const double turned = 2 * k_pi * n / k_directions;
    circle.push_back({database.heading.front() + turned, 2 * k_pi / k_directions, 0, false, turned});
  }
  return circle;
}

/// An angle in [0, 2 pi).
double on_circle(double angle) {
  const double turns = angle / (2 * k_pi);
  return 2 * k_pi * (turns - std::floor(turns));
}

/// Each heading once, with its mirror image where the hull is symmetric.
std::vector<CircleHeading> known_headings(const Database& database) {
  constexpr double k_twice = 1e-6;  // headings this close are the same [rad]
  std::vector<CircleHeading> known;
  const auto add = [&](double heading, std::size_t source, bool mirrored) {
    const double angle = on_circle(heading + 0.5 * k_twice) - 0.5 * k_twice;
    const bool there = std::any_of(known.begin(), known.end(),
                                   [&](const CircleHeading& one) { return std::abs(one.heading - angle) < k_twice; });
    if (!there) known.push_back({angle, 0, source, mirrored, 0});
  };
  for (std::size_t h = 0; h < database.heading.size(); ++h) add(database.heading[h], h, false);
  if (is_symmetric_port_starboard(database))
    for (std::size_t h = 0; h < database.heading.size(); ++h) add(-database.heading[h], h, true);
  std::sort(known.begin(), known.end(),
            [](const CircleHeading& a, const CircleHeading& b) { return a.heading < b.heading; });
  return known;
}

}  // namespace

std::vector<CircleHeading> heading_circle(const Database& database) {
  if (database.excitation.empty() || database.heading.empty()) return {};
  if (database.heading.size() == 1) return is_round(database) ? turned_circle(database) : std::vector<CircleHeading>{};
  std::vector<CircleHeading> circle = known_headings(database);
  constexpr double k_widest_gap = 45.5 * k_deg;  // with room for rounding
  for (std::size_t h = 0; h < circle.size(); ++h) {
    const std::size_t next = (h + 1) % circle.size();
    const double gap = circle[next].heading - circle[h].heading + (next == 0 ? 2 * k_pi : 0);
    if (gap > k_widest_gap) return {};
    circle[h].weight += 0.5 * gap;
    circle[next].weight += 0.5 * gap;
  }
  return circle;
}

ComplexVec6 excitation_of(const Database& database, std::size_t frequency, const CircleHeading& heading) {
  ComplexVec6 load = database.excitation[frequency][heading.source];
  if (heading.mirrored) load = mirror_image(load);
  if (heading.turned == 0) return load;
  const Mat3 turn = Eigen::AngleAxisd(heading.turned, Vec3::UnitZ()).toRotationMatrix();
  ComplexVec6 turned;
  turned << turn * load.head<3>(), turn * load.tail<3>();
  return turned;
}

}  // namespace nilas::hydro
