#include "core/sim/account/ledger.h"

#include <algorithm>
#include <cmath>

namespace nilas::sim {

namespace {

double spin_energy(const Mat3& inertia, const Vec3& w) { return 0.5 * w.dot(inertia * w); }

/// I w at the attitude where the contacts were found, in G.
Vec3 spin_momentum(const bodies::Bodies& bodies, const contact::StepMotion& motion, std::size_t b, const Vec3& w) {
  const Mat3& R = motion.R[b];
  return R * (bodies.inertia_B[b] * (R.transpose() * w));
}

/// Kinetic energy of the water that moves with a free body [J]. Its momentum p belongs to the velocity v - c relative
/// to the flow c, and the energy is (v - c; w) . p / 2 + c . p: its change is the work of the water's inertia on the
/// body.
double water_energy(const bodies::Bodies& bodies, std::size_t b, const Mat3& R, const Vec3& v, const Vec3& w) {
  Vec6 twist_B;
  twist_B << R.transpose() * (v - bodies.flow), R.transpose() * w;
  const Vec6 momentum = bodies.added_mass_B[b] * twist_B;
  return 0.5 * twist_B.dot(momentum) + (R.transpose() * bodies.flow).dot(momentum.head<3>());
}

/// The work of these loads over the step [J]: their impulse times the mean of the velocities before and after.
double work(const bodies::Bodies& bodies, const contact::StepMotion& motion, const std::vector<Wrench>& loads) {
  double sum = 0;
  for (int k = 0; k < bodies.size(); ++k) {
    if (!bodies.moves(k)) continue;
    const auto b = static_cast<std::size_t>(k);
    sum += loads[b].force.dot(motion.before.v[b] + motion.after.v[b]) +
           loads[b].torque.dot(motion.before.w[b] + motion.after.w[b]);
  }
  return 0.5 * motion.h * sum;
}

/// What rolling and spinning friction take at a contact, rigid or elastic [J].
double couple_loss(const contact::StepMotion& motion, std::size_t contact) {
  if (motion.couples.empty()) return 0;
  const auto a = static_cast<std::size_t>(motion.points[contact].a);
  const auto b = static_cast<std::size_t>(motion.points[contact].b);
  return -0.5 *
         motion.couples[contact].dot(motion.before.w[b] + motion.after.w[b] - motion.before.w[a] - motion.after.w[a]);
}

}  // namespace

EnergyAccount::EnergyAccount(const std::vector<std::string>& work_names, double kinetic, double potential)
    : start_(kinetic + potential), put_in_(std::abs(kinetic)), potential_before_(potential) {
  ledger_.works.assign(work_names.size(), 0);
  const auto place = [&](const char* name) {
    return static_cast<std::size_t>(std::find(work_names.begin(), work_names.end(), name) - work_names.begin());
  };
  carriage_ = place("carriage");
  joints_ = place("joints");
  ledger_.kinetic = kinetic;
  ledger_.potential = potential;
}

void EnergyAccount::book_work(std::size_t k, double work) {
  ledger_.works[k] += work;
  put_in_ += std::abs(work);
}

/// Books the works of carriage and joints in a motion. What they do to the kinetic energy is no error of the
/// integrator.
void EnergyAccount::book_works(const vessel::JointAccount::Motion& works) {
  ledger_.integrator += works.carriage + works.springs;
  if (works.carriage != 0) book_work(carriage_, works.carriage);
  if (works.springs != 0) book_work(joints_, works.springs);
}

void EnergyAccount::motion_before_impulses(double kinetic, const vessel::JointAccount::Motion& works) {
  ledger_.integrator -= kinetic - ledger_.kinetic;
  book_works(works);
}

void EnergyAccount::velocity_step(const bodies::Bodies& bodies, const contact::StepMotion& motion,
                                  const StepLoads& loads, const VesselAccount& vessel) {
  conservative_work_ = work(bodies, motion, *loads.gravity);
  for (const auto* wrenches : loads.conservative) conservative_work_ += work(bodies, motion, *wrenches);
  for (std::size_t k = 0; k < loads.working.size(); ++k) book_work(k, work(bodies, motion, *loads.working[k]));
  if (vessel.joints != nullptr) {
    if (vessel.joints->carriage_work != 0) book_work(carriage_, vessel.joints->carriage_work);
    book_work(joints_, vessel.joints->spring_work);
  }
  if (vessel.on_carriage) {
    const auto b = static_cast<std::size_t>(vessel.index);
    book_work(carriage_, 0.5 * motion.h *
                             (vessel.carriage.force.dot(motion.before.v[b] + motion.after.v[b]) +
                              vessel.carriage.torque.dot(motion.before.w[b] + motion.after.w[b])));
  }
  for (std::size_t i = 0; i < motion.points.size(); ++i) {
    ledger_.friction += couple_loss(motion, i);
    const Vec3 mean = 0.5 * (contact::relative_velocity(motion, motion.before, i) +
                             contact::relative_velocity(motion, motion.after, i));
    if (!motion.springs.empty() && motion.springs[i].exists) {
      ledger_.friction += motion.springs[i].friction;
      ledger_.damping += motion.springs[i].damping;
      ledger_.integrator -= motion.impulses[i].dot(mean) + motion.springs[i].friction + motion.springs[i].damping;
      continue;
    }
    const double normal = motion.normal_impulses[i].dot(mean);
    // The speed that the stabilisation asks for is in the velocity after alone, so half of it is in the mean.
    const double asked = 0.5 * motion.speed_asked[i] * motion.normal_impulses[i].dot(motion.points[i].n);
    (motion.points[i].crushes() ? ledger_.crushing : ledger_.impact) -= normal - asked;
    ledger_.stabilisation -= asked;
    ledger_.friction -= motion.impulses[i].dot(mean) - normal;
  }
  book_springs(motion);
  kinetic_after_velocity_ = 0;
  for (int k = 0; k < bodies.size(); ++k) {
    if (!bodies.moves(k)) continue;
    const auto b = static_cast<std::size_t>(k);
    kinetic_after_velocity_ += 0.5 * bodies.mass[b] * motion.after.v[b].squaredNorm();
    // On a carriage the momenta balance between the two attitudes, so the spin energy takes the mixed form.
    if (k == vessel.index && vessel.on_carriage)
      kinetic_after_velocity_ +=
          spin_energy(vessel.inertia_after, motion.after.w[b]) +
          0.5 * motion.after.w[b].dot((vessel.inertia_after - vessel.inertia_before) * motion.before.w[b]);
    else
      kinetic_after_velocity_ += 0.5 * motion.after.w[b].dot(spin_momentum(bodies, motion, b, motion.after.w[b]));
    if (bodies.has_added_mass())
      kinetic_after_velocity_ += water_energy(bodies, b, motion.R[b], motion.after.v[b], motion.after.w[b]);
  }
}

/// The energy that the springs hold. What their losses do not explain of its change is the time stepping's.
void EnergyAccount::book_springs(const contact::StepMotion& motion) {
  double stored = 0;
  for (const contact::SpringStep& spring : motion.springs) stored += spring.stored;
  ledger_.integrator -= stored - ledger_.elastic;
  ledger_.elastic = stored;
}

void EnergyAccount::position_step(double kinetic, double potential, const contact::Velocities& pseudo,
                                  const contact::StepMotion& motion, const StepLoads& loads,
                                  const vessel::JointAccount::Motion& works) {
  double along_pseudo = 0;
  if (!pseudo.v.empty()) {
    const auto add = [&](const std::vector<Wrench>& wrenches) {
      for (std::size_t b = 0; b < wrenches.size(); ++b)
        along_pseudo += motion.h * (wrenches[b].force.dot(pseudo.v[b]) + wrenches[b].torque.dot(pseudo.w[b]));
    };
    add(*loads.gravity);
    for (const auto* wrenches : loads.conservative) add(*wrenches);
  }
  ledger_.stabilisation += along_pseudo;
  ledger_.integrator -=
      (kinetic - kinetic_after_velocity_) + (potential - potential_before_) + conservative_work_ + along_pseudo;
  book_works(works);
  settle_energies(kinetic, potential);
}

void EnergyAccount::whole_step(double kinetic, double potential, const std::vector<double>& works, double friction,
                               double impact) {
  for (std::size_t k = 0; k < works.size(); ++k) {
    ledger_.works[k] += works[k];
    put_in_ += std::abs(works[k]);
  }
  ledger_.friction += friction;
  ledger_.impact += impact;
  settle_energies(kinetic, potential);
}

double EnergyAccount::breaking(double kinetic, double potential) {
  const double lost = (ledger_.kinetic - kinetic) + (ledger_.potential - potential);
  ledger_.fracture += lost;
  settle_energies(kinetic, potential);
  return lost;
}

void EnergyAccount::settle_energies(double kinetic, double potential) {
  ledger_.kinetic = kinetic;
  ledger_.potential = potential;
  potential_before_ = potential;
  double works = 0;
  for (const double w : ledger_.works) works += w;
  ledger_.imbalance = ledger_.kinetic + ledger_.potential + ledger_.elastic + ledger_.damping + ledger_.friction +
                      ledger_.impact + ledger_.stabilisation + ledger_.fracture + ledger_.crushing +
                      ledger_.integrator - works - start_;
}

void EnergyAccount::save(StateWriter out) const {
  out.add("kinetic", ledger_.kinetic);
  out.add("potential", ledger_.potential);
  out.add("works", ledger_.works);
  out.add("friction", ledger_.friction);
  out.add("impact", ledger_.impact);
  out.add("stabilisation", ledger_.stabilisation);
  out.add("fracture", ledger_.fracture);
  out.add("crushing", ledger_.crushing);
  out.add("integrator", ledger_.integrator);
  out.add("imbalance", ledger_.imbalance);
  out.add("elastic", ledger_.elastic);
  out.add("damping", ledger_.damping);
  out.add("start", start_);
  out.add("put_in", put_in_);
  out.add("kinetic_after_velocity", kinetic_after_velocity_);
  out.add("conservative_work", conservative_work_);
  out.add("potential_before", potential_before_);
}

void EnergyAccount::restore(const StateReader& in) {
  in.get("kinetic", ledger_.kinetic);
  in.get("potential", ledger_.potential);
  in.get("works", ledger_.works, ledger_.works.size());
  in.get("friction", ledger_.friction);
  in.get("impact", ledger_.impact);
  in.get("stabilisation", ledger_.stabilisation);
  in.get("fracture", ledger_.fracture);
  in.get("crushing", ledger_.crushing);
  in.get("integrator", ledger_.integrator);
  in.get("imbalance", ledger_.imbalance);
  in.get("elastic", ledger_.elastic);
  in.get("damping", ledger_.damping);
  in.get("start", start_);
  in.get("put_in", put_in_);
  in.get("kinetic_after_velocity", kinetic_after_velocity_);
  in.get("conservative_work", conservative_work_);
  in.get("potential_before", potential_before_);
}

double kinetic_energy(const bodies::Bodies& bodies) {
  double sum = 0;
  for (int k = 0; k < bodies.size(); ++k) {
    if (!bodies.moves(k)) continue;
    const auto b = static_cast<std::size_t>(k);
    // I_G = R I_B R^T, so the spin energy is that of the angular velocity in body axes.
    const Vec3 w_B = bodies.R_GB[b].transpose() * bodies.w_GB[b];
    sum += 0.5 * bodies.mass[b] * bodies.v_GB[b].squaredNorm() + spin_energy(bodies.inertia_B[b], w_B);
    if (bodies.has_added_mass()) sum += water_energy(bodies, b, bodies.R_GB[b], bodies.v_GB[b], bodies.w_GB[b]);
  }
  return sum;
}

double weight_energy(const bodies::Bodies& bodies, const Vec3& gravity) {
  double sum = 0;
  for (int k = 0; k < bodies.size(); ++k)
    if (bodies.moves(k)) sum -= bodies.mass[k] * gravity.dot(bodies.p_GB[k]);
  return sum;
}

MomentumBalance& MomentumBalance::operator+=(const MomentumBalance& other) {
  linear += other.linear;
  linear_scale += other.linear_scale;
  angular += other.angular;
  angular_scale += other.angular_scale;
  return *this;
}

MomentumBalance momentum_balance(const bodies::Bodies& bodies, const contact::StepMotion& motion,
                                 const StepLoads& loads, const VesselAccount& vessel) {
  Vec3 linear = Vec3::Zero(), angular = Vec3::Zero();
  MomentumBalance balance;
  const auto add = [&](const Vec3& point, const Vec3& impulse, const Vec3& couple, double sign) {
    linear += sign * impulse;
    const Vec3 moment = point.cross(impulse) + couple;
    angular += sign * moment;
    balance.linear_scale += impulse.norm();
    balance.angular_scale += moment.norm();
  };
  // A change of momentum is rounded as the momentum is. Without it a body that nothing acts on would be off by all of
  // its scale.
  const auto note_momentum = [&](std::size_t b) {
    const Vec3 momentum = bodies.mass[b] * motion.before.v[b];
    balance.linear_scale += momentum.norm();
    balance.angular_scale +=
        (motion.p[b].cross(momentum) + spin_momentum(bodies, motion, b, motion.before.w[b])).norm();
  };
  for (int k = 0; k < bodies.size(); ++k) {
    if (!bodies.moves(k)) continue;
    const auto b = static_cast<std::size_t>(k);
    note_momentum(b);
    Vec3 spin = spin_momentum(bodies, motion, b, motion.after.w[b] - motion.before.w[b]);
    if (k == vessel.index && vessel.on_carriage)
      spin = vessel.inertia_after * motion.after.w[b] - vessel.inertia_before * motion.before.w[b];
    add(motion.p[b], bodies.mass[b] * (motion.after.v[b] - motion.before.v[b]), spin, 1);
    if (bodies.has_added_mass()) {
      Vec6 change;
      change << motion.after.v[b] - motion.before.v[b], motion.after.w[b] - motion.before.w[b];
      const Vec6 of_water = bodies::turned(bodies.added_mass_B[b], motion.R[b]) * change;
      add(motion.p[b], of_water.head<3>(), of_water.tail<3>(), 1);
    }
    // Each source is added by itself: weight and buoyancy that cancel still set the scale for rounding.
    const auto add_loads = [&](const std::vector<Wrench>& wrenches) {
      add(motion.p[b], motion.h * wrenches[b].force, motion.h * wrenches[b].torque, -1);
    };
    add_loads(*loads.gravity);
    for (const auto* wrenches : loads.conservative) add_loads(*wrenches);
    for (const auto* wrenches : loads.working) add_loads(*wrenches);
    if (k == vessel.index && vessel.on_carriage)
      add(motion.p[b], motion.h * vessel.carriage.force, motion.h * vessel.carriage.torque, -1);
    const int of_vessel = k - vessel.index;
    if (vessel.joints == nullptr || of_vessel < 0 || of_vessel >= static_cast<int>(vessel.joints->held.size()))
      continue;
    const Wrench& held = vessel.joints->held[of_vessel];
    add(motion.p[b], motion.h * held.force, motion.h * held.torque, -1);
  }
  for (std::size_t i = 0; i < motion.points.size(); ++i) {
    const detect::ContactPoint& c = motion.points[i];
    const Vec3 couple = motion.couples.empty() ? Vec3(Vec3::Zero()) : motion.couples[i];
    if (bodies.moves(c.b)) add(c.p, motion.impulses[i], couple, -1);
    if (bodies.moves(c.a)) add(c.p, -motion.impulses[i], -couple, -1);
  }
  balance.linear = linear.norm();
  balance.angular = angular.norm();
  return balance;
}

}  // namespace nilas::sim
