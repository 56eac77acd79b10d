#pragma once
/// Crushing of breakable floes by the vessel and by bodies: contact points whose force the ice's strength limits, in
/// place of those that keep rigid bodies apart. docs/theory/fracture-crushing.md
#include <cstdint>
#include <map>
#include <optional>
#include <set>
#include <utility>
#include <vector>

#include "contact/detect/broad/contact_point.h"
#include "contact/step_motion.h"
#include "core/base/log.h"
#include "core/base/state.h"
#include "core/bodies/bodies.h"
#include "core/bodies/ice_properties.h"
#include "fracture/crush/crushed_depth.h"
#include "fracture/crush/crushing_law.h"
#include "fracture/model/crushing_surface.h"
#include "fracture/model/floe_pieces.h"

namespace nilas {

struct CrushingSettings {
  CrushingLaw law;
  bool between_floes = false;          ///< floes crush each other, too
  std::optional<double> clear_volume;  ///< crushed ice is cut out of a floe from this volume on [m^3]
};

class Crushing {
 public:
  /// Learns the surfaces of the vessel and of the bodies with flat faces; cylinders crush as their faceted surface,
  /// spheres and planes stay rigid. `ice` must outlive this.
  Crushing(const CrushingSettings& settings, const Bodies& bodies, const IceProperties& ice);

  /// Counts the ice whose crushing took the work of the crush points' normal forces in this part of a step: work over
  /// pressure is its volume.
  void note_crushed(const Bodies& bodies, const StepMotion& motion);
  /// After bodies came or went: finds its hulls again. In pieces hulls have been as deep as in the floe that broke.
  void follow(const Bodies& bodies, const std::vector<NewPiece>& pieces);

  /// Whether the contact of two bodies is one of crushing: a breakable floe and the vessel or a body, or, where the
  /// scene says so, two breakable floes.
  bool crushes(int a, int b) const;

  /// The points of all such pairs at the present poses, for a step of length h whose motion after the impulses takes
  /// `ahead` [s]. Each face of a hull inside ice carries its pressure times its area: at most so much while it closes,
  /// any less at rest, nothing while it leaves. With an implicit law a point at its centroid adds what the area
  /// grows by: compliant, u_N + c r_N >= 0 with c = c_0 / (dF h), dF being what the force grows by until the step's end
  /// with the present velocities and c_0 the closing speed there; its force is at most dF. Of a face that comes into
  /// the ice within the step the way until then is a gap, and c_0 the closing speed less what that takes. A face that
  /// has backed off in ice it crushed has that as its gap. Remembers how deep the faces are: further calls at the same
  /// poses remember the same, whatever velocities, h and `ahead`. `near`: pairs of bodies that crush and may touch
  /// within the step, each once, the first before the second. Of two floes the one with the smaller area in the other
  /// when they first touch has the faces that count, for as long as they do; by Gauss' theorem force and moment of an
  /// even pressure are those of the other's faces too.
  std::vector<ContactPoint> points(const Bodies& bodies, const std::vector<std::pair<int, int>>& near, double h,
                                   double ahead);

  /// Floes of which hulls have more than the scene's clear_volume within them through the whole thickness, in the order
  /// of their ids, with the cut that takes it out. A strip along the hulls' surfaces stays, so that their faces stand
  /// in ice as before. None while a hull stands in the midst of its floe, which `warnings` are told.
  std::vector<FloeBreak> floes_to_clear(const Bodies& bodies, WarningCounts& warnings) const;

  /// How deep a corner of a breakable floe stands inside the vessel or a body that crushes it, at the present poses:
  /// the shortest way out through an outer face of the convex part that it is in. 0 where none is inside [m].
  double deepest_overlap(const Bodies& bodies) const;

  /// What points() hands from one search to the next: whose faces count, and how deep faces stood in the ice.
  struct Memory {
    std::map<std::pair<std::int64_t, std::int64_t>, char> faces_of_first;
    CrushedDepth depth;
  };
  Memory memory() const { return {faces_of_first_, depth_}; }
  /// Back to what it was before a search at poses that are taken back.
  void set_memory(const Memory& memory) {
    faces_of_first_ = memory.faces_of_first;
    depth_ = memory.depth;
  }

  /// Of the ice that was crushed since the start [kg].
  double crushed_mass() const { return crushed_mass_; }

  void save(StateWriter out) const;
  /// Throws InputError when the state is one of other bodies.
  void restore(const StateReader& in);

 private:
  struct FaceLoad;
  struct Pair;

  void learn(const Bodies& bodies, int body);
  bool is_hull(int body) const { return is_hull_[body] != 0; }
  const CrushingSurface& hull_of(int body) const;
  static bool balls_meet(const Bodies& bodies, int a, int b, double ahead);
  const CrushingSurface& floe_surface(const Bodies& bodies, int floe);
  static bool first_counts(const Pair& of_first, const Pair& of_second);
  void add_floes(const Bodies& bodies, int a, int b, double h, double ahead, std::vector<ContactPoint>& points);
  static bool may_meet(const Bodies& bodies, const CrushingSurface& hull, int floe, double ahead);
  Pair pair_of(const Bodies& bodies, const CrushingSurface& hull, int floe, double h, double ahead) const;
  void add_pair(const Pair& pair, std::vector<ContactPoint>& points);
  std::vector<FaceLoad> loads_of(const Pair& pair) const;
  static void leave_net_growth(std::vector<FaceLoad>& loads, std::size_t first);
  void add_face(const Pair& pair, const FaceLoad& load, std::vector<ContactPoint>& points);
  double pressure(const Pair& pair, const FaceInIce& face, const Placement& hull_in_floe, double total) const;
  CrushedIce crushed_through(const Bodies& bodies, std::int64_t floe) const;

  CrushingLaw law_;
  const IceProperties& ice_;
  std::vector<CrushingSurface> hulls_;
  std::vector<char> is_hull_;  ///< per body
  using Ids = std::pair<std::int64_t, std::int64_t>;
  bool between_floes_ = false;
  std::optional<double> clear_volume_;                       ///< [m^3]
  std::map<std::int64_t, CrushingSurface> floes_;            ///< by id: those that came near another
  std::map<Ids, char> faces_of_first_, new_faces_of_first_;  ///< of floes that touch: whose faces count
  CrushedDepth depth_;
  std::set<Ids> near_hulls_;  ///< hulls and floes that may have met at the last points(), where ice is cut out
  double crushed_mass_ = 0;   ///< [kg]
};

}  // namespace nilas
