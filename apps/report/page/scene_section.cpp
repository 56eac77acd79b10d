#include "apps/report/page/scene_section.h"

#include <fmt/format.h>

#include <algorithm>
#include <limits>

#include "apps/report/page/drawing.h"
#include "apps/report/page/words.h"

namespace nilas::report {

namespace {

/// A moment that is drawn.
struct Moment {
  double t = 0;
  std::string when;  ///< "at the start"
  bool at_peak = false;
};

std::vector<Moment> moments_of(const RunFindings& found) {
  std::vector<Moment> moments{{found.run.start(), "at the start"}};
  if (found.load != nullptr && found.load->touched)
    moments.push_back({found.load->along.peak.raw_time, "at the largest load of one step", true});
  return moments;
}

IceFrame ice_at(const RunFindings& found, double t) {
  const IceFrameFile* frame = frame_near(found, t);
  return frame == nullptr ? IceFrame{} : read_ice_frame(*frame);
}

std::vector<Vec2> seen_from_above(const std::vector<Vec3>& outline) {
  std::vector<Vec2> flat;
  for (const Vec3& p : outline) flat.emplace_back(p.head<2>());
  return flat;
}

/// "floe 225", as drawings name what made the largest load.
std::string culprit_name(const RunFindings& found) {
  return fmt::format("{} {}", found.floe_made_peak ? "floe" : "body", found.cause->floe);
}

geometry::TriangleMesh mesh_at(const RunFindings& found, const RunBody& body, double t) {
  geometry::TriangleMesh mesh = body.mesh;
  if (!body.is_vessel) return mesh;
  const Pose pose = vessel_pose(found.run.vessel, t, found.shapes->info.vessel_mass.com);
  for (Vec3& p : mesh.vertices) p = pose.p + pose.q * p;
  return mesh;
}

std::vector<std::vector<Vec2>> tank_outline(const scene::Scene& scene) {
  if (!scene.tank) return {};
  const double length = scene.tank->length, half = 0.5 * scene.tank->width;
  return {{{0, -half}, {length, -half}, {length, half}, {0, half}}};
}

/// What the drawing from above shows: a surrounding of the bodies, or of the ice where there are none.
DrawnArea area_around(const std::vector<geometry::TriangleMesh>& meshes, const std::vector<std::vector<Vec2>>& ice) {
  Vec2 low = Vec2::Constant(std::numeric_limits<double>::infinity()), high = -low;
  const auto take = [&](const Vec2& p) {
    low = low.cwiseMin(p);
    high = high.cwiseMax(p);
  };
  for (const auto& mesh : meshes)
    for (const Vec3& p : mesh.vertices) take(p.head<2>());
  if (meshes.empty())
    for (const auto& outline : ice)
      for (const Vec2& p : outline) take(p);
  constexpr double k_beside = 0.9, k_flattest = 0.45;
  const double size = (high - low).maxCoeff();
  const Vec2 middle = 0.5 * (low + high);
  const double half = 0.5 * size * (1 + 2 * k_beside);
  const double half_height = std::max(k_flattest * half, 0.5 * (high.y() - low.y()) * (1 + k_beside));
  return {middle - Vec2(half, half_height), middle + Vec2(half, half_height)};
}

/// Of what moment the drawn ice is, where the stored frame is of another.
std::string ice_moment(const RunFindings& found, double t) {
  const IceFrameFile* frame = frame_near(found, t);
  if (frame == nullptr || std::abs(frame->t - t) < 0.5 * found.run.step()) return "";
  return " The ice is that of the stored frame at " + time_text(frame->t, found.run.step()) + ".";
}

Drawing from_above(const RunFindings& found, const Moment& moment) {
  DrawnShapes shapes;
  const IceFrame ice = ice_at(found, moment.t);
  const bool marks = moment.at_peak && found.cause;
  for (std::size_t k = 0; k < ice.outlines.size(); ++k)
    (marks && ice.ids[k] == found.cause->floe ? shapes.culprits : shapes.ice)
        .push_back(seen_from_above(ice.outlines[k]));
  std::vector<geometry::TriangleMesh> meshes;
  if (found.shapes)
    for (const RunBody& body : found.shapes->bodies) meshes.push_back(mesh_at(found, body, moment.t));
  for (const auto& mesh : meshes)
    for (const Segment& line : visible_lines(mesh, Vec3::UnitZ()))
      shapes.hull.push_back({line[0].head<2>(), line[1].head<2>()});
  if (found.run.scene) shapes.tank = tank_outline(*found.run.scene);
  if (marks) {
    shapes.mark_name = culprit_name(found);
    Vec3 place = found.cause->place;
    if (found.body->is_vessel) {
      const Pose pose = vessel_pose(found.run.vessel, moment.t, found.shapes->info.vessel_mass.com);
      place = pose.p + pose.q * place;
    }
    shapes.marks.emplace_back(place.head<2>());
  }
  const std::string what = fmt::format("From above {} ({})", moment.when, time_text(moment.t, found.run.step()));
  return {svg_drawing(shapes, area_around(meshes, shapes.ice), what),
          what + (marks ? ". The dot marks where the largest load acted, by " + culprit_name(found) : "") +
              (shapes.culprits.empty() ? "." : ", which is coloured.") + ice_moment(found, moment.t)};
}

/// The hull from its starboard side, in its own frame, with the ice abeam of it.
Drawing from_the_side(const RunFindings& found, const Moment& moment) {
  const Pose pose = vessel_pose(found.run.vessel, moment.t, found.shapes->info.vessel_mass.com);
  const geometry::TriangleMesh& mesh = found.body->mesh;
  Vec3 low = Vec3::Constant(std::numeric_limits<double>::infinity()), high = -low;
  for (const Vec3& p : mesh.vertices) {
    low = low.cwiseMin(p);
    high = high.cwiseMax(p);
  }
  const double length = high.x() - low.x(), level = found.run.scene->water ? found.run.scene->water->level : 0;
  DrawnShapes shapes;
  for (const Segment& line : visible_lines(mesh, -Vec3::UnitY()))
    shapes.hull.push_back({Vec2(line[0].x(), line[0].z()), Vec2(line[1].x(), line[1].z())});
  constexpr double k_beside = 0.35, k_above = 0.06;
  const DrawnArea area{{low.x() - k_beside * length, low.z() - k_above * length},
                       {high.x() + k_beside * length, high.z() + k_above * length}};
  shapes.water.push_back({Vec2(area.low.x(), level - pose.p.z()), Vec2(area.high.x(), level - pose.p.z())});
  const double thickness = found.run.scene->ice ? found.run.scene->ice->thickness : 0;
  for (const auto& outline : ice_at(found, moment.t).outlines) {
    std::vector<Vec2> top;
    bool beside = false;
    for (const Vec3& p : outline) {
      const Vec3 in_V = pose.q.inverse() * (p - pose.p);
      beside = beside || (in_V.y() > low.y() && in_V.y() < high.y());
      top.emplace_back(in_V.x(), in_V.z());
    }
    if (!beside) continue;
    const auto [aft, fore] =
        std::minmax_element(top.begin(), top.end(), [](const Vec2& a, const Vec2& b) { return a.x() < b.x(); });
    shapes.ice.push_back({*aft, *fore, *fore - Vec2(0, thickness), *aft - Vec2(0, thickness)});
  }
  const std::string what =
      fmt::format("From the starboard side {} ({})", moment.when, time_text(moment.t, found.run.step()));
  return {svg_drawing(shapes, area, what),
          what + ". Ice within the beam is drawn between its ends." + ice_moment(found, moment.t)};
}

PageTable facts_table(const RunFindings& found) {
  PageTable table;
  const RunData& run = found.run;
  const auto fact = [&](const std::string& name, const std::string& value) {
    if (!value.empty()) table.rows.push_back({name, value});
  };
  fact("run folder", run.name);
  fact("ended",
       run.summary.is_object() ? run.summary.value("status", "not known") : "not known: killed, or still going on");
  fact("simulated", fmt::format("{:.6g} to {:.6g} s in {} steps of {:.4g} s", run.start(), run.times().back(),
                                run.steps_done(), run.step()));
  if (run.scene) {
    const scene::Scene& scene = *run.scene;
    if (scene.vessel && found.body != nullptr && found.body->is_vessel)
      fact("vessel", fmt::format("{}, {:.4g} m long, {:.5g} kg", scene.vessel->name, found.shapes->info.vessel_length,
                                 found.shapes->info.vessel_mass.mass));
    if (scene.ice) fact("ice thickness", fmt::format("{:.4g} m", scene.ice->thickness));
    fact("contact", fmt::format("law {}, solver {}, tolerance {:g} m/s", name_of(scene.contact.law),
                                name_of(scene.contact.solver), scene.contact.tolerance));
    fact("seed", std::to_string(scene.seed));
  }
  if (run.summary.contains("ice")) {
    const auto& ice = run.summary.at("ice");
    fact("floes", fmt::format("{} at the start, {} at the end", ice.value("floes", 0L), ice.value("floes_end", 0L)));
    if (ice.value("concentration", 0.0) > 0)
      fact("concentration",
           fmt::format("{:.3g} % of the field at the start", 100 * ice.at("concentration").get<double>()));
  }
  if (run.summary.contains("versions"))
    fact("written by", "Nilas " + run.summary.at("versions").value("nilas", "of an unknown version"));
  return table;
}

PageTable figures_table(const nlohmann::ordered_json& figures) {
  PageTable table{.head = {"figure of a module", "value"}};
  for (const auto& [module, list] : figures.items())
    for (const auto& [name, value] : list.items())
      if (value.is_number()) table.rows.push_back({module + "." + name, number_text(value.get<double>())});
  return table;
}

}  // namespace

Section scene_section(RunFindings& found) {
  Section section{.id = "scene", .title = "What was run"};
  section.tables.push_back(facts_table(found));
  if (found.run.summary.contains("figures")) section.tables.push_back(figures_table(found.run.summary.at("figures")));
  const bool has_body = found.shapes && !found.shapes->bodies.empty();
  if (!has_body && found.frames.empty()) {
    section.gaps.emplace_back("There is nothing to draw: the shapes are not known and no frame of the ice was stored.");
    return section;
  }
  const bool has_side = found.body != nullptr && found.body->is_vessel && found.run.scene;
  for (const bool above : {true, false})
    for (const Moment& moment : moments_of(found)) {
      if (!above && !has_side) continue;
      const auto draw = [&] {
        section.drawings.push_back(above ? from_above(found, moment) : from_the_side(found, moment));
      };
      if (!found.run.attempt("The drawing " + moment.when, draw)) section.gaps.push_back(found.run.gaps.back().why);
    }
  return section;
}

}  // namespace nilas::report
