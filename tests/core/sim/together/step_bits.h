#pragma once
/// Everything that a step leaves, as bits.
#include <bit>
#include <cstdint>
#include <vector>

#include "contact/measure/measure.h"
#include "core/sim/account/step_record.h"

namespace nilas::test {

/// All values of a record but its wall times.
class StepBits {
 public:
  explicit StepBits(const sim::StepRecord& record) {
    add(record.step, record.floes, record.contacts, record.islands, record.iterations, record.solver_short,
        record.positions_corrected, record.detection.fallbacks, static_cast<int>(record.status));
    words_.push_back(record.state_hash);
    for (const auto& residual : contact::residual_columns()) add(record.residuals.*residual.member);
    const sim::Ledger& l = record.ledger;
    add(record.t, record.penetration_max, record.penetration_mean, record.momentum_imbalance, record.momentum_scale,
        record.angular_momentum_imbalance, record.angular_momentum_scale, l.kinetic, l.potential, l.friction, l.impact,
        l.stabilisation, l.fracture, l.crushing, l.elastic, l.damping, l.integrator, l.imbalance);
    for (const fracture::FractureEvent& event : record.broken) {
      add(event.floe, event.p_G.x(), event.p_G.y(), event.energy, event.length, event.radius, event.ratio, event.brash);
      for (const std::int64_t piece : event.pieces) add(piece);
    }
    for (const double work : l.works) add(work);
    for (const double value : record.module_values) add(value);
    if (record.vessel) add_vessel(*record.vessel);
  }
  friend bool operator==(const StepBits&, const StepBits&) = default;

 private:
  template <class... Values>
  void add(const Values&... values) {
    (words_.push_back(std::bit_cast<std::uint64_t>(static_cast<double>(values))), ...);
  }
  void add_wrench(const Wrench& w) {
    add(w.force.x(), w.force.y(), w.force.z(), w.torque.x(), w.torque.y(), w.torque.z());
  }
  void add_vessel(const sim::VesselRecord& vessel) {
    add_wrench(vessel.contact);
    add_wrench({vessel.contact_port, vessel.contact_starboard});
    add_wrench({vessel.state.pose.p, vessel.state.v});
    add_wrench({vessel.state.w, vessel.state.pose.q.vec()});
    add_wrench(vessel.solver_residual);
    add_wrench(vessel.law_residual);
    if (vessel.hydro) add_wrench(*vessel.hydro);
    for (const Wrench& load : vessel.module_loads) add_wrench(load);
    for (const sim::PartRecord& part : vessel.parts) {
      add_wrench(part.joint);
      add_wrench(part.contact);
      for (const double x : part.coordinates) add(x);
      for (const double x : part.rates) add(x);
    }
    for (const double tension : vessel.rods) add(tension);
    if (!vessel.carriage) return;
    add_wrench(vessel.carriage->about_com);
    add_wrench(vessel.carriage->about_joint);
    for (const double cell : vessel.carriage->cells) add(cell);
  }
  std::vector<std::uint64_t> words_;
};

}  // namespace nilas::test
