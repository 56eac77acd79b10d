#pragma once
/// A hull folder: what `nilas hull` writes and scenes refer to.
///   fluid.stl     closed outward triangle mesh in frame V: water forces, mass properties
///   part-NNNN.stl convex parts in frame V: contact
///   hull.json     name, generator parameters where generated, volume, parts
#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "core/geometry/mesh.h"
#include "core/geometry/shape.h"

namespace nilas {

struct Hull {
  TriangleMesh fluid;               ///< frame V: x forward, y port, z up
  std::vector<TriangleMesh> parts;  ///< convex, frame V
};

/// Reads a hull folder, or a single STL file that is itself convex (then its own only part).
/// Throws FileError (missing, unreadable) or InputError (open mesh, part not convex, ...), naming the file.
Hull read_hull(const std::filesystem::path& path);
/// Writes its files into a folder that is there; files of an earlier hull are NewHullFolder's to remove. Throws
/// FileError.
void write_hull(const Hull& hull, const std::filesystem::path& folder, const std::string& json);

/// Parameters of a generated form. x = 0 at the aft end, x = length at the stem head, y = 0 on the centre plane, z = 0
/// at the keel. Waterlines, flare, stem and bilge are built so that the solid is convex; docs/theory/vessel.md has the
/// construction.
struct HullForm {
  std::string kind = "icebreaker";     ///< icebreaker, or wedge: vertical sides, straight wedge bow, flat bottom
  double length = 6.0;                 ///< over all, at the deck [m]
  double beam = 1.2;                   ///< at the design waterline [m]
  double draught = 0.35;               ///< design waterline above the keel [m]
  double depth = 0.6;                  ///< keel to deck [m]
  double stem_angle = 25 * k_deg;      ///< between the stem and still water, icebreaker [rad]
  double entrance_angle = 30 * k_deg;  ///< half angle of the design waterline at the stem, icebreaker [rad]
  double bow_length = 1.8;             ///< of the forebody at the design waterline [m]
  double stern_length = 1.0;           ///< of the run at the design waterline, icebreaker [m]
  double flare_angle = 8 * k_deg;      ///< of the sides from vertical, icebreaker [rad]
  int triangles = 6000;                ///< wanted count of the fluid mesh; the made count is within 5 %
};

/// Form from XML or flag names: length beam draught depth stem_angle_deg entrance_angle_deg bow_length stern_length
/// flare_angle_deg triangles. Lengths that are not named scale with the length. Throws InputError for an unknown name.
HullForm hull_form(const std::string& kind, const std::map<std::string, double>& parameters);

/// Closed, outward, exactly mirror-symmetric about y = 0, convex, coordinates rounded as a binary STL stores them.
/// Throws InputError naming the parameter and what is allowed.
Hull generate_hull(const HullForm& form);

}  // namespace nilas
