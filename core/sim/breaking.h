#pragma once
/// Breaking of floes under what presses on them: loads of a step, ways to break, pieces in the floe's place.
/// docs/theory_fracture.md
#include <cstdint>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include "core/base/log.h"
#include "core/base/state.h"
#include "core/bodies/bodies.h"
#include "core/bodies/ice_properties.h"
#include "core/scene/scene.h"
#include "core/sim/step_motion.h"
#include "core/sim/step_record.h"
#include "fracture/cut_floe.h"
#include "fracture/failure.h"

namespace nilas {

class Breaking {
 public:
  /// Throws ContractError when the scene names no <fracture> or no <water>.
  explicit Breaking(const Scene& scene);

  /// Notes what the vessel and bodies (never floes or walls) press with on breakable floes in this part of a step.
  void note_loads(const Bodies& bodies, const IceProperties& ice, const StepMotion& motion);

  /// A floe that breaks, and the ways in which it may, the likeliest first.
  struct Break {
    std::int64_t floe = 0;  ///< id
    std::vector<Failure> ways;
  };
  /// Those that the loads noted since the last call break, their means taken over `step` [s], in the order of their
  /// ids. A floe loaded at several places breaks at the one that is worst.
  std::vector<Break> take_breaks(const Bodies& bodies, const IceProperties& ice, double step);

  /// Puts pieces in the floe's place, in the first way that cuts it: after all other bodies, moving as it did, with its
  /// strengths. Of a fixed floe the largest piece stays fixed, and others that have more of its old edge than of cracks
  /// around them and a larger area than all wedges; the rest is free. Without energy and time in it, which the caller
  /// knows; no pieces and no brash where no way cuts it, which `warnings` are told.
  FractureEvent put_pieces(const Break& broken, Bodies& bodies, IceProperties& ice, WarningCounts& warnings);

  double brash_mass() const { return brash_mass_; }  ///< since the start [kg]

  /// Where the pieces of earlier breaks come from; between two steps.
  void save(const Bodies& bodies, StateWriter out) const;
  /// Breaks the scene's floes as they were broken when saved: bodies with the same ids, at no pose in particular.
  /// Throws InputError when the state is one of another scene.
  void restore(const StateReader& in, Bodies& bodies, IceProperties& ice);

 private:
  /// Of a floe of the scene that broke: what its pieces inherit.
  struct Intact {
    std::string name, material;
    FloeStrength flexural, compressive, toughness;
    std::vector<WeakLine> weak_lines;
  };
  /// A piece's frame in that of the scene's floe that it was cut from.
  struct Origin {
    std::int64_t floe = 0;      ///< id
    Vec2 place = Vec2::Zero();  ///< of the piece's centre [m]
  };

  static IceAtContact ice_at(const Bodies& bodies, const IceProperties& ice, std::size_t b, const Vec2& x,
                             const LocalIce* around);
  static std::vector<char> fixed_pieces(const FloeCut& cut, const Failure& way);
  Origin origin_of(std::int64_t id) const;
  void add_piece(const FloePiece& piece, std::size_t floe, bool fixed, Bodies& bodies, IceProperties& ice);
  void add_body(BodySpec spec, const Origin& origin, Bodies& bodies, IceProperties& ice);
  void keep_intact(std::size_t b, const Bodies& bodies, const IceProperties& ice);
  void take_out(std::size_t b, Bodies& bodies, IceProperties& ice);
  void take_broken_out(const StateReader& in, Bodies& bodies, IceProperties& ice);
  void put_saved_pieces(const StateReader& in, Bodies& bodies, IceProperties& ice);

  FailureRules rules_;
  PieceLimits limits_;
  std::map<std::int64_t, std::vector<PointLoad>> loads_;  ///< by floe; forces as impulses [N s]
  std::map<std::int64_t, Origin> origins_;                ///< of pieces that are there
  std::map<std::int64_t, Intact> intact_;                 ///< by id
  double brash_mass_ = 0;
};

}  // namespace nilas
