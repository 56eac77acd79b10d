#pragma once
/// Pieces in the place of floes that break. docs/theory/fracture-breaking.md
#include <cstdint>
#include <map>
#include <string>
#include <vector>

#include "core/base/log.h"
#include "core/base/state.h"
#include "core/bodies/bodies.h"
#include "core/bodies/ice_properties.h"
#include "fracture/cut/cut_floe.h"
#include "fracture/failure.h"
#include "fracture/model/fracture_event.h"

namespace nilas {

/// A floe that breaks, and the ways in which it may, the likeliest first.
struct FloeBreak {
  std::int64_t floe = 0;  ///< id
  std::vector<Failure> ways;
};

class FloePieces {
 public:
  explicit FloePieces(const PieceLimits& limits) : limits_(limits) {}

  /// Puts pieces in the floe's place, in the first way that cuts it: after all other bodies, moving as it did, with its
  /// strengths. Of a fixed floe the largest piece stays fixed, and others that have more of its old edge than of cracks
  /// around them and a larger area than all wedges; the rest is free. Appends them to `pieces`. Without energy and time
  /// in it, which the caller knows; no pieces and no brash where no way cuts it, which `warnings` are told.
  FractureEvent put(const FloeBreak& broken, Bodies& bodies, IceProperties& ice, WarningCounts& warnings,
                    std::vector<NewPiece>& pieces);

  double brash_mass() const { return brash_mass_; }        ///< since the start [kg]
  double extruded_mass() const { return extruded_mass_; }  ///< of crushed ice that was cut out, since the start [kg]

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

  static std::vector<char> fixed_pieces(const FloeCut& cut, const Failure& way);
  Origin origin_of(std::int64_t id) const;
  void add_piece(const FloePiece& piece, std::size_t floe, bool fixed, Bodies& bodies, IceProperties& ice);
  void add_body(BodySpec spec, const Origin& origin, Bodies& bodies, IceProperties& ice);
  void keep_intact(std::size_t b, const Bodies& bodies, const IceProperties& ice);
  void take_out(std::size_t b, Bodies& bodies, IceProperties& ice);
  void take_broken_out(const StateReader& in, Bodies& bodies, IceProperties& ice);
  void put_saved_pieces(const StateReader& in, Bodies& bodies, IceProperties& ice);

  PieceLimits limits_;
  std::map<std::int64_t, Origin> origins_;  ///< of pieces that are there
  std::map<std::int64_t, Intact> intact_;   ///< by id
  double brash_mass_ = 0, extruded_mass_ = 0;
};

}  // namespace nilas
