#include "apps/nilas/hull_picture.h"

#include <fmt/format.h>

#include <array>
#include <fstream>

#include "core/base/error.h"
#include "core/output/plot.h"

namespace nilas {

namespace {

namespace fs = std::filesystem;
using Colour = std::array<double, 3>;  ///< red, green, blue, 0 to 1

/// Told apart at a glance, and by those who see red as green (Okabe and Ito's, and their tints).
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

/// A triangle as gnuplot's pm3d takes it: a grid of two by two points with a colour. Cut where it is longer than
/// `longest`, because what lies in front is decided by whole triangles.
void write_face(std::ofstream& out, const std::array<Vec3, 3>& p, int rgb, double longest) {
  std::size_t k = 0;
  for (std::size_t i = 1; i < p.size(); ++i)
    if ((p[(i + 1) % 3] - p[i]).norm() > (p[(k + 1) % 3] - p[k]).norm()) k = i;
  const Vec3 &a = p[k], &b = p[(k + 1) % 3], &c = p[(k + 2) % 3], m = 0.5 * (a + b);
  if ((b - a).norm() > longest) {
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

void write_faces(std::ofstream& out, const TriangleMesh& mesh, const Colour& colour, double light, double longest) {
  for (const auto& t : mesh.triangles) {
    std::array<Vec3, 3> p;
    for (std::size_t k = 0; k < 3; ++k) p[k] = mesh.vertices[static_cast<std::size_t>(t[k])];
    write_face(out, p, shaded(colour, (p[1] - p[0]).cross(p[2] - p[0]).normalized(), light), longest);
  }
}

Eigen::AlignedBox3d box_of(const TriangleMesh& mesh) {
  Eigen::AlignedBox3d box;
  for (const auto& p : mesh.vertices) box.extend(p);
  return box;
}

/// Longest edge drawn whole.
double longest_drawn(const TriangleMesh& mesh) {
  constexpr double k_share = 0.06;
  return k_share * box_of(mesh).sizes().maxCoeff();
}

void write_waterline(const fs::path& file, const TriangleMesh& mesh, double level) {
  std::ofstream out(file);
  for (const auto& t : mesh.triangles)
    for (std::size_t k = 0, found = 0; k < 3; ++k) {
      const Vec3 &a = mesh.vertices[static_cast<std::size_t>(t[k])],
                 &b = mesh.vertices[static_cast<std::size_t>(t[(k + 1) % 3])];
      if ((a.z() < level) == (b.z() < level)) continue;
      const Vec3 p = a + (b - a) * ((level - a.z()) / (b.z() - a.z()));
      out << fmt::format("{:.6g} {:.6g} {:.6g}\n", p.x(), p.y(), p.z()) << (++found == 2 ? "\n\n" : "");
    }
}

/// A panel's view: rotation about the horizontal and about the vertical [deg], as gnuplot counts them.
struct View {
  const char* title;
  const char* data;
  double tilt, turn;
};

constexpr double k_width = 1100, k_height = 430;  // of a panel [px]

/// gnuplot's zoom at which the box fills a panel with equal scales, whichever of its sides is long.
double zoom(const Eigen::AlignedBox3d& box, const View& view) {
  constexpr double k_pixels = 230, k_at = 1.35, k_room_across = 900, k_room_up = 300;  // of the longest side, measured
  const Vec3 size = box.sizes();
  const double turn = view.turn * k_pi / 180, tilt = view.tilt * k_pi / 180;
  const double s = std::abs(std::sin(turn)), c = std::abs(std::cos(turn));
  const double across = size.x() * c + size.y() * s;
  const double up = std::abs(std::cos(tilt)) * (size.x() * s + size.y() * c) + std::abs(std::sin(tilt)) * size.z();
  return k_at * size.maxCoeff() / k_pixels * std::min(k_room_across / across, k_room_up / up);
}

/// The faces in order of depth, then the marks over them in the same place.
std::string panel(const View& view, const Eigen::AlignedBox3d& box, std::size_t row, std::size_t rows,
                  const std::string& marks) {
  const double high = 1.0 / static_cast<double>(rows), low = 1 - high * static_cast<double>(row + 1);
  std::string text = fmt::format("set origin 0,{}\nset size 1,{}\nset view {},{},{:.4g}\nset view equal xyz\n", low,
                                 high, view.tilt, view.turn, zoom(box, view));
  text += fmt::format("set title '{}'\nsplot '{}' using 1:2:3:4 with pm3d lc rgb variable notitle\n", view.title,
                      view.data);
  return text + fmt::format("set title ' '\nsplot {}\n", marks);
}

std::string script(const std::string& picture, const TriangleMesh& mesh, const std::vector<View>& views,
                   const std::string& marks) {
  Eigen::AlignedBox3d box = box_of(mesh);
  constexpr double k_spare = 1e-3;  // rounded coordinates stay within
  const Vec3 spare = k_spare * box.sizes();
  box = {box.min() - spare, box.max() + spare};
  std::string text = fmt::format(
      "set terminal pngcairo size {},{} font ',11'\nset output '{}'\nset multiplot\n"
      "set pm3d depthorder noborder\nunset colorbox\nunset key\n"
      "set xrange [{}:{}]\nset yrange [{}:{}]\nset zrange [{}:{}]\n"
      "set xyplane relative 0\nset xlabel 'x [m]'\nset ylabel 'y [m]'\nset zlabel 'z [m]'\n"
      "set xtics offset 0,-0.3\nset ytics autofreq\nset ztics autofreq\nunset border\n",
      k_width, k_height * static_cast<double>(views.size()), picture, box.min().x(), box.max().x(), box.min().y(),
      box.max().y(), box.min().z(), box.max().z());
  for (std::size_t k = 0; k < views.size(); ++k) text += panel(views[k], box, k, views.size(), marks);
  return text + "unset multiplot\n";
}

}  // namespace

void draw_hull(const Hull& hull, double level, const fs::path& folder) {
  const double longest = longest_drawn(hull.fluid);
  {
    std::ofstream above(folder / ".above.dat"), below(folder / ".below.dat"), parts(folder / ".parts.dat");
    write_faces(above, hull.fluid, k_steel, 1, longest);
    write_faces(below, hull.fluid, k_steel, -1, longest);
    for (std::size_t k = 0; k < hull.parts.size(); ++k)
      write_faces(parts, hull.parts[k], k_colours[k % k_colours.size()], -1, longest);
    if (!above || !below || !parts) throw FileError((folder / "hull.png").string() + ": cannot be written");
  }
  write_waterline(folder / ".water.dat", hull.fluid, level);
  const std::string parts_title = fmt::format("{} convex parts, from below", hull.parts.size());
  plot(folder, script("hull.png", hull.fluid,
                      {{"mesh from above; waterline in blue", ".above.dat", 60, 30},
                       {"mesh from below", ".below.dat", 115, 30},
                       {parts_title.c_str(), ".parts.dat", 115, 30}},
                      "'.water.dat' with lines lw 2 lc rgb '#0040ff' notitle"));
  for (const char* name : {".above.dat", ".below.dat", ".parts.dat", ".water.dat"}) fs::remove(folder / name);
}

void draw_faults(const MendedMesh& mesh, const fs::path& folder) {
  const double longest = longest_drawn(mesh.mesh);
  {
    std::ofstream faces(folder / ".faces.dat"), marks(folder / ".marks.dat");
    write_faces(faces, mesh.mesh, k_steel, 1, longest);
    for (const auto& note : mesh.open)
      for (const auto& p : note.places) marks << fmt::format("{:.6g} {:.6g} {:.6g}\n", p.x(), p.y(), p.z());
    if (!faces || !marks) throw FileError((folder / "faults.png").string() + ": cannot be written");
  }
  plot(folder, script("faults.png", mesh.mesh,
                      {{"from above; faults in red", ".faces.dat", 60, 30},
                       {"from below", ".faces.dat", 115, 30},
                       {"from the other side", ".faces.dat", 60, 210}},
                      "'.marks.dat' with points pt 6 ps 2 lw 2 lc rgb '#e00000' notitle"));
  for (const char* name : {".faces.dat", ".marks.dat"}) fs::remove(folder / name);
}

}  // namespace nilas
