#include "contact/detect/swept.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "contact/detect/search/cylinder_axis.h"
#include "contact/detect/surface/face_axes.h"
#include "contact/detect/surface/nearest_point.h"
#include "core/base/order_free_sum.h"

namespace nilas::detect {

namespace {

/// Parts nearer than this many of the pair's tolerances touch.
constexpr double k_touching = 4;
/// A face's normal, and FCL's direction for cylinders, are used while they separate by more than this share of the
/// smaller part. Nearer than that other axes may separate by much more, and rounding turns FCL's nearest points.
constexpr double k_near = 1e-3;
/// An advance ends where this share of the bound on the separation is left. Going closer gains nothing, because the
/// bound itself is not sharp.
constexpr double k_left = 1e-3;
constexpr int k_most_cuts = 60;
/// A pair that needs more advances moves along the surface at the tolerance, and counts as touching.
constexpr int k_most_advances = 10000;

/// Bounds on the heights along n of one part's points over the time ahead: h + rate t + bend t^2.
struct Heights {
  Eigen::ArrayXd h, rate, bend;

  double largest(double t) const { return (h + t * (rate + t * bend)).maxCoeff(); }
};

/// Fills the heights of vertices. Their rates are exact; |n x turn| |turn x r| bounds the second derivative.
void vertex_heights(const Part& part, const Mat3& R, const Vec3& turn, const Vec3& n, Heights& out) {
  const auto& x = part.facets->vertices;
  const auto along = [&](const Vec3& g) -> Eigen::ArrayXd {
    const Vec3 d = R.transpose() * g;
    return x.col(0) * d.x() + x.col(1) * d.y() + x.col(2) * d.z();
  };
  out.h = along(n);
  out.rate = along(n.cross(turn));
  const double speed = turn.norm();
  if (speed == 0) {
    out.bend.setZero(x.rows());
    return;
  }
  const Eigen::ArrayXd on_axis = along(turn / speed);
  const Eigen::ArrayXd off_axis = (x.square().rowwise().sum() - on_axis.square()).max(0.0).sqrt();
  out.bend = 0.5 * speed * n.cross(turn).norm() * off_axis;
}

/// Fills the heights of a sphere or cylinder. A sphere's centre moves like a vertex. The extent of a cylinder changes
/// at most by the path of its farthest point.
void round_heights(const Part& part, const Mat3& R, const Vec3& turn, const Vec3& n, Heights& out) {
  out.h.resize(1);
  out.rate.resize(1);
  out.bend.resize(1);
  out.h[0] = extent(part, R.transpose() * n);
  const Vec3 centre = R * part.centre;
  if (part.kind == PartKind::sphere) {
    out.rate[0] = n.cross(turn).dot(centre);
    out.bend[0] = 0.5 * n.cross(turn).norm() * turn.cross(centre).norm();
  } else {
    out.rate[0] = n.cross(turn).norm() * (part.centre.norm() + part.bounding_radius);
    out.bend[0] = 0;
  }
}

void part_heights(const Part& part, const Mat3& R, const Vec3& turn, const Vec3& n, Heights& out) {
  if (part.kind == PartKind::plane) {
    out.h = out.rate = out.bend = Eigen::ArrayXd::Zero(1);
  } else if (part.facets) {
    vertex_heights(part, R, turn, n, out);
  } else {
    round_heights(part, R, turn, n, out);
  }
}

/// Fills the heights along n of a guest's vertices as the host sees them, n being fixed in the host. Rates are exact.
/// With V the guest's way less the host's, d their distance and w their turns, a vertex r of the guest accelerates by
/// (w_g - w_h) x (w_g x r) - w_h x ((w_g - w_h) x r) + w_h x (w_h x d - 2 V), of which `bend` bounds half along n.
void heights_from_host(const Part& guest, const Mat3& R, const BodyMotion& of_guest, const BodyMotion& of_host,
                       const Vec3& from_host, const Vec3& n, double rest, Heights& out) {
  const auto& x = guest.facets->vertices;
  const auto along = [&](const Vec3& g) -> Eigen::ArrayXd {
    const Vec3 d = R.transpose() * g;
    return x.col(0) * d.x() + x.col(1) * d.y() + x.col(2) * d.z();
  };
  const Vec3 way = of_guest.way - of_host.way, spin = of_guest.turn - of_host.turn;
  const double tilt = n.cross(of_host.turn).norm();
  out.h = along(n);
  out.rate = along(n.cross(spin)) + n.dot(way - of_host.turn.cross(from_host));
  out.bend = 0.5 * spin.norm() * (of_guest.turn.norm() + tilt) * x.square().rowwise().sum().sqrt() +
             0.5 * tilt * ((of_host.turn.cross(from_host) - 2 * way).norm() + of_host.turn.norm() * way.norm() * rest);
}

class Advance {
 public:
  Advance(const Part& a, const BodyMotion& motion_a, const Part& b, const BodyMotion& motion_b, FclShapes& fcl,
          AxisSearchRoom& room, const SoughtOverlap& overlap)
      : a_(a), b_(b), motion_a_(motion_a), motion_b_(motion_b), fcl_(fcl), room_(room), overlap_(overlap) {}

  TimeOfImpact find() {
    TimeOfImpact out;
    if (a_.kind == PartKind::plane && b_.kind == PartKind::plane) return out;
    double t = 0;
    for (;;) {
      place(t);
      const Axis axis = separating_axis();
      if (t == 0 && overlap_.deeper > 0) depth_ = std::min(overlap_.deeper - std::min(axis.s, 0.0), overlap_.most);
      const bool touches = axis.s + depth_ <= k_touching * tolerance_;
      out.search = counts_;
      if (touches || out.advances == k_most_advances) {
        finish(t, axis, out);
        return out;
      }
      ++out.advances;
      t += safe_time(axis, 1 - t);
      if (t >= 1) return out;
    }
  }

 private:
  void place(double t) {
    R_a_ = motion_a_.attitude(t);
    R_b_ = motion_b_.attitude(t);
    between_ = motion_b_.p - motion_a_.p + t * (motion_b_.way - motion_a_.way);
    b_in_a_ = {R_a_.transpose() * R_b_, R_a_.transpose() * between_};
    size_ = std::min(a_.bounding_radius, b_.bounding_radius);
    tolerance_ = k_length_resolution * size_ + k_coordinate_rounding * between_.norm();
    for (const Part* part : {&a_, &b_}) {
      if (part->facets) tolerance_ += part->facets->roughness;
      if (part->kind != PartKind::plane) tolerance_ += k_coordinate_rounding * part->bounding_radius;
    }
  }

  /// Returns a separating axis in A's frame. Its s is below the resolution only when no axis separates by more.
  Axis separating_axis() {
    if (a_.kind == PartKind::plane) return of_plane(b_in_a_, b_, 1);
    if (b_.kind == PartKind::plane) return of_plane(b_in_a_.inverse(), a_, -1);
    if (b_.kind == PartKind::sphere) return of_sphere(a_, b_, b_in_a_, 1);
    if (a_.kind == PartKind::sphere) return of_sphere(b_, a_, b_in_a_.inverse(), -1);
    const PairView pair = view_pair(a_, b_, b_in_a_, k_near * size_);
    if (a_.facets && b_.facets) {
      const Axis face = best_face_axis(pair, std::numeric_limits<double>::infinity(), room_.rivals);
      return face.s > k_near * size_ ? face : find_axis(pair, {}, fcl_, false, room_, counts_);
    }
    if (const std::optional<Vec3> n = fcl_.direction(pair, true)) {
      Axis asked;
      asked.n = *n;
      asked.s = separation(pair, asked.n);
      if (asked.s > k_near * size_) return asked;
    }
    return find_cylinder_axis(pair, {}, fcl_, false, room_, counts_);
  }

  Axis of_plane(const RelativePose& guest_in_host, const Part& guest, double sign) const {
    Axis axis;
    const Vec3 down = -guest_in_host.R.row(2).transpose();
    axis.s = guest_in_host.p.z() - extent(guest, down);
    axis.n = in_a(Vec3::UnitZ(), sign);
    return axis;
  }

  Axis of_sphere(const Part& host, const Part& guest, const RelativePose& guest_in_host, double sign) const {
    const NearestPoint nearest = nearest_point(host, guest_in_host.point(guest.centre));
    Axis axis;
    axis.s = nearest.distance - guest.radius;
    axis.n = in_a(nearest.normal, sign);
    return axis;
  }

  /// Converts a direction from host to guest into one from A to B, in A's frame. sign -1: B is the host.
  Vec3 in_a(const Vec3& n, double sign) const { return sign > 0 ? n : Vec3(-(b_in_a_.R * n)); }

  /// Returns a share of the step, at most `rest`, within which the parts cannot touch.
  double safe_time(const Axis& axis, double rest) {
    const Vec3 n = R_a_ * axis.n;
    const bool turning_plane = (a_.kind == PartKind::plane && !motion_a_.turn.isZero(0)) ||
                               (b_.kind == PartKind::plane && !motion_b_.turn.isZero(0));
    if (turning_plane) return rest;
    part_heights(a_, R_a_, motion_a_.turn, n, above_a_);
    part_heights(b_, R_b_, motion_b_.turn, -n, below_b_);
    const double approach = n.dot(motion_b_.way - motion_a_.way);
    const double start = -above_a_.largest(0) - below_b_.largest(0);
    const double gap = axis.s + depth_;
    double safe = longest_apart(
        [&](double t) { return gap + t * approach - (above_a_.largest(t) + below_b_.largest(t) + start); }, gap, rest);
    if (!a_.facets || !b_.facets) return safe;
    // Parts that turn together and stay close are soon past the bound above, since n does not turn with them.
    const auto turns = [](const BodyMotion& motion) { return !motion.turn.isZero(0); };
    if (safe < rest && axis.kind != AxisKind::face_b && turns(motion_a_))
      safe = std::max(safe, safe_from_host(true, n, gap, rest));
    if (safe < rest && axis.kind != AxisKind::face_a && turns(motion_b_))
      safe = std::max(safe, safe_from_host(false, n, gap, rest));
    return safe;
  }

  /// The same with an axis that turns with A, or with B.
  double safe_from_host(bool host_is_a, const Vec3& n, double gap, double rest) {
    if (host_is_a)
      heights_from_host(b_, R_b_, motion_b_, motion_a_, between_, -n, rest, below_b_);
    else
      heights_from_host(a_, R_a_, motion_a_, motion_b_, -between_, n, rest, below_b_);
    const double start = below_b_.largest(0);
    return longest_apart([&](double t) { return gap - (below_b_.largest(t) - start); }, gap, rest);
  }

  /// Returns a share of the step, at most `rest`, until which `left`, a bound on the separation, is not used up. The
  /// bound is concave in time. A chord of it lies below it, so the root of the chord is safe. Halving `rest` shortens
  /// the chord.
  template <class Left>
  double longest_apart(const Left& left, double gap, double rest) const {
    double high_left = left(rest);
    if (high_left > 0) return rest;
    const double goal = std::max(k_left * gap, 0.5 * k_touching * tolerance_);
    double low = 0, low_left = gap, high = rest;
    for (int cut = 0; cut < k_most_cuts && low_left > 2 * goal; ++cut) {
      const auto try_at = [&](double t) {
        const double value = left(t);
        (value >= goal ? low : high) = t;
        (value >= goal ? low_left : high_left) = value;
      };
      try_at(low + (high - low) * (low_left - goal) / (low_left - high_left));
      try_at(0.5 * (low + high));
    }
    return low;
  }

  void finish(double t, const Axis& axis, TimeOfImpact& out) {
    out.hit = true;
    out.t = t;
    out.distance = axis.s;
    out.n = R_a_ * axis.n;
    const Vec3 on_a = meeting_point(axis);
    out.on_a = motion_a_.position(t) + R_a_ * on_a;
    out.on_b = out.on_a + axis.s * out.n;
  }

  /// Returns the point on A's surface where the parts meet, in A's frame.
  Vec3 meeting_point(const Axis& axis) {
    if (b_.kind == PartKind::sphere) return b_in_a_.point(b_.centre) - (b_.radius + axis.s) * axis.n;
    if (a_.kind == PartKind::sphere) return a_.centre + a_.radius * axis.n;
    if (b_.kind == PartKind::plane) return supporting_point(a_, axis.n);
    if (a_.kind == PartKind::plane)
      return b_in_a_.point(supporting_point(b_, -(b_in_a_.R.transpose() * axis.n))) - axis.s * axis.n;
    const PairView pair = view_pair(a_, b_, b_in_a_, axis.s + k_touching * tolerance_);
    face_each_other(pair, axis, room_.facing);
    select_points(pair, axis, {}, room_.facing);
    OrderFreeVectorSum sum;
    for (const OverlayPoint& p : room_.facing.points)
      sum.add(p.u * room_.facing.plane.t1 + p.v * room_.facing.plane.t2 + p.height_a * room_.facing.plane.n);
    return sum.value() / static_cast<double>(room_.facing.points.size());
  }

  /// Returns the middle of the points that are highest along n, in the part's frame.
  Vec3 supporting_point(const Part& part, const Vec3& n) {
    if (!part.facets) {
      Vec3 sum = Vec3::Zero();
      const CylinderSupport support = cylinder_support(part, n, tolerance_);
      for (int k = 0; k < support.count; ++k) sum += support.points[k];
      return sum / support.count;
    }
    support_vertices(*part.facets, n, tolerance_, room_.vertices);
    OrderFreeVectorSum of_vertices;
    for (const int v : room_.vertices) of_vertices.add(part.facets->polytope->vertices[v]);
    return of_vertices.value() / static_cast<double>(room_.vertices.size());
  }

  const Part& a_;
  const Part& b_;
  const BodyMotion& motion_a_;
  const BodyMotion& motion_b_;
  FclShapes& fcl_;
  AxisSearchRoom& room_;
  SoughtOverlap overlap_;
  double depth_ = 0;  ///< the sought depth [m]
  Mat3 R_a_, R_b_;
  Vec3 between_;  ///< vector from A's origin to B's, in G
  RelativePose b_in_a_;
  double size_ = 0, tolerance_ = 0;
  Heights above_a_, below_b_;
  AxisSearchCounts counts_;
};

}  // namespace

Mat3 BodyMotion::attitude(double t) const {
  const double angle = t * turn.norm();
  if (angle == 0) return R;
  return Eigen::AngleAxisd(angle, turn.normalized()).toRotationMatrix() * R;
}

TimeOfImpact time_of_impact(const Part& a, const BodyMotion& motion_a, const Part& b, const BodyMotion& motion_b,
                            FclShapes& fcl, AxisSearchRoom& room, const SoughtOverlap& overlap) {
  return Advance(a, motion_a, b, motion_b, fcl, room, overlap).find();
}

}  // namespace nilas::detect
