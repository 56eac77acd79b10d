#include "apps/report/page/place_sections.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>

#include "apps/report/page/words.h"

namespace nilas::report {

namespace {

constexpr double k_mega = 1e6;

/// The height of the water in the frame of the contacts [m].
double water_in_frame(const RunFindings& found) {
  const double level = found.run.scene && found.run.scene->water ? found.run.scene->water->level : 0;
  return level - found.contacts->floating_level;
}

WaterlineOutline outline_of(const RunFindings& found) {
  const Vec2 ahead = found.body->is_vessel ? Vec2(Vec2::UnitX())
                     : found.cause         ? found.cause->course
                                           : Vec2(Vec2::UnitX());
  return {found.body->mesh, water_in_frame(found), ahead};
}

/// The pressure that the crushing law states on an area [m^2], in Pa.
double law_pressure(const scene::FractureScene& fracture, double area) {
  const scene::CrushingScene& crushing = *fracture.crushing;
  if (crushing.model != CrushingModel::pressure_area) return fracture.compressive_strength;
  return crushing.coefficient * std::pow(area, crushing.exponent);
}

/// The area on which the law's pressure makes this force [m^2].
double nominal_area(const scene::FractureScene& fracture, double force) {
  const scene::CrushingScene& crushing = *fracture.crushing;
  if (crushing.model != CrushingModel::pressure_area) return force / fracture.compressive_strength;
  return std::pow(force / crushing.coefficient, 1 / (1 + crushing.exponent));
}

/// The largest normal force of one floe in one step from contacts that crush [N].
double largest_crushing(const HullContacts& contacts) {
  double largest = 0;
  std::map<std::int64_t, double> floes;
  std::int64_t step = -1;
  for (std::size_t k = 0; k < contacts.time.size(); ++k) {
    if (!contacts.crushes[k]) continue;
    if (contacts.step[k] != step) floes.clear();
    step = contacts.step[k];
    largest = std::max(largest, floes[contacts.other[k]] += contacts.force[k].dot(contacts.normal[k]));
  }
  return largest;
}

/// The side of the smallest panel [m]: the ice acts at points, so smaller panels would show these.
double least_panel(const RunFindings& found, const WaterlineOutline& outline) {
  constexpr double k_around = 200;
  const double thickness = found.run.scene && found.run.scene->ice ? found.run.scene->ice->thickness : 0;
  return std::max(thickness, outline.length() / k_around);
}

Plot pressure_plot(const std::vector<PanelPressure>& panels, const RunFindings& found, bool has_law) {
  Plot plot{.id = "pressure-area",
            .title = "Largest pressure over the area that it is averaged over",
            .x_label = "area [m²]",
            .y_label = "pressure [MPa]",
            .log_x = true,
            .log_y = true};
  Curve measured{.name = "panels of the hull"};
  Curve law{.name = "law of the scene, within the contact"};
  for (const PanelPressure& panel : panels) {
    measured.x.push_back(panel.area);
    measured.y.push_back(panel.pressure / k_mega);
    if (!has_law) continue;
    law.x.push_back(panel.area);
    law.y.push_back(law_pressure(*found.run.scene->fracture, panel.area) / k_mega);
  }
  plot.curves.push_back(std::move(measured));
  if (has_law) plot.curves.push_back(std::move(law));
  return plot;
}

void explain_missing(const RunFindings& found, Section& section) {
  if (found.load == nullptr)
    section.gaps.emplace_back("Nothing in the run bears a load.");
  else if (!found.shapes)
    section.gaps.emplace_back("The shape of vessel or body is not known, since the scene cannot be built again here.");
  else if (!found.contacts)
    section.gaps.emplace_back("The contacts of the run cannot be read, or it stored none.");
  else
    section.gaps.emplace_back("Nothing pressed, so there is no load to place.");
}

}  // namespace

std::optional<HullPicture> hull_picture(const RunFindings& found) {
  if (!found.contacts || found.body == nullptr || found.contacts->time.empty()) return std::nullopt;
  const WaterlineOutline outline = outline_of(found);
  HullPicture picture{place_load(*found.contacts, outline), &found.body->mesh, outline.length(), water_in_frame(found),
                      found.body->is_vessel};
  if (!found.cause) return picture;
  picture.cause = &*found.cause;
  picture.peak_along = outline.along(found.cause->place.head<2>());
  picture.is_floe = found.floe_made_peak;
  return picture;
}

nlohmann::ordered_json hull_json(const HullPicture& picture) {
  using Json = nlohmann::ordered_json;
  const auto rounded = [](double value) { return std::round(value * 1e4) / 1e4; };
  Json vertices = Json::array(), triangles = Json::array(), cells = Json::array();
  for (const Vec3& p : picture.mesh->vertices)
    for (int k = 0; k < 3; ++k) vertices.push_back(rounded(p[k]));
  for (const auto& triangle : picture.mesh->triangles)
    for (const int corner : triangle) triangles.push_back(corner);
  for (const PlaceCell& cell : picture.load.cells)
    cells.push_back({rounded(cell.along), rounded(cell.height), rounded(cell.place.x()), rounded(cell.place.y()),
                     rounded(cell.place.z()), cell.impulse, cell.peak});
  Json peak = nullptr;
  if (picture.cause != nullptr)
    peak = {{"along", rounded(picture.peak_along)},
            {"height", rounded(picture.cause->place.z())},
            {"name", fmt::format("{} {}", picture.is_floe ? "floe" : "body", picture.cause->floe)}};
  return {{"vertices", vertices},
          {"triangles", triangles},
          {"cells", cells},
          {"width", picture.load.width},
          {"outline", picture.outline},
          {"water", picture.water},
          {"vessel", picture.is_vessel},
          {"peak", peak}};
}

Section place_section(const RunFindings& found, const std::optional<HullPicture>& picture) {
  Section section{.id = "place", .title = "Load by place"};
  if (!picture) {
    explain_missing(found, section);
    return section;
  }
  section.has_hull = true;
  section.text.push_back(fmt::format(
      "Each square is {:.3g} m wide and shows the impulse that all contacts in it gave over the whole run, friction "
      "included. All squares together have {:.4g} N s. The surface is unrolled along the convex outline at the "
      "waterline, from {}; the height is measured from the water.",
      picture->load.width, picture->load.impulse,
      picture->is_vessel ? "the bow, with the port side to the right" : "the place that faces the drift"));
  if (found.cause)
    section.text.push_back(fmt::format("The ring marks where {} {} made the largest load of one step, at {}.",
                                       found.floe_made_peak ? "floe" : "body", found.cause->floe,
                                       place_text(found.cause->place)));
  return section;
}

Section pressure_section(const RunFindings& found) {
  Section section{.id = "pressure", .title = "Pressure over area"};
  const auto& scene = found.run.scene;
  const bool has_law = scene && scene->fracture && scene->fracture->crushing;
  if (!found.contacts || found.body == nullptr || found.contacts->time.empty()) {
    explain_missing(found, section);
    return section;
  }
  if (!(found.contacts->share_crushing > 0)) {
    section.text.emplace_back(
        "No ice crushed in this run. A rigid contact acts in a point, and its force of one step depends on the time "
        "step, so it has no pressure.");
    return section;
  }
  const WaterlineOutline outline = outline_of(found);
  const auto panels = panel_pressures(*found.contacts, outline, least_panel(found, outline));
  constexpr double k_percent = 100;
  section.text.push_back(fmt::format(
      "For square panels of the unrolled surface, the largest mean pressure in any step: the normal force on the panel "
      "over its area. Four layouts of panels were tried, half a panel apart. Crushing contacts gave {:.3g} % of the "
      "impulse.",
      k_percent * found.contacts->share_crushing));
  if (has_law) {
    const double force = largest_crushing(*found.contacts);
    section.text.push_back(
        fmt::format("The area in contact is not stored. By the scene's law of crushing, the largest normal force of "
                    "one floe in one "
                    "step, {}, had {:.3g} m² at {:.3g} MPa. A panel larger than the contact is partly free of ice, so "
                    "it lies below "
                    "the law.",
                    output::force_text(force), nominal_area(*scene->fracture, force),
                    law_pressure(*scene->fracture, nominal_area(*scene->fracture, force)) / k_mega));
  }
  section.plots.push_back(pressure_plot(panels, found, has_law));
  return section;
}

}  // namespace nilas::report
