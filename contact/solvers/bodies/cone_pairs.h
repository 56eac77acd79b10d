#pragma once
/// Arithmetic on one pair (x, y) of points per contact, each inside the cone {x_0 >= |x_T|}: its scaling by Nesterov
/// and Todd, the steps of an interior-point method in it, and the way to the boundary. The formulas are those of
/// second_order_cone.h, with T = b (2 p p^T - J), T^-1 = (2 Jp Jp^T - J)/b, Q = T^2, l = T y = T^-1 x. They are written
/// for many contacts at once, so that the loops fill registers, and for a range of them, so that threads share them.
///
/// A contact without friction is the half line x_0 >= 0, carried as x_T = y_T = 0: all formulas then keep it.
#include "contact/solvers/bodies/body_island.h"
#include "contact/solvers/bodies/node_cholesky.h"

namespace nilas::solvers {

struct ConeScaling {
  ContactVectors p, scaled;  ///< p and l
  std::vector<double> b;
  ContactMatrices squared;  ///< Q

  explicit ConeScaling(std::size_t num_contacts)
      : p(num_contacts), scaled(num_contacts), b(num_contacts), squared(num_contacts) {}
};

/// Contacts from `first` on and before `last`.
struct ContactRange {
  std::size_t first = 0, last = 0;
};

/// Returns whether all points lie inside their cones; where one does not, the scaling is not usable.
bool scale(const ContactVectors& x, const ContactVectors& y, ConeScaling& scaling, ContactRange range);

/// out = T (g + T a)
void from_dual(const ConeScaling& scaling, const ContactVectors& g, const ContactVectors& a, ContactVectors& out,
               ContactRange range);
/// out = T (g - T a)
void to_primal(const ConeScaling& scaling, const ContactVectors& g, const ContactVectors& a, ContactVectors& out,
               ContactRange range);
/// g = l \ (target e - l o l - (T^-1 dx) o (T dy)): the right side that aims at x o y = target e to second order.
void corrected(const ConeScaling& scaling, const ContactVectors& dx, const ContactVectors& dy, double target,
               ContactVectors& g, ContactRange range);

/// Largest t <= 1 with x + t dx inside all cones.
double longest_step(const ContactVectors& x, const ContactVectors& dx, ContactRange range);
/// sum of (x + t dx) . (y + t dy) over all contacts, in their order
double gap_after(const ContactVectors& x, const ContactVectors& y, const ContactVectors& dx, const ContactVectors& dy,
                 double t);
/// x += t dx
void move(const ContactVectors& dx, double t, ContactVectors& x, ContactRange range);

}  // namespace nilas::solvers
