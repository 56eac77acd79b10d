#pragma once
/// Crushing of breakable floes by the vessel and by bodies. The ice's strength limits the force of its contact points,
/// which replace those of rigid contact. docs/theory/fracture-crushing.md
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

namespace nilas::fracture {

struct CrushingSettings {
  CrushingLaw law;
  bool between_floes = false;          ///< Floes crush each other too.
  std::optional<double> clear_volume;  ///< Volume of crushed ice above which it is cut out [m^3].
};

class Crushing {
 public:
  /// Computes the surfaces of the vessel and of the bodies with flat faces. Cylinders crush with their facets. Contacts
  /// of spheres and planes stay rigid. `ice` must outlive this object.
  Crushing(const CrushingSettings& settings, const bodies::Bodies& bodies, const bodies::IceProperties& ice);

  /// Adds the mass of the ice that was crushed in this substep. Its volume is the work of the crush points' normal
  /// forces over the pressure.
  void note_crushed(const bodies::Bodies& bodies, const contact::StepMotion& motion);
  /// Updates the indices of the hulls after bodies came or went. Pieces inherit the crushed depth of the broken floe.
  void follow(const bodies::Bodies& bodies, const std::vector<NewPiece>& pieces);

  /// Whether the contact of two bodies is crushing. It is for a breakable floe and the vessel or a body, and with
  /// `between_floes` for two breakable floes.
  bool crushes(int a, int b) const;

  /// The contact points of pairs that crush, at the present poses, for a step of length h [s]. The motion after the
  /// impulses takes `ahead` [s]. `near` are the pairs of bodies that crush and may touch within the step, each once,
  /// the first body before the second.
  ///
  /// The points of a hull's face in ice together carry at most its pressure times its area. With an implicit law one
  /// more point at the face's centroid carries the growth: u_N + c r_N >= 0 with c = c_0 / (dF h), and a force of at
  /// most dF. dF is the growth of the force until the step's end with the present velocities, c_0 the closing speed of
  /// the centroid. Where a face touches ice only within the step, the distance until then is a gap, and c_0 is reduced
  /// by gap / h. A face that has backed off in ice that it crushed has that distance as its gap.
  ///
  /// Of two floes only the faces of one count, for as long as they touch: mostly the one with the smaller area in the
  /// other (docs/theory/fracture-crushing.md). By Gauss' theorem force and moment of an even pressure are the same for
  /// the faces of the other. The object remembers these choices and how deep the faces are. Further calls at the same
  /// poses remember the same, whatever the velocities, h and `ahead`.
  std::vector<detect::ContactPoint> points(const bodies::Bodies& bodies, const std::vector<std::pair<int, int>>& near,
                                           double h, double ahead);

  /// The floes of which hulls have crushed more than the scene's clear_volume through the whole thickness, in the order
  /// of their ids, with the cut that removes this ice. A smaller volume counts where its cut would part the floe. A
  /// strip along the hulls' surfaces stays, so that their faces remain in ice. A hull that is surrounded by its floe
  /// cuts nothing; where it has crushed more than clear_volume, `warnings` says so.
  std::vector<FloeBreak> floes_to_clear(const bodies::Bodies& bodies, WarningCounts& warnings) const;

  /// The largest depth [m] of a corner of a breakable floe inside the vessel or a body that crushes it, at the present
  /// poses. It is the least distance to an outer face of the convex part that the corner is in. 0 where none is inside.
  double deepest_overlap(const bodies::Bodies& bodies) const;

  /// The state that points() keeps from one call to the next: whose faces count, and how deep faces were in the ice.
  struct Memory {
    std::map<std::pair<std::int64_t, std::int64_t>, char> faces_of_first;
    CrushedDepth depth;
  };
  Memory memory() const { return {faces_of_first_, depth_}; }
  /// Restores the memory from before a call of points() at poses that the time step took back.
  void set_memory(const Memory& memory) {
    faces_of_first_ = memory.faces_of_first;
    depth_ = memory.depth;
  }

  /// The mass of the ice that was crushed since the start [kg].
  double crushed_mass() const { return crushed_mass_; }

  void save(StateWriter out) const;
  /// Throws InputError for an incomplete state.
  void restore(const StateReader& in);

 private:
  struct FaceLoad;
  struct Pair;

  void learn(const bodies::Bodies& bodies, int body);
  bool is_hull(int body) const { return is_hull_[body] != 0; }
  const CrushingSurface& hull_of(int body) const;
  static bool balls_meet(const bodies::Bodies& bodies, int a, int b, double ahead);
  const CrushingSurface& floe_surface(const bodies::Bodies& bodies, int floe);
  static bool first_counts(const Pair& of_first, const Pair& of_second);
  void add_floes(const bodies::Bodies& bodies, int a, int b, double h, double ahead,
                 std::vector<detect::ContactPoint>& points);
  static bool may_meet(const bodies::Bodies& bodies, const CrushingSurface& hull, int floe, double ahead);
  Pair pair_of(const bodies::Bodies& bodies, const CrushingSurface& hull, int floe, double h, double ahead) const;
  void add_pair(const Pair& pair, std::vector<detect::ContactPoint>& points);
  std::vector<FaceLoad> loads_of(const Pair& pair) const;
  static void leave_net_growth(std::vector<FaceLoad>& loads, std::size_t first);
  void add_face(const Pair& pair, const FaceLoad& load, std::vector<detect::ContactPoint>& points);
  double pressure(const Pair& pair, const FaceInIce& face, const Placement& hull_in_floe, double total) const;
  CrushedIce crushed_through(const bodies::Bodies& bodies, std::int64_t floe) const;

  CrushingLaw law_;
  const bodies::IceProperties& ice_;
  std::vector<CrushingSurface> hulls_;
  std::vector<char> is_hull_;  ///< A flag per body.
  using Ids = std::pair<std::int64_t, std::int64_t>;
  bool between_floes_ = false;
  std::optional<double> clear_volume_;                       ///< [m^3]
  std::map<std::int64_t, CrushingSurface> floes_;            ///< Surfaces by id of floes that came near another.
  std::map<Ids, char> faces_of_first_, new_faces_of_first_;  ///< Whose faces count, for floes that touch.
  CrushedDepth depth_;
  std::set<Ids> near_hulls_;  ///< Hulls and floes that may have met at the last points(); empty without clear_volume.
  double crushed_mass_ = 0;   ///< [kg]
};

}  // namespace nilas::fracture
