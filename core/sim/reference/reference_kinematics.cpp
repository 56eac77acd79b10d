#include "core/sim/reference/reference_kinematics.h"

#include <algorithm>
#include <optional>

#include "contact/law/contact_frame.h"
#include "core/bodies/free_rotation.h"

namespace nilas::sim {

namespace {

/// Step of the difference quotients for the motion of contacts: a share of a radius, or an angle [rad]. The error of
/// the difference, its square, is then similar to rounding.
constexpr double k_probe = 1e-5;
/// Shares of the smaller radius: what a point moves within a probe where it does not only go with its bodies, what it
/// may move, and what it has jumped. The lowest point of a rim races round where the cap comes to lie flat.
constexpr double k_races = 5 * k_probe, k_most_move = 1e-3, k_jump = 10 * k_most_move;
constexpr int k_most_shorter_probes = 3;

double probe_time(const bodies::Bodies& bodies) {
  double rate = 0;
  for (int k = 0; k < bodies.size(); ++k) {
    if (!bodies.moves(k)) continue;
    const auto b = static_cast<std::size_t>(k);
    rate = std::max({rate, bodies.w_GB[b].norm(), bodies.v_GB[b].norm() / bodies.shape[b]->bounding_radius});
  }
  return rate > 0 ? k_probe / rate : 0;
}

const detect::ContactPoint* find(const std::vector<detect::ContactPoint>& points, std::uint64_t key) {
  for (const auto& point : points)
    if (point.key == key) return &point;
  return nullptr;
}

/// Saves the poses that a probe changes, and restores them at the end of its scope.
class KeptPoses {
 public:
  explicit KeptPoses(bodies::Bodies& bodies) : bodies_(bodies), p_(bodies.p_GB), q_(bodies.q_GB), R_(bodies.R_GB) {}
  ~KeptPoses() {
    bodies_.p_GB = p_;
    bodies_.q_GB = q_;
    bodies_.R_GB = R_;
  }
  KeptPoses(const KeptPoses&) = delete;
  KeptPoses& operator=(const KeptPoses&) = delete;

 private:
  bodies::Bodies& bodies_;
  std::vector<Vec3> p_;
  std::vector<Quat> q_;
  std::vector<Mat3> R_;
};

/// Moves all bodies over `time` [s] with their present velocities.
void go_on(bodies::Bodies& bodies, double time) {
  for (int k = 0; k < bodies.size(); ++k) {
    if (!bodies.moves(k)) continue;
    const auto b = static_cast<std::size_t>(k);
    bodies.set_pose(k, bodies.p_GB[b] + time * bodies.v_GB[b],
                    bodies::exponential(time * bodies.w_GB[b]) * bodies.q_GB[b]);
  }
}

/// What changes at a contact while the bodies go on: the velocity between them, the normal, and its place, as a share
/// of the smaller radius.
struct Look {
  Vec3 velocity, n;
  double moved = 0;
};
using Looks = std::vector<std::optional<Look>>;

/// The contacts after `time` [s] at the present velocities. Those that are not there are left empty.
Looks look_ahead(bodies::Bodies& bodies, const std::vector<ContactKinematics>& now, double time,
                 const FindContacts& detect) {
  const KeptPoses kept(bodies);
  go_on(bodies, time);
  const auto points = detect(bodies);
  Looks looks(now.size());
  for (std::size_t i = 0; i < now.size(); ++i) {
    const detect::ContactPoint* const point = now[i].found ? find(points, now[i].point.key) : nullptr;
    if (point == nullptr) continue;
    const double radius = std::min(bodies.shape[point->a]->bounding_radius, bodies.shape[point->b]->bounding_radius);
    looks[i] = Look{velocity_between(bodies, *point), point->n, (point->p - now[i].point.p).norm() / radius};
  }
  return looks;
}

double farthest(const Looks& looks) {
  double most = 0;
  for (const auto& look : looks)
    if (look) most = std::max(most, look->moved);
  return most;
}

void leave_out_jumps(Looks& looks) {
  for (auto& look : looks)
    if (look && look->moved > k_jump) look.reset();
}

/// Rates of velocity and normal from the present ones, those after `step` [s] and, where known, after twice the step.
Look one_sided(const Look& now, const Look& near, const std::optional<Look>& far, double step) {
  if (!far) return {(near.velocity - now.velocity) / step, (near.n - now.n) / step};
  return {(4 * near.velocity - far->velocity - 3 * now.velocity) / (2 * step),
          (4 * near.n - far->n - 3 * now.n) / (2 * step)};
}

Look central(const Look& later, const Look& earlier, double step) {
  return {(later.velocity - earlier.velocity) / (2 * step), (later.n - earlier.n) / (2 * step)};
}

/// The contacts along the motion, at multiples of a step that suits their points.
class Path {
 public:
  Path(bodies::Bodies& bodies, const std::vector<ContactKinematics>& now, const FindContacts& detect)
      : bodies_(bodies), now_(now), detect_(detect), step_(probe_time(bodies)) {
    for (int k = 0; step_ > 0 && k <= k_most_shorter_probes; ++k) {
      later_ = look_ahead(bodies_, now_, step_, detect_);
      earlier_ = look_ahead(bodies_, now_, -step_, detect_);
      const double moved = std::max(farthest(later_), farthest(earlier_));
      races_ |= moved > k_races;
      if (moved <= k_most_move || k == k_most_shorter_probes) break;
      step_ *= 0.5 * k_most_move / moved;
    }
    leave_out_jumps(later_);
    leave_out_jumps(earlier_);
  }

  /// Rates of velocity and normal, along the way that the contact lasts; nothing where it lasts on neither side.
  std::optional<Look> rates(std::size_t i) {
    if (step_ == 0 || (!later_[i] && !earlier_[i])) return std::nullopt;
    const Look now{now_[i].velocity, now_[i].point.n};
    if (!earlier_[i]) return one_sided(now, *later_[i], much_later()[i], step_);
    if (!later_[i]) return one_sided(now, *earlier_[i], much_earlier()[i], -step_);
    const Look near = central(*later_[i], *earlier_[i], step_);
    // Along a rim the error of second order would count.
    if (!races_ || !much_later()[i] || !much_earlier()[i]) return near;
    const Look far = central(*much_later()[i], *much_earlier()[i], 2 * step_);
    return Look{(4 * near.velocity - far.velocity) / 3, (4 * near.n - far.n) / 3};
  }

 private:
  const Looks& much_later() { return much(2 * step_, much_later_); }
  const Looks& much_earlier() { return much(-2 * step_, much_earlier_); }
  const Looks& much(double time, Looks& looks) {
    if (!looks.empty()) return looks;
    looks = look_ahead(bodies_, now_, time, detect_);
    leave_out_jumps(looks);
    return looks;
  }

  bodies::Bodies& bodies_;
  const std::vector<ContactKinematics>& now_;
  const FindContacts& detect_;
  double step_;         ///< [s]; 0: nothing moves
  bool races_ = false;  ///< a point moves much faster than the bodies
  Looks later_, earlier_, much_later_, much_earlier_;
};

}  // namespace

Vec3 velocity_between(const bodies::Bodies& bodies, const detect::ContactPoint& c) {
  return bodies.velocity_at(c.b, c.p) - bodies.velocity_at(c.a, c.p);
}

std::vector<ContactKinematics> follow_contacts(bodies::Bodies& bodies, const std::vector<std::uint64_t>& keys,
                                               const FindContacts& detect) {
  std::vector<ContactKinematics> out(keys.size());
  const auto points = detect(bodies);
  for (std::size_t i = 0; i < keys.size(); ++i) {
    const detect::ContactPoint* const point = find(points, keys[i]);
    if (point == nullptr) continue;
    out[i].found = true;
    out[i].point = *point;
    out[i].frame = contact::contact_frame(point->n, bodies.R_GB[point->a], 0);
    out[i].velocity = velocity_between(bodies, *point);
  }
  Path path(bodies, out, detect);
  for (std::size_t i = 0; i < keys.size(); ++i) {
    const auto rates = path.rates(i);
    if (!rates) continue;
    out[i].bias += out[i].frame.transpose() * rates->velocity;
    out[i].bias[0] += rates->n.dot(out[i].velocity);
  }
  return out;
}

}  // namespace nilas::sim
