#include "apps/report/floe_outlines.h"

#include <charconv>
#include <cmath>
#include <fstream>
#include <limits>
#include <map>
#include <string>

#include "core/base/error.h"

namespace nilas {

namespace {

struct StoredPose {
  std::int64_t id = 0;
  Pose pose;
};

/// A row of bodies.csv; the name, which may hold commas, lies between what is read from the left and from the right.
struct StoredRow {
  double t = 0;
  StoredPose body;
};

StoredRow read_row(const std::string& line, const std::string& place) {
  constexpr int k_after_name = 13;
  std::size_t from = line.size();
  for (int k = 0; k < k_after_name && from != std::string::npos && from > 0; ++k) from = line.rfind(',', from - 1);
  double left[2] = {}, right[7] = {};  // time and id; position and quaternion
  const auto read = [&](std::size_t begin, double* values, int count) {
    for (int k = 0; k < count; ++k) {
      const auto [end, fault] = std::from_chars(line.data() + begin, line.data() + line.size(), values[k]);
      if (fault != std::errc{}) throw InputError(place + ": is no row of bodies.csv");
      begin = static_cast<std::size_t>(end - line.data()) + 1;
    }
  };
  if (from == std::string::npos) throw InputError(place + ": is no row of bodies.csv");
  read(0, left, 2);
  read(from + 1, right, 7);
  StoredRow row;
  row.t = left[0];
  row.body.id = static_cast<std::int64_t>(left[1]);
  row.body.pose.p = Vec3(right[0], right[1], right[2]);
  row.body.pose.q = Quat(right[3], right[4], right[5], right[6]);
  return row;
}

/// Poses at the stored instant nearest to t.
std::map<std::int64_t, Pose> poses_near(const std::filesystem::path& bodies_csv, double t) {
  std::map<std::int64_t, Pose> poses;
  std::ifstream in(bodies_csv);
  std::string line;
  std::getline(in, line);
  double best = std::numeric_limits<double>::infinity(), instant = 0;
  while (std::getline(in, line)) {
    const StoredRow row = read_row(line, bodies_csv.string());
    if (const double distance = std::abs(row.t - t); distance < best) {
      best = distance;
      instant = row.t;
      poses.clear();
    }
    if (row.t == instant) poses[row.body.id] = row.body.pose;
  }
  return poses;
}

}  // namespace

std::vector<std::vector<Vec3>> floe_outlines(const std::filesystem::path& bodies_csv, const Bodies& bodies, int vessel,
                                             const Vec3& com_V, double t) {
  std::vector<std::vector<Vec3>> outlines;
  const auto poses = poses_near(bodies_csv, t);
  if (poses.empty()) return outlines;
  const auto hull_pose = poses.find(bodies.id[static_cast<std::size_t>(vessel)]);
  if (hull_pose == poses.end()) throw InputError(bodies_csv.string() + ": lacks the vessel");
  const Pose& hull = hull_pose->second;
  for (std::size_t b = 0; b < bodies.id.size(); ++b) {
    const auto found = poses.find(bodies.id[b]);
    // a floe that broke has no pose any more
    if (bodies.kind[b] != BodyKind::floe || found == poses.end()) continue;
    const Pose& pose = found->second;
    std::vector<Vec3> outline;
    for (const Vec2& corner : bodies.shape[b]->outline) {
      const Vec3 p = pose.p + pose.q * Vec3(corner.x(), corner.y(), 0.5 * bodies.shape[b]->thickness);
      outline.push_back(hull.q.inverse() * (p - hull.p) + com_V);
    }
    outlines.push_back(std::move(outline));
  }
  return outlines;
}

}  // namespace nilas
