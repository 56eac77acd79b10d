#pragma once
/// Interior point on the bodies of one island, with De Saxce's shift taken from the iterate before, with a part of its
/// slope, or held until the convex law that it makes is nearly solved.
///
/// Per contact, in cones of slope one (x = S^-1 r, S = diag(1, mu, mu), or diag(1/mu, 1, 1) for mu > 1), with a slack s
/// and a multiplier m of the limit k of x_0 where there is one, and the compliance c:
///   y = S (J z + w + c r_N n + mu |u_T| n) + m e,   z = z_free + sum J^T S x,   x_0 + s = k
///   x o y = t e,   s m = t,   t -> 0,   x and y in {x_0 >= |x_T|},   s, m >= 0
/// Predictor and corrector of Mehrotra with the scaling T of Nesterov and Todd (cone_pairs.h). mu |u_T| n is a constant
/// of each step: the law is exact at the end, and the systems are symmetric. Eliminating dx and dy leaves
///   (1 + sum J^T S Q' S J) dz = sum J^T S Q' (T^-1 g + r_y - l n) - r_z,   Q' = (T^-2 + C)^-1,
///   C = diag(S_0^2 c + m/s, 0, 0)
/// with r_y what y is off, g the right side in the scaled point, l = (right side of s m)/s, and 6 x 6 blocks of the
/// bodies (node_cholesky.h).
///
/// One factorisation per iteration and two solves. A jam of 966 floes and friction 0.15 takes some 12 iterations to
/// 1e-4 m/s and 20 to 1e-5 m/s, with or without a guess. u and z move with the steps, so that r_y keeps the digits of
/// numbers near the end of a cone; r_z = z - z_free - sum J^T S x, what rounding leaves, enters the next step, and
/// residuals are those of the velocities that the impulses give.
/// Above a friction of about 0.2 a jam needs the slope of the shift in its steps, and with it the LU factors of
/// node_lu.h. For a loose tolerance a run may begin without it: half of the steps of such jams never need it. Where
/// masses and limits differ by many decades, steps of either kind may become too short long before the end. A shift
/// that is held leaves each round a convex law, whose steps stay long. The rounds converge where the map from shift to
/// shift contracts. In a sheet that crushes at a hull it halves the error, and seven rounds of 15 iterations find 1e-3
/// m/s. Near 1e-7 of the speeds rounding ends progress, since a contact between two states has the root of its gap for
/// a residual: Newton goes on from there (body_system.h), and finds its active set in few steps, because an interior
/// point is centred among redundant contacts.
///
/// Sources: De Saxce, Feng 1998; Nesterov, Todd 1998; Mehrotra 1992; Acary, Cadoux, Lemarechal, Malick
/// 2011. Laws: coulomb, ccp and frictionless.
#include <numeric>
#include <optional>
#include <span>

#include "contact/solvers/bodies/cone_pairs.h"
#include "contact/solvers/bodies/node_lu.h"
#include "contact/solvers/shared/budget.h"
#include "core/base/parallel.h"

namespace nilas::solvers {

/// How a step takes the shift mu |u_T|: as it is, with a share of its slope, or as the round before left it.
enum class Shift { lagged, differentiated, held };

/// The settings of a run.
struct InteriorSettings {
  Shift shift = Shift::lagged;
  double slope_share = 0;   ///< of the slope of the shift that enters a step, for a differentiated shift
  double inside = 0.25;     ///< the first iterate lies inside the cones by this share of the start's residual
  int patience = 8;         ///< iterations without the residual halving that end the run, or a round of a held shift
  int lagged_patience = 0;  ///< of a lagged shift, after which the run goes on with the share of the slope; 0: none
  bool ends_when_stuck = false;  ///< the run ends as soon as its steps have become too short to lead anywhere
};

class InteriorOnBodies {
 public:
  /// All must outlive this.
  InteriorOnBodies(const contact::PreparedProblem& island, const BodyIsland& bodies, const NodePlan& plan);

  struct Outcome {
    VecX r;  ///< the impulses of the least residual seen
    double law_map_m_s = 0;
    int iterations = 0;
    std::vector<double> history;  ///< the residual after each iteration, or for each the one that its round left [m/s]
  };
  /// Runs from impulses (any, moved inside the cones first) until the residual is at most `tolerance` [m/s], it has not
  /// halved for some iterations, rounding ends it, or the budget is used up.
  Outcome run(const VecX& start, double tolerance, const Budget& budget, const InteriorSettings& settings);
  /// Goes on from where the last run ended.
  Outcome go_on(double tolerance, const Budget& budget);

 private:
  struct Direction {
    ContactVectors x, y, u;  ///< u without what compliance adds
    NodeVector z;
    std::vector<double> slack, multiplier;  ///< of capped_
    Direction(std::size_t contacts, std::size_t limits, std::size_t nodes)
        : x(contacts), y(contacts), u(contacts), z(nodes), slack(limits), multiplier(limits) {}
  };
  Outcome iterate(double tolerance, const Budget& budget);
  Outcome go_round(double tolerance, const Budget& budget);
  double hold(const VecX& r);
  void place(const VecX& r);
  double begin(const VecX& start);
  void take_slope();
  void find_motion(NodeVector& z, ContactVectors& u);
  double find_map();
  void find_off();
  VecX impulses() const;
  bool factor();
  void fill_symmetric(ContactRange range);
  void fill_full(ContactRange range);
  void find_direction(Direction& d);
  void follow_motion(ContactRange range, Direction& d) const;
  double longest(const Direction& d) const;
  double gap(const Direction& d, double t) const;
  void aim(const Direction& predictor, double target);
  void move_by(const Direction& d, double t);
  double stiffness(std::size_t c) const;
  std::span<const int> soft_in(ContactRange range) const;
  struct Yield {
    Vec3 dx;
    double dy_n;
  };
  Yield yielding(std::size_t c, const Vec3& a, double sign) const;

  /// Calls body(range) for chunks of all contacts.
  template <class Body>
  void for_contacts(const Body& body) const {
    parallel_chunks(static_cast<std::ptrdiff_t>(count_), k_chunk, bodies_.threads(),
                    [&](std::ptrdiff_t, std::ptrdiff_t first, std::ptrdiff_t last) {
                      body(ContactRange{static_cast<std::size_t>(first), static_cast<std::size_t>(last)});
                    });
  }
  /// Returns what is left of `start` and of value(range) of all chunks by `choose`, whatever their order.
  template <class T, class Value, class Choose>
  T reduce_contacts(T start, const Value& value, const Choose& choose) const {
    std::vector<T> of_chunk((count_ + k_chunk - 1) / k_chunk);
    for_contacts([&](ContactRange range) { of_chunk[range.first / k_chunk] = value(range); });
    return std::accumulate(of_chunk.begin(), of_chunk.end(), start, choose);
  }

  const contact::PreparedProblem& island_;
  const contact::ContactProblem& problem_;
  const BodyIsland& bodies_;
  const NodePlan& plan_;
  NodeCholesky cholesky_;
  std::optional<NodeLu> lu_;  ///< made when first needed
  InteriorSettings settings_;
  std::vector<double> along_1_, along_2_;         ///< slope of the shift, S_0 mu u_T/|u_T|
  std::vector<double> held_;                      ///< the shift that is held [m/s], empty for the other kinds
  std::vector<double> change_;                    ///< what the last round asked to change of it [m/s]
  VecX last_;                                     ///< impulses of the last round
  std::size_t count_;                             ///< contacts
  std::vector<double> friction_;                  ///< mu, 0 for the law frictionless
  std::vector<double> slope_n_, slope_t_;         ///< S
  std::vector<int> capped_;                       ///< contacts with a limit
  std::vector<int> limit_of_;                     ///< place of each contact in capped_, -1: no limit
  std::vector<int> soft_;                         ///< contacts with a limit or compliance
  std::vector<double> cap_, slack_, multiplier_;  ///< of capped_
  ContactVectors x_, y_, u_, r_y_, g_, work_, other_;
  std::vector<double> line_;  ///< right side of s m, of capped_
  ConeScaling scaling_;
  ContactMatrices g_matrix_;
  std::vector<Mat3> g_full_;  ///< the same where it is not symmetric
  NodeVector z_, r_z_;
};

}  // namespace nilas::solvers
