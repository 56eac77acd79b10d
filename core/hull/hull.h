#pragma once
/// A hull folder: what `nilas hull` writes and scenes refer to.
///   fluid.stl     closed outward triangle mesh in frame V: water forces, mass properties
///   part-NNNN.stl convex parts in frame V: contact
///   hull.json     name, generator parameters where generated, volume, parts
#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "core/choices/defaults.h"
#include "core/choices/vessel_choices.h"
#include "core/geometry/mesh.h"
#include "core/geometry/shape.h"

namespace nilas::hull {

struct Hull {
  geometry::TriangleMesh fluid;               ///< frame V: x forward, y port, z up
  std::vector<geometry::TriangleMesh> parts;  ///< convex, frame V
};

/// Reads a hull folder, or a single convex STL file, which is then its own only part. Coordinates are multiplied by
/// `scale` > 0. Throws FileError (missing, unreadable) or InputError (open mesh, part not convex, ...), naming the
/// file.
Hull read_hull(const std::filesystem::path& path, double scale = 1);
/// Writes the hull's files into an existing folder; NewHullFolder removes files of an earlier hull. Throws FileError.
void write_hull(const Hull& hull, const std::filesystem::path& folder, const std::string& json);

/// Parameters of a generated form. x = 0 at the aft end, x = length at the stem head, y = 0 on the centre plane, z = 0
/// at the keel. Waterlines, flare, stem and bilge are built so that the solid is convex; docs/theory/vessel.md has the
/// construction.
struct HullForm {
  HullKind kind = HullKind::icebreaker;
  double length = defaults::k_hull_length;                 ///< length over all, at the deck [m]
  double beam = defaults::k_hull_beam;                     ///< beam at the design waterline [m]
  double draught = defaults::k_hull_draught;               ///< design waterline above the keel [m]
  double depth = defaults::k_hull_depth;                   ///< keel to deck [m]
  double stem_angle = defaults::k_stem_angle_deg * k_deg;  ///< angle between the stem and still water, icebreaker [rad]
  double entrance_angle =
      defaults::k_entrance_angle_deg * k_deg;      ///< half angle of the design waterline at the stem, icebreaker [rad]
  double bow_length = defaults::k_bow_length;      ///< length of the forebody at the design waterline [m]
  double stern_length = defaults::k_stern_length;  ///< length of the run at the design waterline, icebreaker [m]
  double flare_angle = defaults::k_flare_angle_deg * k_deg;  ///< angle of the sides from vertical, icebreaker [rad]
  int triangles = defaults::k_hull_triangles;  ///< requested for the fluid mesh; the actual number is within 5 %
};

/// The form from parameters with XML or flag names: length beam draught depth stem_angle_deg entrance_angle_deg
/// bow_length stern_length flare_angle_deg triangles. Missing lengths scale with the length. Throws InputError for a
/// name that the kind does not have, or a number of triangles that is not whole.
HullForm hull_form(HullKind kind, const std::map<std::string, double>& parameters);
/// The same by the name of the kind. Throws InputError for an unknown one, too.
HullForm hull_form(const std::string& kind, const std::map<std::string, double>& parameters);

/// Generates a hull: closed, outward, exactly mirror-symmetric about y = 0, convex, with coordinates rounded as in
/// binary STL. Throws InputError naming the parameter and what is allowed.
Hull generate_hull(const HullForm& form);

}  // namespace nilas::hull
