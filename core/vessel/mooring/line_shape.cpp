#include "core/vessel/mooring/line_shape.h"

#include <algorithm>
#include <cmath>

namespace nilas::vessel {

std::vector<Vec3> line_shape(const MooringLine& line, std::optional<double> bed, const Vec3& fairlead) {
  constexpr int k_pieces = 32;
  const auto* chain = std::get_if<CatenaryLine>(&line.form);
  const LineForce pull = line_force(line, bed, fairlead);
  if (chain == nullptr) return {line.anchor, fairlead};
  // The part off the bed hangs with the horizontal pull H; its tension is vertical over V from its foot to the top.
  const double H = pull.on_fairlead.head<2>().norm(), top = -pull.on_fairlead.z(), w = chain->weight;
  const double foot = bed && w > 0 ? std::max(0.0, top - w * chain->length) : top - w * chain->length;
  const double hanging = (top - foot) / w;
  const Vec3 away = H > 0 ? Vec3(-pull.on_fairlead.x() / H, -pull.on_fairlead.y() / H, 0) : Vec3::Zero();
  const auto above_foot = [&](double s) -> Vec3 {
    const double V = foot + w * s;
    const double run = H > 0 ? H / w * (std::asinh(V / H) - std::asinh(foot / H)) + H * s / chain->stiffness : 0;
    const double rise = (std::hypot(H, V) - std::hypot(H, foot)) / w + 0.5 * (V + foot) * s / chain->stiffness;
    return run * away + rise * Vec3::UnitZ();
  };
  const Vec3 lowest = fairlead - above_foot(hanging);
  Vec3 start = line.anchor;
  if (const auto resting = axis_on_bed(line, bed)) start.z() = std::max(start.z(), *resting);
  std::vector<Vec3> points{start};
  for (int k = 0; k <= k_pieces; ++k) points.push_back(lowest + above_foot(hanging * k / k_pieces));
  return points;
}

}  // namespace nilas::vessel
