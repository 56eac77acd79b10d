#include "core/sim/step/structure_record.h"

#include <algorithm>
#include <tuple>

#include "core/base/order_free_sum.h"
#include "core/sim/world/load_axes.h"

namespace nilas::sim {

void add_structure_loads(const World& world, const contact::StepMotion& motion, std::vector<StructureRecord>& records) {
  const auto& structures = world.parts.info.structures;
  // Broken floes change the indices of the bodies behind them, but not their order.
  std::vector<int> places;
  for (std::size_t b = 0; b < world.parts.bodies.id.size(); ++b)
    if (is_structure(world.parts.bodies, b)) places.push_back(static_cast<int>(b));
  const auto structure_of = [&](int body) {
    const auto found = std::lower_bound(places.begin(), places.end(), body);
    return found != places.end() && *found == body ? found - places.begin() : -1;
  };
  struct Sums {
    OrderFreeVectorSum force, torque, ice;
  };
  std::vector<Sums> sums(structures.size());
  records.resize(structures.size());
  for (std::size_t i = 0; i < motion.points.size(); ++i) {
    const detect::ContactPoint& c = motion.points[i];
    for (const auto& [body, other, sign] : {std::tuple(c.a, c.b, -1.0), std::tuple(c.b, c.a, 1.0)}) {
      const auto k = structure_of(body);
      if (k < 0 || motion.impulses[i].isZero(0)) continue;
      Sums& sum = sums[k];
      sum.force.add(sign * motion.impulses[i]);
      sum.torque.add((c.p - motion.p[body]).cross(sign * motion.impulses[i]));
      if (!motion.couples.empty()) sum.torque.add(sign * motion.couples[i]);
      if (world.parts.bodies.kind[other] != bodies::BodyKind::floe) continue;
      records[k].touches_ice = true;
      sum.ice.add(sign * motion.impulses[i]);
    }
  }
  for (std::size_t k = 0; k < sums.size(); ++k) {
    records[k].contact += {sums[k].force.value() / world.step, sums[k].torque.value() / world.step};
    records[k].ice += sums[k].ice.value() / world.step;
  }
}

}  // namespace nilas::sim
