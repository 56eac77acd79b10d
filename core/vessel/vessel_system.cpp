#include "core/vessel/vessel_system.h"

#include "core/base/error.h"
#include "core/vessel/tree/vessel_motion.h"

namespace nilas::vessel {

VesselMotion::VesselMotion(const VesselModel& model, double t0)
    : mass_(model.mass), inertia_factor_(model.mass.inertia), time_(t0), moves_before_(model.theta.has_value()) {
  NILAS_DEMAND(!model.theta || (*model.theta >= 0 && *model.theta <= 1));
  if (!model.fixed && !(model.mass.mass > 0)) throw InputError("vessel: the mass must be > 0 kg");
  if (!model.fixed && !geometry::physically_valid_inertia(model.mass.inertia))
    throw InputError(
        "vessel: the inertia about the centre of mass must be symmetric, its principal moments positive and none "
        "larger "
        "than the sum of the other two");
  state_.pose.q = model.pose_V.q.normalized();
  state_.pose.p = model.pose_V.p + state_.pose.q * model.mass.com;
}

void VesselMotion::move_before_impulses(double h) {
  NILAS_DEMAND(h > 0 && h_ == 0 && moved_for_ == 0);
  moved_for_ = h;
  move_before_step(h);
}

VesselBlock VesselMotion::begin(const Wrench& free, double h, const std::vector<Wrench>& on_parts) {
  NILAS_DEMAND(h > 0 && h_ == 0 && (moved_for_ == h || !moves_before_) && on_parts.size() == parts_.size());
  free_ = free;
  free_on_parts_ = on_parts;
  h_ = h;
  return begin_step();
}

void VesselMotion::finish(const Wrench& contact_impulse, const std::vector<Wrench>& on_parts) {
  NILAS_DEMAND(h_ > 0 && on_parts.size() == parts_.size());
  contact_on_parts_ = on_parts;
  finish_step(contact_impulse);
  time_ += h_;
  h_ = moved_for_ = 0;
}

void VesselMotion::abandon_step() {
  abandon_motion();
  h_ = moved_for_ = 0;
}

void VesselMotion::save(StateWriter out) const {
  NILAS_DEMAND(h_ == 0);
  out.add("time", time_);
  out.add("q", state_.pose.q);
  out.add("p", state_.pose.p);
  out.add("v", state_.v);
  out.add("w", state_.w);
  out.add("force", loads_.about_com.force);
  out.add("torque_about_com", loads_.about_com.torque);
  out.add("torque_about_joint", loads_.about_joint.torque);
  out.add("cells", loads_.cells);
  save_motion(out);
}

void VesselMotion::restore(const StateReader& in) {
  NILAS_DEMAND(h_ == 0);
  in.get("time", time_);
  in.get("q", state_.pose.q);
  in.get("p", state_.pose.p);
  in.get("v", state_.v);
  in.get("w", state_.w);
  in.get("force", loads_.about_com.force);
  in.get("torque_about_com", loads_.about_com.torque);
  loads_.about_joint.force = loads_.about_com.force;
  in.get("torque_about_joint", loads_.about_joint.torque);
  in.get("cells", loads_.cells);
  restore_motion(in);
}

void VesselMotion::follow(double t, const VesselState& hull, std::vector<PartState> parts) {
  NILAS_DEMAND(h_ == 0 && parts.size() == parts_.size());
  time_ = t;
  state_ = hull;
  parts_ = std::move(parts);
}

Mat3 VesselMotion::inertia_G() const {
  const Mat3 R = state_.pose.q.toRotationMatrix();
  return R * mass_.inertia * R.transpose();
}

Vec3 VesselMotion::turning(const Vec3& angular_momentum) const {
  const Mat3 R = state_.pose.q.toRotationMatrix();
  return R * inertia_factor_.solve(R.transpose() * angular_momentum);
}

namespace {

class FixedVessel : public VesselMotion {
 public:
  using VesselMotion::VesselMotion;
  Vec6 velocity_after_impulses() const override { return Vec6::Zero(); }
  void displace(const Vec6&, double) override {}
  bool can_move() const override { return false; }
  VecX coordinates() const override {
    VecX all(7);
    all << state_.pose.p, state_.pose.q.coeffs();
    return all;
  }

 protected:
  VesselBlock begin_step() override { return {MatX(0, 0), VecX(0), {MatX(6, 0), Vec6::Zero()}, {}}; }
  void finish_step(const Wrench&) override {}
  void save_motion(StateWriter&) const override {}
  void restore_motion(const StateReader&) override {}
};

std::unique_ptr<VesselMotion> make_motion(const VesselModel& model, double t0) {
  NILAS_DEMAND(!(model.fixed && model.carriage));
  if (model.is_jointed()) return make_jointed_vessel(model, t0);
  if (model.fixed) return std::make_unique<FixedVessel>(model, t0);
  return model.carriage ? make_carried_vessel(model, t0) : make_free_vessel(model, t0);
}

std::vector<std::string> names(const VesselModel& model) {
  if (!model.carriage) return {"vessel"};
  switch (model.carriage->balance) {
    case BalanceKind::six_cells:
      return {"vessel", "carriage", "force balance six-cells"};
    case BalanceKind::prismatic:
      return {"vessel", "carriage", "force balance prismatic"};
    case BalanceKind::rigid:
      break;
  }
  return {"vessel", "carriage", "force balance rigid"};
}

}  // namespace

struct VesselSystem::Implementation {
  std::unique_ptr<VesselMotion> motion;
  bool on_carriage;
  std::vector<std::string> built;
};

VesselSystem::VesselSystem(const VesselModel& model, double t0)
    : implementation_(std::make_unique<Implementation>(
          Implementation{make_motion(model, t0), model.carriage.has_value(), names(model)})) {}
VesselSystem::~VesselSystem() = default;
VesselSystem::VesselSystem(VesselSystem&&) noexcept = default;
VesselSystem& VesselSystem::operator=(VesselSystem&&) noexcept = default;

const VesselState& VesselSystem::state() const { return implementation_->motion->state(); }
double VesselSystem::time() const { return implementation_->motion->time(); }
bool VesselSystem::fixed() const { return !implementation_->motion->can_move(); }
bool VesselSystem::on_carriage() const { return implementation_->on_carriage; }
std::vector<std::string> VesselSystem::built() const { return implementation_->built; }

VesselRest VesselSystem::settle(const RestModel& rest, bool start_there) {
  return implementation_->motion->settle(rest, start_there);
}
void VesselSystem::move_before_impulses(double h) { implementation_->motion->move_before_impulses(h); }
VesselBlock VesselSystem::begin(const Wrench& free, double h, const std::vector<Wrench>& on_parts) {
  return implementation_->motion->begin(free, h, on_parts);
}
void VesselSystem::finish(const Wrench& contact_impulse, const std::vector<Wrench>& on_parts) {
  implementation_->motion->finish(contact_impulse, on_parts);
}
void VesselSystem::abandon_step() { implementation_->motion->abandon_step(); }
std::vector<Vec6> VesselSystem::part_velocities_after_impulses() const {
  return implementation_->motion->part_velocities_after_impulses();
}
const std::vector<PartState>& VesselSystem::parts() const { return implementation_->motion->parts(); }
const JointAccount& VesselSystem::joint_account() const { return implementation_->motion->joint_account(); }
Vec6 VesselSystem::velocity_after_impulses() const { return implementation_->motion->velocity_after_impulses(); }
void VesselSystem::displace(const Vec6& pseudo_twist, double h) { implementation_->motion->displace(pseudo_twist, h); }
const CarriageLoads& VesselSystem::carriage_loads() const { return implementation_->motion->loads(); }
double VesselSystem::spring_energy() const { return implementation_->motion->spring_energy(); }
VecX VesselSystem::coordinates() const { return implementation_->motion->coordinates(); }
void VesselSystem::follow(double t, const VesselState& hull, std::vector<PartState> parts) {
  implementation_->motion->follow(t, hull, std::move(parts));
}
void VesselSystem::save(StateWriter out) const { implementation_->motion->save(out); }
void VesselSystem::restore(const StateReader& in) { implementation_->motion->restore(in); }

}  // namespace nilas::vessel
