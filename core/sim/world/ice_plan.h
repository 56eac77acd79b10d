#pragma once
/// The ice of a scene before it becomes bodies: outlines and properties of every floe, field by field.
#include <optional>
#include <string>
#include <vector>

#include "core/field/field.h"
#include "core/field/vary_floes.h"
#include "core/scene/scene.h"

namespace nilas {

struct PlannedFloe {
  FieldFloe floe;    ///< thickness and density filled; strengths where drawn or read
  std::string name;  ///< of the body
  bool fixed = false;
  bool breakable = false;
  Vec3 velocity = Vec3::Zero();           ///< [m/s]
  double z = 0;                           ///< offset from floating equilibrium [m]
  FloeValues means{};                     ///< of its properties, before they vary; 0: not known
  std::vector<TexturedProperty> texture;  ///< of those that vary within it
};

/// One <field>, or all the single floes.
struct PlannedIce {
  std::string name;                             ///< "field 1", "single floes"
  std::optional<FieldScene> field;              ///< none: the single floes
  std::optional<PackedSpec> packed;             ///< of kind "packed"
  std::vector<std::vector<Vec2>> hull;          ///< outline that its floes keep clear of, in G [m]
  std::vector<std::vector<Vec2>> keep_out;      ///< the same with the margin
  double concentration = 0, worst_overlap = 0;  ///< see FieldResult
  int left_out = 0;
  double seconds = 0;                ///< of wall time that its generation took
  std::vector<WeakLine> weak_lines;  ///< in G
  std::vector<PlannedFloe> floes;
};

/// How the scene's <vary> spread the properties of its floes. Throws InputError naming the line where the ice would be
/// as heavy as the water that it floats in.
FloeVariation floe_variation(const Scene& scene);

}  // namespace nilas
