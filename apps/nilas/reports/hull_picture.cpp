#include "apps/nilas/reports/hull_picture.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <fstream>
#include <map>
#include <nlohmann/json.hpp>

#include "apps/nilas/reports/templates.h"
#include "apps/report/hull_lines.h"
#include "core/base/error.h"
#include "core/geometry/mesh_box.h"
#include "core/output/text/fill_template.h"
#include "core/output/text/plot.h"

namespace nilas::commands {

namespace {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;
using Colour = std::array<double, 3>;  ///< red, green, blue, 0 to 1

/// Colours that everyone can distinguish, colour-blind readers too (those of Okabe and Ito, and their tints).
constexpr std::array<Colour, 8> k_colours{{{0.90, 0.62, 0.00},
                                           {0.34, 0.71, 0.91},
                                           {0.00, 0.62, 0.45},
                                           {0.94, 0.89, 0.26},
                                           {0.00, 0.45, 0.70},
                                           {0.84, 0.37, 0.00},
                                           {0.80, 0.47, 0.65},
                                           {0.60, 0.60, 0.60}}};
constexpr Colour k_steel{0.72, 0.76, 0.80};

int shaded(const Colour& colour, const Vec3& normal, double from_below) {
  const Vec3 light = Vec3(0.4, -0.6, from_below).normalized();
  constexpr double k_ambient = 0.45;
  const double bright = k_ambient + (1 - k_ambient) * std::max(0.0, normal.dot(light));
  int rgb = 0;
  for (const double c : colour) rgb = rgb * 256 + static_cast<int>(255 * std::clamp(c * bright, 0.0, 1.0));
  return rgb;
}

/// Writes a triangle as gnuplot's pm3d takes it: a grid of two by two points with a colour. A triangle longer than
/// `longest` [m] is cut, because gnuplot sorts whole triangles by depth. Very thin ones are not, since nobody sees it.
void write_face(std::ofstream& out, const std::array<Vec3, 3>& p, int rgb, double longest) {
  std::size_t k = 0;
  for (std::size_t i = 1; i < p.size(); ++i)
    if ((p[(i + 1) % 3] - p[i]).norm() > (p[(k + 1) % 3] - p[k]).norm()) k = i;
  const Vec3 &a = p[k], &b = p[(k + 1) % 3], &c = p[(k + 2) % 3], m = 0.5 * (a + b);
  constexpr double k_seen = 0.05;  // area over that of the square of `longest`
  if ((b - a).norm() > longest && 0.5 * (b - a).cross(c - a).norm() > k_seen * longest * longest) {
    write_face(out, {a, m, c}, rgb, longest);
    write_face(out, {m, b, c}, rgb, longest);
    return;
  }
  const auto line = [&](const Vec3& x) { out << fmt::format("{:.6g} {:.6g} {:.6g} {}\n", x.x(), x.y(), x.z(), rgb); };
  line(a);
  line(b);
  out << "\n";
  line(c);
  line(c);
  out << "\n\n";
}

/// Writes the edges that do not join two triangles: around holes, and where several sheets meet.
void write_open_edges(const fs::path& file, const geometry::TriangleMesh& mesh) {
  std::map<std::pair<int, int>, int> sides;
  for (const auto& t : mesh.triangles)
    for (std::size_t k = 0; k < 3; ++k) ++sides[std::minmax(t[k], t[(k + 1) % 3])];
  std::ofstream out(file);
  for (const auto& [edge, count] : sides) {
    if (count == 2) continue;
    for (const int v : {edge.first, edge.second}) {
      const Vec3& x = mesh.vertices[v];
      out << fmt::format("{:.6g} {:.6g} {:.6g}\n", x.x(), x.y(), x.z());
    }
    out << "\n\n";
  }
}

/// The view of a panel. `tilt` and `turn` are gnuplot's rotations about the horizontal and about the vertical [deg].
struct HullView {
  const char* title;
  const char* data;
  double tilt, turn;
  const char* key = "";  ///< the name of the waterline, where the panel has a key

  /// The unit vector towards the eye.
  Vec3 direction() const {
    const double t = tilt * k_deg, r = turn * k_deg;
    return {std::sin(t) * std::sin(r), -std::sin(t) * std::cos(r), std::cos(t)};
  }
};

/// Writes the faces of a closed surface that look at the eye. Others would show through at the edges, because gnuplot
/// sorts whole triangles by depth. All faces of an open surface (`two_sided`) are written.
void write_faces(std::ofstream& out, const geometry::TriangleMesh& mesh, const Colour& colour, const HullView& view,
                 double longest, bool two_sided = false) {
  const Vec3 eye = view.direction();
  const double light = eye.z() > 0 ? 1 : -1;
  for (const auto& t : mesh.triangles) {
    std::array<Vec3, 3> p;
    for (std::size_t k = 0; k < 3; ++k) p[k] = mesh.vertices[t[k]];
    const Vec3 normal = (p[1] - p[0]).cross(p[2] - p[0]).normalized();
    if (two_sided || normal.dot(eye) > 0) write_face(out, p, shaded(colour, normal, light), longest);
  }
}

/// The mesh with the vertices in each cube of a grid merged, and the triangles that this leaves. `cell`: side of the
/// cubes [m].
geometry::TriangleMesh coarsened(const geometry::TriangleMesh& mesh, double cell) {
  std::map<std::array<double, 3>, int> first;
  geometry::TriangleMesh coarse{mesh.vertices, {}};
  std::vector<int> stand_in(mesh.vertices.size());
  for (std::size_t v = 0; v < mesh.vertices.size(); ++v) {
    const Vec3 cube = (mesh.vertices[v] / cell).array().floor();
    stand_in[v] = first.try_emplace({cube.x(), cube.y(), cube.z()}, static_cast<int>(v)).first->second;
  }
  for (auto t : mesh.triangles) {
    for (int& v : t) v = stand_in[v];
    if (t[0] != t[1] && t[1] != t[2] && t[2] != t[0]) coarse.triangles.push_back(t);
  }
  return coarse;
}

/// The mesh, coarsened until gnuplot can draw it in seconds and within a gigabyte. Triangles below a pixel show
/// nothing.
geometry::TriangleMesh drawable(const geometry::TriangleMesh& mesh) {
  constexpr std::size_t k_most = 50000;
  constexpr double k_finest = 1.0 / 512, k_coarser = 1.5;  // of the longest side
  geometry::TriangleMesh drawn = mesh;
  for (double cell = k_finest * geometry::box_of(mesh).sizes().maxCoeff(); drawn.triangles.size() > k_most;
       cell *= k_coarser)
    drawn = coarsened(mesh, cell);
  return drawn;
}

/// The files that gnuplot reads. They are removed at the end of the scope, after an exception too.
class DataFiles {
 public:
  DataFiles(fs::path folder, std::vector<const char*> names) : folder_(std::move(folder)), names_(std::move(names)) {}
  ~DataFiles() {
    std::error_code ignored;
    for (const char* name : names_) fs::remove(folder_ / name, ignored);
  }
  DataFiles(const DataFiles&) = delete;
  DataFiles& operator=(const DataFiles&) = delete;

 private:
  fs::path folder_;
  std::vector<const char*> names_;
};

/// The longest edge that is drawn whole [m].
double longest_drawn(const geometry::TriangleMesh& mesh) {
  constexpr double k_share = 0.06;
  return k_share * geometry::box_of(mesh).sizes().maxCoeff();
}

void write_waterline(const fs::path& file, const geometry::TriangleMesh& mesh, double level) {
  std::ofstream out(file);
  for (const report::Segment& line : report::waterline(mesh, level)) {
    for (const Vec3& p : line) out << fmt::format("{:.6g} {:.6g} {:.6g}\n", p.x(), p.y(), p.z());
    out << "\n\n";
  }
}

constexpr double k_width = 1100, k_height = 430;  // of a panel [px]

/// The zoom of gnuplot at which the box fills a panel with equal scales, whichever of its sides is long.
double zoom(const Eigen::AlignedBox3d& box, const HullView& view) {
  constexpr double k_pixels = 230, k_at = 1.35, k_room_across = 900, k_room_up = 300;  // of the longest side, measured
  const Vec3 size = box.sizes();
  const double turn = view.turn * k_pi / 180, tilt = view.tilt * k_pi / 180;
  const double s = std::abs(std::sin(turn)), c = std::abs(std::cos(turn));
  const double across = size.x() * c + size.y() * s;
  const double up = std::abs(std::cos(tilt)) * (size.x() * s + size.y() * c) + std::abs(std::sin(tilt)) * size.z();
  return k_at * size.maxCoeff() / k_pixels * std::min(k_room_across / across, k_room_up / up);
}

/// The end that a scene takes as the bow, amidships at deck height.
Json bow_of_box(const Eigen::AlignedBox3d& box) {
  const auto text = [](double x) { return fmt::format("{:.6g}", x); };
  return {{"x", text(box.max().x())}, {"y", text(box.center().y())}, {"z", text(box.max().z())}};
}

/// The panels, one above the other.
Json panels_of(const std::vector<HullView>& views, const Eigen::AlignedBox3d& box) {
  Json panels = Json::array();
  const double high = 1.0 / static_cast<double>(views.size());
  for (std::size_t row = 0; row < views.size(); ++row)
    panels.push_back({{"low", 1 - high * static_cast<double>(row + 1)},
                      {"high", high},
                      {"tilt", views[row].tilt},
                      {"turn", views[row].turn},
                      {"zoom", fmt::format("{:.4g}", zoom(box, views[row]))},
                      {"title", views[row].title},
                      {"key", views[row].key},
                      {"data", views[row].data}});
  return panels;
}

/// The step of an axis [m], 1, 2 or 5 times a power of ten, of which a short side has about two.
double tics(double side) {
  const double rough = 0.45 * side, power = std::pow(10, std::floor(std::log10(rough)));
  const double share = rough / power;
  return power * (share < 2 ? 1 : share < 5 ? 2 : 5);
}

/// The script of a picture. `bow`: the place of the bow of a prepared hull; null for a faulty mesh.
std::string script(const std::string& picture, const geometry::TriangleMesh& mesh, const std::vector<HullView>& views,
                   const Json& bow) {
  Eigen::AlignedBox3d box = geometry::box_of(mesh);
  constexpr double k_spare = 1e-3;      // rounded coordinates stay within
  constexpr double k_thinnest = 0.025;  // of the longest side: gnuplot refuses a range without extent
  const Vec3 spare =
      (k_spare * box.sizes().array()).max(k_thinnest * box.sizes().maxCoeff() - 0.5 * box.sizes().array());
  box = {box.min() - spare, box.max() + spare};
  const Json data{{"width", k_width},
                  {"height", k_height * static_cast<double>(views.size())},
                  {"picture", picture},
                  {"x_low", box.min().x()},
                  {"x_high", box.max().x()},
                  {"y_low", box.min().y()},
                  {"y_high", box.max().y()},
                  {"z_low", box.min().z()},
                  {"z_high", box.max().z()},
                  {"y_tics", tics(box.sizes().y())},
                  {"z_tics", tics(box.sizes().z())},
                  {"bow", bow},
                  {"panels", panels_of(views, box)}};
  return output::fill_template(nilas_template("hull.gnuplot"), data, output::Escape::gnuplot);
}

}  // namespace

void draw_hull(const hull::Hull& hull, double level, const fs::path& folder) {
  const double longest = longest_drawn(hull.fluid);
  const DataFiles removed(folder, {".above.dat", ".below.dat", ".parts.dat", ".water.dat"});
  const geometry::TriangleMesh drawn = drawable(hull.fluid);
  const std::string parts_title =
      fmt::format("{} convex part{}, from below", hull.parts.size(), hull.parts.size() == 1 ? "" : "s");
  const std::string waterline =
      fmt::format("waterline at a draught of {:.4g} m", level - geometry::box_of(hull.fluid).min().z());
  const std::vector<HullView> views{{"mesh from above", ".above.dat", 60, 30, waterline.c_str()},
                                    {"mesh from below", ".below.dat", 115, 30},
                                    {parts_title.c_str(), ".parts.dat", 115, 30}};
  {
    std::ofstream above(folder / ".above.dat"), below(folder / ".below.dat"), parts(folder / ".parts.dat");
    write_faces(above, drawn, k_steel, views[0], longest);
    write_faces(below, drawn, k_steel, views[1], longest);
    for (std::size_t k = 0; k < hull.parts.size(); ++k)
      write_faces(parts, drawable(hull.parts[k]), k_colours[k % k_colours.size()], views[2], longest);
    if (!above || !below || !parts) throw FileError((folder / "hull.png").string() + ": cannot be written");
  }
  write_waterline(folder / ".water.dat", hull.fluid, level);
  output::plot(folder, script("hull.png", hull.fluid, views, bow_of_box(geometry::box_of(hull.fluid))));
}

void draw_faults(const mesh::MendedMesh& mesh, const fs::path& folder) {
  const double longest = longest_drawn(mesh.mesh);
  const DataFiles removed(folder, {".faces.dat", ".marks.dat", ".edges.dat"});
  {
    std::ofstream faces(folder / ".faces.dat"), marks(folder / ".marks.dat");
    write_faces(faces, drawable(mesh.mesh), k_steel, {"", "", 60, 30}, longest, true);
    for (const auto& note : mesh.open)
      for (const auto& p : note.places) marks << fmt::format("{:.6g} {:.6g} {:.6g}\n", p.x(), p.y(), p.z());
    if (!faces || !marks) throw FileError((folder / "faults.png").string() + ": cannot be written");
  }
  write_open_edges(folder / ".edges.dat", mesh.mesh);
  output::plot(folder, script("faults.png", mesh.mesh,
                              {{"from above; faults in red", ".faces.dat", 60, 30},
                               {"from below", ".faces.dat", 115, 30},
                               {"from the other side", ".faces.dat", 60, 210}},
                              nullptr));
}

}  // namespace nilas::commands
