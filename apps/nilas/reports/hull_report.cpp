#include "apps/nilas/reports/hull_report.h"

#include <fmt/format.h>

#include <algorithm>

#include "core/base/error.h"
#include "core/geometry/edge_cut.h"
#include "core/geometry/mass_properties.h"
#include "core/geometry/mesh_box.h"
#include "core/hull/hull_attitude.h"
#include "core/output/text/console.h"
#include "hydro/wetted.h"

namespace nilas::commands {

namespace {

using Json = nlohmann::ordered_json;

double wetted_area(const geometry::TriangleMesh& mesh, double level) {
  std::vector<hydro::WettedFace> faces;
  hydro::wetted_faces(mesh, Mat3::Identity(), Vec3::Zero(), level, faces);
  double area = 0;
  for (const auto& face : faces) area += face.area;
  return area;
}

Json point(const Vec3& p) { return {p.x(), p.y(), p.z()}; }

Json mended_json(const std::vector<mesh::MeshNote>& notes) {
  Json list = Json::array();
  for (const auto& note : notes) {
    Json places = Json::array();
    for (const auto& p : note.places) places.push_back(point(p));
    list.push_back({{"what", note.what}, {"count", note.count}, {"places_m", places}});
  }
  return list;
}

Json table_json(const std::vector<mesh::PartCount>& table) {
  Json rows = Json::array();
  for (const auto& row : table) rows.push_back({{"parts", row.parts}, {"deviation_m", row.deviation}});
  return rows;
}

/// The displaced volume divided by the volume of the box around the part of the hull below the water.
double block_coefficient(const geometry::TriangleMesh& mesh, double volume, double level) {
  Eigen::AlignedBox3d wet;
  for (const auto& t : mesh.triangles)
    for (std::size_t k = 0; k < 3; ++k) {
      const Vec3 &a = mesh.vertices[t[k]], &b = mesh.vertices[t[(k + 1) % 3]];
      if (a.z() <= level) wet.extend(a);
      if (const auto cut = geometry::edge_cut(a, b, level)) wet.extend(*cut);
    }
  return volume / wet.volume();
}

void add_hydrostatics(Json& report, const geometry::TriangleMesh& mesh, double draught, double centre_z) {
  const double keel = geometry::box_of(mesh).min().z(), level = waterline_level(mesh, draught);
  const hydro::Submerged wet = hydro::submerged_mesh(mesh, Mat3::Identity(), Vec3::Zero(), level);
  const hydro::Waterplane plane = hydro::waterplane(mesh, Mat3::Identity(), Vec3::Zero(), level);
  const double kb = wet.centre.z() - keel, bm = plane.yy / wet.volume, kg = centre_z - keel;
  report["draught_m"] = draught;
  report["displaced_m3"] = wet.volume;
  report["block_coefficient"] = block_coefficient(mesh, wet.volume, level);
  report["kb_m"] = kb;
  report["bm_m"] = bm;
  report["kg_m"] = kg;
  report["gm_m"] = kb + bm - kg;
  report["wetted_area_m2"] = wetted_area(mesh, level);
  report["waterplane_area_m2"] = plane.area;
}

/// The axis that points to the bow, as far as the shape shows it; null if the ends are too alike.
Json bow_of(const PreparedHull& prepared) {
  const geometry::TriangleMesh& mesh = prepared.hull.fluid;
  if (!prepared.use.generated)
    if (const hull::MeshAxis forward = hull::probable_attitude(mesh, false).axes.forward;
        forward != hull::MeshAxes{}.forward)
      return forward.name();
  return hull::bow_direction(hull::measure_hull(mesh)) > 0 ? Json("x") : Json();
}

/// Whether every vertex has a mirror image in y = 0 among the vertices, within the tolerance along each axis [m].
bool mirrored_points(const geometry::TriangleMesh& mesh, double tolerance) {
  std::vector<Vec3> points = mesh.vertices;
  std::sort(points.begin(), points.end(), [](const Vec3& a, const Vec3& b) { return a.x() < b.x(); });
  return std::all_of(points.begin(), points.end(), [&](const Vec3& p) {
    const Vec3 image(p.x(), -p.y(), p.z());
    auto near = std::lower_bound(points.begin(), points.end(), p.x() - tolerance,
                                 [](const Vec3& a, double x) { return a.x() < x; });
    for (; near != points.end() && near->x() <= p.x() + tolerance; ++near)
      if ((*near - image).cwiseAbs().maxCoeff() <= tolerance) return true;
    return false;
  });
}

std::string symmetry_text(const Json& report) {
  if (report["symmetric"] || !report["mirrored_points"]) return "";
  return fmt::format(
      " Its corners are mirror images, but the faces between them are split along different diagonals on the two "
      "sides. They deviate from their images by up to {:.3g} m.",
      report["asymmetry_m"].get<double>());
}

/// The summary of the hull in sentences.
std::string summary(const Json& report) {
  const auto number = [&](const char* key) { return report[key].get<double>(); };
  const Json& bow = report["bow"];
  const std::string ends = bow.is_null() ? "The ends are too alike to distinguish the bow from the stern."
                           : bow == "x"  ? fmt::format("The bow is at x = {:.4g} m.", report["high_m"][0].get<double>())
                                         : fmt::format("The bow seems to point along {}.", bow.get<std::string>());
  return output::wrapped(
             fmt::format("The hull is {:.4g} m long, {:.4g} m wide and {:.4g} m deep. At a draught of {:.4g} m it "
                         "displaces {:.4g} m^3 with a block coefficient of {:.3f}. {}{}",
                         number("length_m"), number("beam_m"), number("depth_m"), number("draught_m"),
                         number("displaced_m3"), number("block_coefficient"), ends, symmetry_text(report)),
             0) +
         "\n";
}

/// A value as text with six digits; hull.json has all digits.
std::string short_text(const Json& value) {
  if (value.is_number_float()) return fmt::format("{:.6g}", value.get<double>());
  if (!value.is_array()) return value.dump();
  std::string text;
  for (const Json& one : value) text += (text.empty() ? "" : " ") + short_text(one);
  return text;
}

std::string list_text(const Json& notes) {
  std::string text;
  constexpr std::size_t k_shown = 3;
  for (const auto& note : notes) {
    text += fmt::format("    {} {}", note["count"].dump(), note["what"].get<std::string>());
    const auto& places = note["places_m"];
    for (std::size_t k = 0; k < std::min(k_shown, places.size()); ++k)
      text += fmt::format("{}({:.4g}, {:.4g}, {:.4g})", k == 0 ? " at " : ", ", places[k][0].get<double>(),
                          places[k][1].get<double>(), places[k][2].get<double>());
    text += places.size() > k_shown ? ", ...\n" : "\n";
  }
  return text;
}

bool within_tolerance(const PreparedHull& prepared) {
  return !prepared.tolerance || prepared.deviation->largest <= *prepared.tolerance;
}

}  // namespace

std::string missed_tolerance(const PreparedHull& prepared, std::size_t most) {
  if (within_tolerance(prepared)) return "";
  const std::size_t parts = prepared.hull.parts.size();
  const Vec3& p = prepared.deviation->place;
  return fmt::format(
             "The convex parts deviate from the mesh by up to {:.4g} m, at ({:.6g}, {:.6g}, {:.6g}) m; asked: {:.4g} "
             "m. ",
             prepared.deviation->largest, p.x(), p.y(), p.z(), *prepared.tolerance) +
         // parts of a symmetric mesh come in pairs
         (parts + 2 > most
              ? fmt::format("--parts allows {}. Give more, or a larger --tolerance.", most)
              : fmt::format("No cut was found that would improve the {} parts, because the hollow that is left is too "
                            "narrow. Give a larger --tolerance.",
                            parts));
}

double waterline_level(const geometry::TriangleMesh& mesh, double draught) {
  const auto box = geometry::box_of(mesh);
  const double depth = box.max().z() - box.min().z();
  constexpr double k_least = 1e-3;  // of the height
  if (!(draught >= k_least * depth && draught < depth))
    throw InputError(fmt::format(
        "--draught: found {:.6g} m; allowed: at least {:.6g} m, a thousandth of the height, and below {:.6g} m, the "
        "height of the hull",
        draught, k_least * depth, depth));
  return box.min().z() + draught;
}

Json hull_report(const PreparedHull& prepared) {
  const geometry::TriangleMesh& mesh = prepared.hull.fluid;
  const geometry::MassProperties unit = geometry::mesh_properties(mesh, 1.0);
  const Mat3& i = unit.inertia;
  const auto box = geometry::box_of(mesh);
  const double off = mesh::asymmetry(mesh), symmetric_within = mesh::k_symmetric_share * box.sizes().maxCoeff();
  const Vec3 size = box.sizes();
  Json report{{"length_m", size.x()},
              {"beam_m", size.y()},
              {"depth_m", size.z()},
              {"bow", bow_of(prepared)},
              {"volume_m3", unit.mass},
              {"centre_m", point(unit.com)},
              {"inertia_per_density_m5", {i(0, 0), i(1, 1), i(2, 2), i(0, 1), i(0, 2), i(1, 2)}},
              {"low_m", point(box.min())},
              {"high_m", point(box.max())},
              {"parts", prepared.hull.parts.size()}};
  if (prepared.deviation) {
    report["deviation_m"] = prepared.deviation->largest;
    report["deviation_precision_m"] = prepared.deviation->unmeasured;
    report["deviation_place_m"] = point(prepared.deviation->place);
  }
  if (prepared.tolerance) {
    report["tolerance_m"] = *prepared.tolerance;
    report["within_tolerance"] = within_tolerance(prepared);
  }
  add_hydrostatics(report, mesh, prepared.draught, unit.com.z());
  report["symmetric"] = off <= symmetric_within;
  report["asymmetry_m"] = off;
  report["symmetry_tolerance_m"] = symmetric_within;
  report["mirrored_points"] = mirrored_points(mesh, symmetric_within);
  report["closed"] = geometry::find_defects(mesh).closed();
  report["triangles"] = mesh.triangles.size();
  report["mended"] = mended_json(prepared.mended);
  report["part_counts"] = table_json(prepared.table);
  report["warnings"] = hull::hull_doubts(mesh, prepared.use);
  return report;
}

std::string report_text(const Json& report) {
  std::string text = summary(report);
  for (const auto& [name, value] : report.items())
    if (name != "mended" && name != "part_counts" && name != "warnings")
      text += fmt::format("  {:<24} {}\n", name, short_text(value));
  text +=
      report["mended"].empty() ? "  mended                   nothing\n" : "  mended\n" + list_text(report["mended"]);
  if (report["part_counts"].empty()) return text;
  text += "  convex parts   worst deviation [m]\n";
  for (const auto& row : report["part_counts"])
    text += fmt::format("  {:>12}   {:.3g}\n", row["parts"].dump(), row["deviation_m"].get<double>());
  return text;
}

}  // namespace nilas::commands
