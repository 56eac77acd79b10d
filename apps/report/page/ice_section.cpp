#include "apps/report/page/ice_section.h"

#include <fmt/format.h>

#include <algorithm>
#include <limits>

#include "core/base/statistics.h"

namespace nilas::report {

namespace {

/// Extent of a mesh along two horizontal axes, from `ahead` and to its port.
struct PlanExtent {
  Vec2 low = Vec2::Constant(std::numeric_limits<double>::infinity()), high = -low;
};

PlanExtent extent_of(const geometry::TriangleMesh& mesh, const Vec2& ahead) {
  PlanExtent extent;
  for (const Vec3& vertex : mesh.vertices) {
    const Vec2 p = vertex.head<2>(), turned(p.dot(ahead), cross2(ahead, p));
    extent.low = extent.low.cwiseMin(turned);
    extent.high = extent.high.cwiseMax(turned);
  }
  return extent;
}

/// A window of a structure is this many times as long as wide.
constexpr double k_structure_window = 2;

WaterWindow window_of_structure(const RunBody& body, const Vec2& ahead) {
  const PlanExtent extent = extent_of(body.mesh, ahead);
  WaterWindow window;
  window.ahead = ahead;
  window.width = extent.high.y() - extent.low.y();
  window.length = k_structure_window * window.width;
  const double along = extent.high.x() + 0.5 * window.length, across = 0.5 * (extent.high.y() + extent.low.y());
  window.middle = along * ahead + across * Vec2(-ahead.y(), ahead.x());
  return window;
}

WaterWindow window_of_vessel(const RunFindings& found, double t) {
  const Pose pose = vessel_pose(found.run.vessel, t, found.shapes->info.vessel_mass.com);
  const PlanExtent extent = extent_of(found.body->mesh, Vec2::UnitX());
  WaterWindow window;
  window.length = extent.high.x() - extent.low.x();
  window.width = extent.high.y() - extent.low.y();
  const Vec3 forward = pose.q * Vec3::UnitX();
  window.ahead = Vec2(forward.head<2>()).normalized();
  window.middle = (pose.p + pose.q * Vec3(extent.high.x() + 0.5 * window.length, 0, 0)).head<2>();
  return window;
}

/// Whether the far end of the window lies beyond the end of the tank, where there is no water.
bool is_beyond_tank(const RunFindings& found, const WaterWindow& window) {
  if (!found.run.scene || !found.run.scene->tank) return false;
  const Vec2 end = window.middle + 0.5 * window.length * window.ahead;
  return end.x() > found.run.scene->tank->length;
}

}  // namespace

std::optional<WaterWindow> window_ahead(const RunFindings& found, double t) {
  if (found.body == nullptr) return std::nullopt;
  if (found.body->is_vessel) return window_of_vessel(found, t);
  if (!found.cause) return std::nullopt;
  return window_of_structure(*found.body, found.cause->course);
}

std::optional<Curve> cover_curve(const RunFindings& found, const std::string& name) {
  constexpr std::size_t k_most_frames = 200;
  constexpr double k_percent = 100;
  if (found.frames.empty() || !window_ahead(found, 0)) return std::nullopt;
  const std::size_t stride = (found.frames.size() + k_most_frames - 1) / k_most_frames;
  Curve curve{.name = name};
  for (std::size_t k = 0; k < found.frames.size(); k += stride) {
    if (is_beyond_tank(found, *window_ahead(found, found.frames[k].t))) continue;
    const IceFrame frame = read_ice_frame(found.frames[k]);
    curve.x.push_back(frame.t);
    curve.y.push_back(k_percent * ice_cover(frame.outlines, *window_ahead(found, frame.t)));
  }
  return curve;
}

Section ice_section(RunFindings& found) {
  Section section{.id = "ice", .title = "Ice ahead"};
  if (found.run.scene && !found.run.scene->ice) {
    section.text.emplace_back("The scene has no ice.");
    return section;
  }
  if (found.frames.empty()) {
    section.gaps.emplace_back("The run stored no motion of the ice: set <output trajectory_every> above 0.");
    return section;
  }
  std::optional<Curve> curve;
  if (!found.run.attempt("The ice ahead", [&] { curve = cover_curve(found, "ice ahead"); })) {
    section.gaps.emplace_back(found.run.gaps.back().why);
    return section;
  }
  if (!curve) {
    section.gaps.emplace_back(
        "The window ahead is not known, since the shape or the course of what the ice meets is not known.");
    return section;
  }
  if (curve->x.empty()) {
    section.gaps.emplace_back("The window ahead reaches beyond the tank at all stored moments.");
    return section;
  }
  const WaterWindow window = *window_ahead(found, 0);
  section.text.push_back(fmt::format(
      "The share of the water that ice covers in a window ahead of {}: {:.4g} m long and {:.4g} m wide, {}. It is "
      "{:.3g} % on average. Moments at which the window reaches beyond the tank are left out. Ice that overrides other "
      "ice counts twice.",
      found.subject(), window.length, window.width,
      found.body->is_vessel ? "one length and one beam of the hull, along its heading" : "against the drift",
      mean_of(curve->y)));
  Plot plot{.id = "concentration",
            .title = "Ice concentration ahead",
            .x_label = "time [s]",
            .y_label = "covered [%]",
            .over_time = true};
  plot.curves.push_back(std::move(*curve));
  section.plots.push_back(std::move(plot));
  return section;
}

}  // namespace nilas::report
