#pragma once
/// Overlap relaxation of convex floes in the plane, after van den Berg's IceFieldCreator: the overlaps of a pass are
/// resolved together by sequential impulses on bodies of unit density, which then move; velocities are discarded.
///
/// Each pass takes one step of the linearised problem: with gap g_i and unit normal n_i (from a to b) of touching
/// point i, find the displacements d = M^-1 H r of least kinetic norm with
///   g_i + n_i . (d_b - d_a) >= wanted gap,  r_i >= 0,
/// by projected Gauss-Seidel. Rotation is linearised, so several passes are needed.
#include <vector>

#include "core/field/spec/loose_floe.h"

namespace nilas::field {

struct RelaxationSettings {
  double gap = 0;    ///< required gap between all outlines [m]
  double reach = 0;  ///< outlines with gaps below gap + reach take part in a pass [m]
  int sweeps = 15;   ///< sweeps of sequential impulses per pass
};

class Relaxation {
 public:
  /// Moves `floes` in place; both references must outlive this object.
  Relaxation(std::vector<LooseFloe>& floes, const FieldBounds& bounds, const RelaxationSettings& settings);

  /// Does one pass with every floe scaled by `scale` about its centroid. Returns the largest lack (required minus
  /// present gap) [m]. Moves nothing when it is at most `accepted`.
  double pass(double scale, double accepted);
  /// Must be called when floes were moved or reshaped from outside.
  void restart() { pairs_valid_ = false; }

 private:
  struct Pair {
    int a, b;      ///< b < 0: obstacle -b - 1
    int edge = 0;  ///< edge of the last separating axis
    bool of_first = true;
  };
  struct Contact {
    int a, b;             ///< b < 0: fixed
    Vec2 normal;          ///< unit normal from a to b
    double arm_a, arm_b;  ///< r x n about the centres [m]
    double lack;          ///< required minus present gap [m]
    double response;      ///< impulse per opening, at unit density
    double impulse;       ///< r_i
  };

  void find_pairs(double scale);
  bool pairs_hold(double scale) const;
  void find_contacts();
  void add_wall_contacts(int a);
  void add_contact(int a, int b, const Vec2& normal, const Vec2& point, double gap);
  void sweep();
  void apply(int floe, const Vec2& normal, double arm, double impulse);
  void move();

  std::vector<LooseFloe>& floes_;
  const FieldBounds& bounds_;
  RelaxationSettings settings_;
  std::vector<ConvexOutline> outlines_;
  std::vector<Pair> pairs_;
  std::vector<Contact> contacts_;
  std::vector<Vec3> displacements_;  ///< x, y and rotation of each floe in this pass
  std::vector<double> travelled_;    ///< upper bound of the path of each floe's rim since the pairs were found [m]
  bool pairs_valid_ = false;
  double pair_scale_ = 0;
};

}  // namespace nilas::field
