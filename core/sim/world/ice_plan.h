#pragma once
/// The ice of a scene before it becomes bodies: outlines and properties of every floe, field by field.
#include <optional>
#include <string>
#include <vector>

#include "core/field/field.h"
#include "core/field/vary_floes.h"
#include "core/scene/scene.h"

namespace nilas::sim {

struct PlannedFloe {
  field::FieldFloe floe;  ///< thickness and density are set; strengths only where drawn or read
  std::string name;       ///< name of the body
  bool fixed = false;
  bool breakable = false;
  Vec3 velocity = Vec3::Zero();                  ///< [m/s]
  double z = 0;                                  ///< offset from floating equilibrium [m]
  field::FloeValues means{};                     ///< mean properties before variation; 0: not known
  std::vector<field::TexturedProperty> texture;  ///< properties that vary within the floe
};

/// One <field>, or all the single floes.
struct PlannedIce {
  std::string name;                             ///< "field 1", "single floes"
  std::optional<scene::FieldScene> field;       ///< empty: the single floes
  std::optional<field::PackedSpec> packed;      ///< only for kind "packed"
  std::vector<std::vector<Vec2>> hull;          ///< hull outlines that its floes keep clear of, frame G [m]
  std::vector<std::vector<Vec2>> keep_out;      ///< the same outlines with the margin
  double concentration = 0, worst_overlap = 0;  ///< see FieldResult
  int left_out = 0;
  double seconds = 0;                        ///< wall time of its generation [s]
  std::vector<bodies::WeakLine> weak_lines;  ///< weak lines, frame G
  std::vector<PlannedFloe> floes;
};

/// The variation of floe properties by the scene's <vary>. Throws InputError naming the line where the ice would be as
/// heavy as the water that it floats in.
field::FloeVariation floe_variation(const scene::Scene& scene);

}  // namespace nilas::sim
