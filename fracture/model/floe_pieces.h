#pragma once
/// The pieces that replace floes that break. docs/theory/fracture-breaking.md
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

namespace nilas::fracture {

/// A floe that breaks, with its failure modes, the largest ratio first.
struct FloeBreak {
  std::int64_t floe = 0;  ///< id
  std::vector<Failure> ways;
};

class FloePieces {
 public:
  explicit FloePieces(const PieceLimits& limits) : limits_(limits) {}

  /// Replaces the floe by pieces, by the first failure mode that cuts it. The pieces come after all other bodies, move
  /// as the floe did, and have its strengths. They are also appended to `pieces`. Of a fixed floe the largest piece
  /// stays fixed. So do others that have more old edge than cracks around them and a larger area than all wedges,
  /// unless the floe splits. The rest is free. Returns the event without time and energy, which the caller knows. It
  /// has no pieces and no brash where no failure mode cuts the floe, and `warnings` says so.
  FractureEvent put(const FloeBreak& broken, bodies::Bodies& bodies, bodies::IceProperties& ice,
                    WarningCounts& warnings, std::vector<NewPiece>& pieces);

  double brash_mass() const { return brash_mass_; }        ///< Mass of brash since the start [kg].
  double extruded_mass() const { return extruded_mass_; }  ///< Mass of crushed ice cut out since the start [kg].

  /// Writes the pieces of earlier breaks and their origins. Call it between two steps.
  void save(const bodies::Bodies& bodies, StateWriter out) const;
  /// Breaks the scene's floes as they were broken when saved. The bodies have the same ids; their poses are not set.
  /// Throws InputError when the state belongs to another scene.
  void restore(const StateReader& in, bodies::Bodies& bodies, bodies::IceProperties& ice);

 private:
  /// The properties of a broken floe of the scene that its pieces inherit.
  struct Intact {
    std::string name, material;
    bodies::FloeStrength flexural, compressive, toughness;
    std::vector<bodies::WeakLine> weak_lines;
  };
  /// The frame of a piece in that of the scene's floe from which it was cut.
  struct Origin {
    std::int64_t floe = 0;      ///< Id of the floe.
    Vec2 place = Vec2::Zero();  ///< Place of the piece's centre [m].
  };

  static std::vector<char> fixed_pieces(const FloeCut& cut, const Failure& way);
  Origin origin_of(std::int64_t id) const;
  void add_piece(const FloePiece& piece, std::size_t floe, bool fixed, bodies::Bodies& bodies,
                 bodies::IceProperties& ice);
  void add_body(bodies::BodySpec spec, const Origin& origin, bodies::Bodies& bodies, bodies::IceProperties& ice);
  void keep_intact(std::size_t b, const bodies::Bodies& bodies, const bodies::IceProperties& ice);
  void take_out(std::size_t b, bodies::Bodies& bodies, bodies::IceProperties& ice);
  void take_broken_out(const StateReader& in, bodies::Bodies& bodies, bodies::IceProperties& ice);
  void put_saved_pieces(const StateReader& in, bodies::Bodies& bodies, bodies::IceProperties& ice);

  PieceLimits limits_;
  std::map<std::int64_t, Origin> origins_;  ///< Origins of the present pieces, by id.
  std::map<std::int64_t, Intact> intact_;   ///< Broken floes of the scene, by id.
  double brash_mass_ = 0, extruded_mass_ = 0;
};

}  // namespace nilas::fracture
