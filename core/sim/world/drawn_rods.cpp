#include "core/sim/world/drawn_rods.h"

namespace nilas::sim {

std::vector<bodies::DrawnLine> drawn_rods(const WorldParts& parts) {
  std::vector<bodies::DrawnLine> lines;
  if (!parts.vessel || !parts.vessel_model || parts.vessel_model->rods.empty()) return lines;
  const vessel::VesselModel& model = *parts.vessel_model;
  const VecX& tensions = parts.vessel->joint_account().rods;
  for (std::size_t k = 0; k < model.rods.size(); ++k) {
    const vessel::RodModel& rod = model.rods[k];
    const Pose in_V = rod.on < 0 ? Pose{Quat::Identity(), model.mass.com} : model.parts[rod.on].in_V;
    const auto body = static_cast<std::size_t>(parts.vessel_index + 1 + rod.on);
    const Vec3 at_B = in_V.q.conjugate() * (rod.at_V - in_V.p);
    const auto place = static_cast<Eigen::Index>(k);
    lines.push_back({bodies::DrawnLine::Kind::rod,
                     rod.name,
                     place < tensions.size() ? tensions[place] : 0,
                     {parts.bodies.p_GB[body] + parts.bodies.R_GB[body] * at_B, rod.to_G}});
  }
  return lines;
}

}  // namespace nilas::sim
