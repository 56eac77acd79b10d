#include "core/vessel/mooring/catenary.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/base/error.h"

namespace nilas::vessel {

namespace {

constexpr double k_endless = std::numeric_limits<double>::infinity();
/// A Newton step of this share of the unknown is the last one: the error after it is about the square of the share.
constexpr double k_last_step = 1e-9;
/// Bisections alone reach the rounding of a double within this number of passes.
constexpr int k_most_passes = 300;

/// How far a line or a part of it reaches, and the derivatives by H and V. The matrix is the line's flexibility.
struct Reach {
  double x = 0, z = 0;                              ///< across, up [m]
  Eigen::Matrix2d by_HV = Eigen::Matrix2d::Zero();  ///< rows x, z; columns H, V [m/N]
};

/// A part that hangs between the bed, where it is level, and an end that carries V. Its weight is V.
/// The stretch along x is not in it.
Reach hanging(const CatenaryLine& line, double H, double V) {
  const double w = line.weight, EA = line.stiffness, T = std::hypot(H, V);
  Reach part;
  if (!(T > 0)) return part;
  const double run = H > 0 ? std::asinh(V / H) / w : k_endless;
  part.x = H > 0 ? H * run : 0;
  part.z = V * V / (T + H) / w + V * V / (2 * EA * w);
  const double mixed = (H / T - 1) / w;
  part.by_HV << run - V / T / w, mixed, mixed, V / T / w + V / (EA * w);
  return part;
}

/// A line off the bed. All differences are formed without cancellation, so that a taut line is as exact as a slack one.
Reach suspended(const CatenaryLine& line, double H, double V) {
  const double w = line.weight, L = line.length, EA = line.stiffness;
  const double V_A = V - w * L, T = std::hypot(H, V), T_A = std::hypot(H, V_A);
  const double slope = T + T_A > 0 ? (V + V_A) / (T + T_A) : 0;  // of the chord of an inextensible line
  double run = k_endless;                                        // asinh(V/H) - asinh(V_A/H)
  if (V_A >= 0 && T_A > 0)
    run = std::log1p(w * L * (1 + slope) / (V_A + T_A));
  else if (V <= 0 && T > 0)
    run = std::log1p(w * L * (1 - slope) / (T - V));
  else if (H > 0)
    run = std::asinh(V / H) - std::asinh(V_A / H);
  const auto share = [](double part, double whole) { return whole > 0 ? part / whole : 0; };
  const double rise = share(V, T) - share(V_A, T_A);
  Reach whole;
  whole.x = (H > 0 ? H * run / w : 0) + H * L / EA;
  whole.z = L * slope + (V + V_A) * L / (2 * EA);
  const double mixed = (share(H, T) - share(H, T_A)) / w;
  whole.by_HV << (run - rise) / w + L / EA, mixed, mixed, rise / w + L / EA;
  return whole;
}

/// V of a part that hangs over the height z. The height is convex in V, and the start lies beyond the root, so that
/// Newton's method falls towards it without a bracket.
double hanging_pull(const CatenaryLine& line, double H, double z) {
  if (!(z > 0)) return 0;
  const double weight = line.weight * z;
  double V = std::sqrt(weight * (weight + 2 * H));
  for (int pass = 0; pass < k_most_passes; ++pass) {
    const Reach part = hanging(line, H, V);
    const double step = (part.z - z) / part.by_HV(1, 1);
    V -= step;
    if (!(step > k_last_step * V)) break;
  }
  return V;
}

/// V of a line off the bed with its fairlead at the height z.
double suspended_pull(const CatenaryLine& line, double H, double z) {
  const double w = line.weight, L = line.length;
  // The inextensible line has V = w L/2 + z sqrt(H^2 / (L^2 - z^2) + w^2/4).
  const double square = L * L - z * z;
  double V = w * L / 2 + (square > 0 ? z * std::sqrt(H * H / square + w * w / (2 * 2)) : 0);
  double low = -k_endless, high = k_endless;
  for (int pass = 0; pass < k_most_passes; ++pass) {
    const Reach whole = suspended(line, H, V);
    const double error = whole.z - z;
    (error > 0 ? high : low) = V;
    // The height rises with V at least as fast as the stretch L/EA does, which bounds the root on the other side.
    const double bound = V - error * line.stiffness / L;
    if (error > 0) low = std::max(low, bound);
    if (error < 0) high = std::min(high, bound);
    const double before = V;
    V -= error / whole.by_HV(1, 1);
    if (!(V >= low && V <= high)) V = 0.5 * (low + high);
    if (!(std::abs(V - before) > k_last_step * std::max(std::abs(V), H))) break;
  }
  return V;
}

/// The line at a given H with its fairlead at the height of the span.
struct AtPull {
  Reach reach;
  double V = 0, V_A = 0;  ///< fairlead downwards, anchor upwards [N]
  double on_bed = 0;      ///< unstretched length on the bed [m]
};

/// The stretch and its derivatives that friction takes away from a length on the bed.
void take_friction(const CatenaryLine& line, double H, double on_bed, Reach& reach) {
  const double EA = line.stiffness, drag = line.bed_friction * line.weight;
  if (!(drag > 0)) return;
  const double gripped = H / drag;  // length over which friction takes all tension
  if (on_bed > gripped) {
    reach.x += (0.5 * H * gripped - on_bed * H) / EA;
    reach.by_HV(0, 0) += (gripped - on_bed) / EA;
    reach.by_HV(0, 1) += H / (EA * line.weight);
  } else {
    reach.x -= 0.5 * drag * on_bed * on_bed / EA;
    reach.by_HV(0, 1) += line.bed_friction * on_bed / EA;
  }
}

AtPull line_at(const CatenaryLine& line, const CatenarySpan& span, double H) {
  const double w = line.weight, L = line.length;
  AtPull at;
  if (span.above_bed) {
    at.V = hanging_pull(line, H, *span.above_bed + span.up);
    at.V_A = -hanging_pull(line, H, *span.above_bed);
    at.on_bed = L - (at.V - at.V_A) / w;
  }
  if (!(at.on_bed > 0)) {
    at.V = suspended_pull(line, H, span.up);
    at.V_A = at.V - w * L;
    at.on_bed = 0;
    at.reach = suspended(line, H, at.V);
    return at;
  }
  at.reach = hanging(line, H, at.V);
  at.reach.x += at.on_bed + H * L / line.stiffness;
  at.reach.by_HV(0, 0) += L / line.stiffness;
  if (at.V_A < 0) {
    // The part at the anchor keeps its height, so its own V follows H.
    const Reach part = hanging(line, H, -at.V_A);
    at.reach.x += part.x;
    at.reach.by_HV(0, 0) += part.by_HV(0, 0) - part.by_HV(0, 1) * part.by_HV(1, 0) / part.by_HV(1, 1);
  } else {
    take_friction(line, H, at.on_bed, at.reach);
  }
  return at;
}

/// Length that hangs at H = 0 over a height, divided by its share of the weight: V = w times it.
double plumb_pull(const CatenaryLine& line, double height) {
  return 2 * line.weight * height / (1 + std::sqrt(1 + 2 * line.weight * height / line.stiffness));
}

/// H of the inextensible line by the series of Jonkman (2007, eq. 2.40), or of the straight line where it is taut.
double first_pull(const CatenaryLine& line, const CatenarySpan& span) {
  constexpr double k_of_series = 3;       // sinh(x)/x = 1 + x^2/6 + ..., both sides squared
  constexpr double k_least_slack = 1e-6;  // nearly straight, where the series' H is endless
  const double spare = (line.length * line.length - span.up * span.up) / (span.across * span.across) - 1;
  const double hung = 0.5 * line.weight * span.across / std::sqrt(k_of_series * std::max(spare, k_least_slack));
  const double chord = std::hypot(span.across, span.up);
  const double pulled = line.stiffness * (chord / line.length - 1) * span.across / chord;
  return std::max(hung, pulled);
}

/// The root H of across(H) = span.across.
AtPull search(const CatenaryLine& line, const CatenarySpan& span, double& H) {
  constexpr double k_stride = 4;
  double low = 0, high = k_endless;
  H = first_pull(line, span);
  for (int pass = 0; pass < k_most_passes; ++pass) {
    const AtPull at = line_at(line, span, H);
    const Eigen::Matrix2d& by = at.reach.by_HV;
    const double error = at.reach.x - span.across;
    (error > 0 ? high : low) = H;
    const double before = H;
    H -= error / (by(0, 0) - by(0, 1) * by(1, 0) / by(1, 1));
    if (!(H > low && H < high))
      H = error == 0          ? before
          : high == k_endless ? k_stride * before
          : low > 0           ? std::sqrt(low * high)
                              : before / k_stride;
    if (!(std::abs(H - before) > k_last_step * H)) break;
  }
  return line_at(line, span, H);
}

CatenaryForces heavy_line(const CatenaryLine& line, const CatenarySpan& span) {
  CatenaryForces forces;
  if (span.above_bed) {
    const double V = plumb_pull(line, *span.above_bed + span.up), V_A = plumb_pull(line, *span.above_bed);
    const double on_bed = line.length - (V + V_A) / line.weight;
    if (on_bed >= 0 && on_bed >= span.across) {
      forces.fairlead_down = V;
      forces.anchor_up = -V_A;
      forces.on_bed = on_bed;
      forces.slack = true;
      forces.stiffness(1, 1) = line.weight / (1 + V / line.stiffness);
      return forces;
    }
  }
  double H = 0;
  const AtPull at = span.across > 0 ? search(line, span, H) : line_at(line, span, 0);
  forces.fairlead_across = H;
  forces.fairlead_down = at.V;
  forces.anchor_up = at.V_A;
  const bool gripped = at.on_bed > 0 && at.V_A == 0;
  forces.anchor_across = gripped ? std::max(0.0, H - line.bed_friction * line.weight * at.on_bed) : H;
  forces.on_bed = at.on_bed;
  const Eigen::Matrix2d& by = at.reach.by_HV;
  if (std::isfinite(by(0, 0)))
    forces.stiffness = by.inverse();
  else
    forces.stiffness(1, 1) = 1 / by(1, 1);
  return forces;
}

}  // namespace

CatenaryForces solve_catenary(const CatenaryLine& line, const CatenarySpan& span) {
  NILAS_DEMAND(line.length > 0 && line.weight != 0 && line.stiffness > 0 && line.bed_friction >= 0);
  NILAS_DEMAND(span.across >= 0 && std::isfinite(span.across) && std::isfinite(span.up));
  NILAS_DEMAND(!span.above_bed || (*span.above_bed >= 0 && *span.above_bed + span.up >= 0));
  if (line.weight > 0) return heavy_line(line, span);
  CatenaryLine mirrored = line;
  mirrored.weight = -line.weight;
  CatenaryForces forces = heavy_line(mirrored, {span.across, -span.up, std::nullopt});
  forces.fairlead_down = -forces.fairlead_down;
  forces.anchor_up = -forces.anchor_up;
  forces.stiffness(0, 1) = -forces.stiffness(0, 1);
  forces.stiffness(1, 0) = -forces.stiffness(1, 0);
  return forces;
}

double greatest_strain(const CatenaryLine& line, const CatenaryForces& forces) {
  return std::max(forces.fairlead_tension(), forces.anchor_tension()) / line.stiffness;
}

}  // namespace nilas::vessel
