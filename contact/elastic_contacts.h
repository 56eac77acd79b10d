#pragma once
/// Contacts that are springs: their rows in the contact problem, their state from step to step, their energy.
///
/// A spring is compressed by the overlap of the bodies beyond `rest`, and stretched along the contact plane by what
/// they move past each other without slip. Over a step of length h, with dashpots of retardation time T,
///   r_N/h = k_N (compression + T * its rate),   r_T/h = -k_T (stretch + T * its rate),
/// all at the step's end. Coulomb's law relates r and the velocity of slip, so the rows of the problem are
///   u_N + c_N r_N - compression/(h + T),   u_T + c_T r_T + stretch/(h + T),   c = 1/(k h (h + T)).
/// Theory: docs/theory/contact.md.
#include <cstdint>
#include <vector>

#include "contact/detect/broad/contact_point.h"
#include "contact/law/friction.h"
#include "core/base/math.h"
#include "core/base/state.h"
#include "core/bodies/bodies.h"

namespace nilas::contact {

/// The spring of one contact point at the start of a step.
struct Spring {
  double normal = 0;            ///< stiffness; 0: the point is rigid [N/m]
  double tangential = 0;        ///< [N/m]
  double retardation = 0;       ///< dashpot over spring, in both directions [s]
  double rest = 0;              ///< overlap at which the spring is relaxed [m]
  Vec3 stretch = Vec3::Zero();  ///< of B against A in the contact plane, in G [m]

  bool exists() const { return normal > 0; }
  /// Compression at a gap; below 0: minus the distance to the contact [m].
  double compression(double gap) const { return -(gap + rest); }
};

/// What a spring changes in the rows of its contact.
struct SpringRow {
  double compliance = 0, tangential_compliance = 0;  ///< [m/(s N s)]
  Vec3 bias = Vec3::Zero();                          ///< added to u, in the contact frame [m/s]
};
/// `C`: the contact frame. A gap closes at first without resistance.
SpringRow spring_row(const Spring& spring, double gap, const Mat3& C, double h);

/// A spring at the end of a step, and where the work of its contact went.
struct SpringStep {
  bool exists = false;
  Vec3 stretch = Vec3::Zero();  ///< in G [m]
  double stored = 0;            ///< energy of the spring [J]
  double damping = 0;           ///< loss in the dashpots, and what a contact that opens still held [J]
  double friction = 0;          ///< loss by slip [J]
};
/// `r`: impulse [N s], `u`: velocity of B against A [m/s], both in the contact frame; `bound`: largest |r_T| [N s];
/// `d`: trace(W_cc)/3 [1/kg]. A contact sticks where friction could take the slip that the solver left, as in the
/// natural map. Then its stretch follows the motion, so that what the tolerance leaves does not add up to creep. Where
/// it slips, the stretch is what r_T holds.
SpringStep spring_step(const Spring& spring, double gap, const Mat3& C, double h, const Vec3& r, const Vec3& u,
                       double bound, double d);

/// The springs of all points, found again by contact key.
class ElasticContacts {
 public:
  /// Returns one spring per point. Points of one patch, that is of one pair of parts, share its stiffness. A point that
  /// is new in a known patch takes over the patch's rest and mean stretch. In a new patch an overlap is at rest.
  /// `points`: sorted by bodies and parts. `edge`: per body Young's modulus times thickness of ice, 0 for rigid bodies
  /// [N/m]; a pair of two such bodies without a stiffness of its own is rigid.
  std::vector<Spring> springs(const bodies::Bodies& bodies, const std::vector<detect::ContactPoint>& points,
                              const FrictionPairs& friction, const std::vector<double>& edge) const;
  /// Keeps the state of a step that was taken; `bodies` at the pose where the contacts were found.
  void keep(const bodies::Bodies& bodies, const std::vector<detect::ContactPoint>& points,
            const std::vector<Spring>& springs, const std::vector<SpringStep>& steps);

  void save(StateWriter out) const;
  void restore(const StateReader& in);

 private:
  struct Kept {
    std::uint64_t key = 0, patch = 0;
    double rest = 0;
    Vec3 on_a = Vec3::Zero(), on_b = Vec3::Zero();  ///< the stretch in the frames of both bodies [m]
  };
  struct Patch {
    std::uint64_t name = 0;
    std::size_t kept = 0;  ///< place of one of its points
  };
  void list_patches();
  Vec3 mean_stretch(const bodies::Bodies& bodies, const detect::ContactPoint& point, std::size_t first,
                    std::size_t last) const;
  void recall(const bodies::Bodies& bodies, const detect::ContactPoint& point, Spring& spring) const;

  std::vector<Kept> sorted_;     ///< by key
  std::vector<Patch> by_patch_;  ///< by patch, then by key
};

}  // namespace nilas::contact
