#include "core/hull/hull_doubts.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <string_view>

#include "core/hull/hull_attitude.h"

namespace nilas::hull {

namespace {

std::string size_text(const Vec3& size) {
  return fmt::format("The hull is {:.4g} m long (x), {:.4g} m wide (y) and {:.4g} m high (z)", size.x(), size.y(),
                     size.z());
}

/// The command that makes the hull again with these axes of the file and this scale.
std::string command(const HullUse& use, const MeshAxes& axes, double scale) {
  std::string text = "nilas hull " + use.file;
  if (axes.forward != MeshAxes{}.forward) text += " --forward " + axes.forward.name();
  if (axes.up != MeshAxes{}.up) text += " --up " + axes.up.name();
  if (std::abs(scale - 1) > 1e-9) text += fmt::format(" --scale {:.6g}", scale);
  return text;
}

/// The axis of the file that is this axis of frame V.
MeshAxis in_file(const MeshAxis& axis, const MeshAxes& drawn) {
  MeshAxis found = axis.of == 0 ? drawn.forward : axis.of == 1 ? drawn.port() : drawn.up;
  found.sign *= axis.sign;
  return found;
}

/// Describes the feature of the shape.
std::string seen(const HullAttitude& attitude, const Vec3& size) {
  switch (attitude.sign) {
    case AttitudeSign::symmetry:
      return size_text(size) + ", and its port and starboard sides are not alike.";
    case AttitudeSign::ends:
      return "The hull is broad at its fore end and sharp at its aft end.";
    case AttitudeSign::faces:
      return "The hull is level at the bottom and tapers at the top.";
    default:
      return size_text(size) + ".";
  }
}

std::string mistake(const MeshAxes& axes) {
  const std::string forward = axes.forward.name(), up = axes.up.name();
  std::string with = forward + " forward";
  if (axes.forward == MeshAxes{}.forward)
    with = up + " up";
  else if (axes.up != MeshAxes{}.up)
    with += fmt::format(" and {} up", up);
  std::string probably = "It probably lies across";
  if (axes.forward.of == 2)
    probably = "It probably stands on end";
  else if (axes.up.of != 2)
    probably = axes.forward.of == 0 ? "It probably lies on its side" : "It probably lies across and on its side";
  else if (axes.forward.of == 0)
    probably = axes.up.sign > 0        ? "It probably lies stern first"
               : axes.forward.sign > 0 ? "It is probably upside down"
                                       : "It is probably upside down and stern first";
  return fmt::format("{}, with {}.", probably, with);
}

void doubt_attitude(const HullAttitude& attitude, const Vec3& size, const HullUse& use,
                    std::vector<std::string>& doubts) {
  if (attitude.as_it_should()) return;
  const MeshAxes axes{in_file(attitude.axes.forward, use.drawn), in_file(attitude.axes.up, use.drawn)};
  doubts.push_back(fmt::format("{} {} In a hull x must point forward, y to port and z up. Turn it: {}",
                               seen(attitude, size), mistake(attitude.axes), command(use, axes, use.scale)));
}

/// A unit in which a file was probably drawn, where it was taken in another one.
struct Unit {
  const char* mistake;
  double factor;  ///< factor that corrects lengths [-]
};
constexpr Unit k_smaller[] = {{"in millimetres", 1e-3}, {"in centimetres", 1e-2}, {"in feet", 0.3048}};
constexpr Unit k_larger[] = {{"in metres, and was taken in millimetres", 1e3},
                             {"in metres, and was taken in centimetres", 1e2}};

template <std::size_t N>
std::string probable_units(const Unit (&units)[N], double length, const HullUse& use) {
  constexpr double k_short = 1, k_long = 500;  // model and largest ship [m]
  std::string text;
  for (const auto& unit : units)
    if (const double mended = length * unit.factor; mended >= k_short && mended <= k_long)
      text += fmt::format("{}{}: it is then {:.4g} m long ({})", text.empty() ? " The file is probably " : ", or ",
                          unit.mistake, mended, command(use, use.drawn, use.scale * unit.factor));
  return text.empty() ? " Its unit is probably not the one it was taken in." : text;
}

void doubt_size(const Vec3& size, const HullUse& use, std::vector<std::string>& doubts) {
  constexpr double k_shortest = 0.3, k_longest = 500;  // of a model, and a little above the longest ship [m]
  const double length = size.maxCoeff();
  if (length > k_longest)
    doubts.push_back(fmt::format("The hull is {:.6g} m long, longer than any ship.", length) +
                     (use.generated ? "" : probable_units(k_smaller, length, use)));
  if (length < k_shortest)
    doubts.push_back(fmt::format("The hull is only {:.4g} m long.", length) +
                     (use.generated ? "" : probable_units(k_larger, length, use)));
}

/// A port or starboard half, closed in the centre plane.
bool half_a_hull(const geometry::TriangleMesh& mesh, const HullMeasures& m) {
  constexpr double k_at_zero = 1e-3, k_alike = 0.02, k_flat_share = 0.4;
  const Vec3 size = m.size();
  if (std::min(std::abs(m.low.y()), std::abs(m.high.y())) > k_at_zero * size.y() || m.lopsided.y() < k_alike)
    return false;
  double in_plane = 0;
  for (const auto& t : mesh.triangles) {
    std::array<Vec3, 3> p;
    for (std::size_t k = 0; k < 3; ++k) p[k] = mesh.vertices[t[k]];
    const double off = std::max({std::abs(p[0].y()), std::abs(p[1].y()), std::abs(p[2].y())});
    if (off <= k_at_zero * size.y()) in_plane += 0.5 * (p[1] - p[0]).cross(p[2] - p[0]).norm();
  }
  return in_plane > k_flat_share * size.x() * size.z();
}

void doubt_mass(const Vec3& size, const HullUse& use, std::vector<std::string>& doubts) {
  constexpr double k_far = 2.5, k_feet_low = 25, k_feet_high = 50;  // 35.3 cubic feet are a cubic metre
  if (!use.displaced || !use.mass_afloat || *use.displaced <= k_far * *use.mass_afloat) return;
  const double ratio = *use.displaced / *use.mass_afloat;
  std::string text =
      fmt::format("The hull displaces {:.4g} m^3 where it is placed, {:.3g} times what its mass displaces afloat.",
                  *use.displaced, ratio);
  if (ratio > k_feet_low && ratio < k_feet_high && size.maxCoeff() > 1)
    text += " The mesh is probably in feet: " + command(use, use.drawn, use.scale * 0.3048);
  else
    text += " Its mass, its height or the mesh's unit is probably wrong.";
  doubts.push_back(text);
}

void doubt_draught(const Vec3& size, const HullUse& use, std::vector<std::string>& doubts) {
  if (!use.draught) return;
  const double share = *use.draught / size.z(), beam_share = std::min(size.x(), size.y()) / *use.draught;
  constexpr double k_least_afloat = 0.1, k_least_given = 0.03, k_shallow = 20;  // of the height; beam over draught
  if (share > (use.mass_afloat ? k_least_afloat : k_least_given) || beam_share < k_shallow) return;
  if (use.mass_afloat)
    doubts.push_back(fmt::format(
        "The hull floats with {:.3g} m of its {:.4g} m height in the water: it is large for its "
        "mass. The mesh may be in feet (--scale {:.6g}), or the mass too small, as tonnes given for kilograms are.",
        *use.draught, size.z(), 0.3048 * use.scale));
  else
    doubts.push_back(
        fmt::format("The draught of {:.3g} m is small for a hull of {:.4g} m height. One of them is probably "
                    "in another unit.",
                    *use.draught, size.z()));
}

}  // namespace

static constexpr std::string_view k_half =
    "The hull lies on one side of y = 0, with a flat face there: it is probably half a hull. Mirror it in the program "
    "that drew it.";

std::vector<std::string> hull_doubts(const geometry::TriangleMesh& mesh, const HullUse& use) {
  std::vector<std::string> doubts;
  const HullMeasures m = measure_hull(mesh);
  doubt_size(m.size(), use, doubts);
  if (!use.generated) {
    const HullAttitude attitude = probable_attitude(mesh, use.fixed);
    // a hull on its side may have its flat deck or bottom at y = 0 too
    if (attitude.sign != AttitudeSign::symmetry && half_a_hull(mesh, m))
      doubts.emplace_back(k_half);
    else
      doubt_attitude(attitude, m.size(), use, doubts);
  }
  doubt_mass(m.size(), use, doubts);
  if (!use.fixed) doubt_draught(m.size(), use, doubts);
  return doubts;
}

}  // namespace nilas::hull
