#pragma once
/// The linear systems of Newton's method on one island, in units of sqrt(J) where every contact's inverse mass is
/// about 1.
///
///   e_a = 1/sqrt(d_a),  r = e r',  u' = e u = W' r' + q',  W' = e (W + C) e,  q' = e q,
///   d_a = trace(W_aa + C_a)/3,  C the diagonal of compliances
///   F(r', u') = 0 where the law holds (law_slopes.h), with U = dF/du', R = dF/dr'
///   (U (W' + a I) + R) dr' = -F        a: proximal weight
///
/// How W' acts and how a system is solved is left to the two forms: between contacts (delassus_system.h) and on the
/// bodies (bodies/body_system.h).
#include <vector>

#include "contact/problem/contact_coefficients.h"
#include "contact/solvers/shared/law_slopes.h"
#include "core/base/parallel.h"

namespace nilas::solvers {

class NewtonSystem {
 public:
  virtual ~NewtonSystem() = default;

  int num_contacts() const { return static_cast<int>(scale_.size()); }
  VecX scaled(const VecX& r) const;           ///< r' of r
  VecX impulses(const VecX& scaled_r) const;  ///< r of r'
  VecX velocities(const VecX& r) const { return product(r) + q_; }

  /// W' r'
  virtual VecX product(const VecX& r) const = 0;
  /// Newton's step from the last place linearised. False when the matrix is singular.
  virtual bool step(double weight, const VecX& r, VecX& dr) = 0;
  /// Largest residual of any contact as the solve judges it [m/s]; `r`: scaled.
  virtual double residual(const VecX& r) const { return law_map(r); }

  /// Sets the place where the map is linearised; `u`: velocities, a proximal term included. Returns |F|.
  double linearise(const VecX& r, const VecX& u);
  /// |F| at another place.
  double map_size(const VecX& r, const VecX& u) const;

 protected:
  /// `d`: d_a. `judged`: the inverse masses by which `measure` turns residuals into velocities, without compliance.
  /// `q`: q of the problem, not scaled. `order_free`: |F| is summed so that the order does not matter. `threads`: of
  /// the loops over contacts; the bits do not depend on them.
  NewtonSystem(const contact::ContactCoefficients& law, const std::vector<double>& d, std::vector<double> judged,
               const VecX& q, bool order_free, int threads = 1);

  double law_map(const VecX& r) const;
  double scale(int a) const { return scale_[a]; }  ///< e_a
  const std::vector<LawSlopes>& slopes() const { return slopes_; }
  bool is_order_free() const { return order_free_; }
  /// Calls body(a) for all contacts.
  template <class Body>
  void for_contacts(const Body& body) const {
    parallel_chunks(num_contacts(), k_chunk, threads_, [&](std::ptrdiff_t, std::ptrdiff_t first, std::ptrdiff_t last) {
      for (int a = static_cast<int>(first); a < static_cast<int>(last); ++a) body(a);
    });
  }

 private:
  LawSlopes slopes_at(int a, const VecX& r, const VecX& u) const;
  double length(const std::vector<double>& squares) const;

  const contact::ContactCoefficients& law_;
  bool order_free_;
  int threads_;
  std::vector<double> scale_, judged_;
  VecX q_;
  std::vector<double> cap_;
  std::vector<LawSlopes> slopes_;
};

}  // namespace nilas::solvers
