#include "apps/compare/scenes/run/motion.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "core/base/csv.h"

namespace nilas::compare {

namespace {

Quat turned(const Quat& q, const Vec3& angle) {
  const double size = angle.norm();
  return size > 0 ? Quat(Eigen::AngleAxisd(size, angle / size)) * q : q;
}

/// The distance between two samples; nothing if no body is in both.
std::optional<Distance> distance(const Sample& a, const Sample& b) {
  Distance apart;
  apart.t = a.t;
  const double late = a.t - b.t;
  double squares = 0;
  std::size_t shared = 0;
  for (const auto& [id, one] : a.bodies) {
    const auto found = b.bodies.find(id);
    if (found == b.bodies.end()) continue;
    ++shared;
    const SampledBody& other = found->second;
    const Vec3 way = one.p - (other.p + late * other.v);
    squares += way.squaredNorm();
    apart.largest = std::max(apart.largest, way.norm());
    apart.axes = apart.axes.cwiseMax(way.cwiseAbs());
    apart.turn = std::max(apart.turn, one.q.angularDistance(turned(other.q, late * other.w)));
  }
  apart.same_bodies = shared == a.bodies.size() && shared == b.bodies.size();
  if (shared == 0) return std::nullopt;
  apart.rms = std::sqrt(squares / static_cast<double>(shared));
  return apart;
}

}  // namespace

SampledMotion read_motion(const std::filesystem::path& bodies_csv) {
  const auto c = csv_columns(bodies_csv, {"time_s", "id", "x_m", "y_m", "z_m", "qw", "qx", "qy", "qz", "vx_m_s",
                                          "vy_m_s", "vz_m_s", "wx_rad_s", "wy_rad_s", "wz_rad_s"});
  SampledMotion motion;
  for (std::size_t k = 0; k < c[0].size(); ++k) {
    if (motion.empty() || motion.back().t != c[0][k]) motion.push_back({c[0][k], {}});
    motion.back().bodies[static_cast<std::int64_t>(c[1][k])] = {
        Vec3(c[2][k], c[3][k], c[4][k]), Vec3(c[9][k], c[10][k], c[11][k]), Vec3(c[12][k], c[13][k], c[14][k]),
        Quat(c[5][k], c[6][k], c[7][k], c[8][k])};
  }
  return motion;
}

std::vector<Distance> distances(const SampledMotion& a, const SampledMotion& b) {
  std::vector<Distance> all;
  std::size_t k = 0;
  for (std::size_t i = 0; i < a.size(); ++i) {
    const double spacing = i > 0 ? a[i].t - a[i - 1].t : (a.size() > 1 ? a[1].t - a[0].t : 0);
    while (k + 1 < b.size() && std::abs(b[k + 1].t - a[i].t) <= std::abs(b[k].t - a[i].t)) ++k;
    if (k >= b.size() || std::abs(b[k].t - a[i].t) > 0.5 * spacing) continue;
    if (const auto apart = distance(a[i], b[k])) all.push_back(*apart);
  }
  return all;
}

double longest_path(const SampledMotion& motion) {
  double way = 0;
  for (const auto& sample : motion)
    for (const auto& [id, body] : sample.bodies)
      if (const auto start = motion.front().bodies.find(id); start != motion.front().bodies.end())
        way = std::max(way, (body.p - start->second.p).norm());
  return way;
}

}  // namespace nilas::compare
