#pragma once
/// Contact solvers that a scene may ask for: their names, and what each can solve. contact/registry.h builds them.
#include <algorithm>
#include <optional>
#include <span>
#include <string>

#include "core/choices/law.h"

namespace nilas {

enum class SolverName {
  pgs,
  nsgs,
  eg,
  eg_order_free,
  apgd,
  enumerate,
  admm,
  ipm,
  newton,
  newton_order_free,
  automatic
};

/// What is known of a solver before it is built.
struct SolverFacts {
  ChoiceText text = {};  ///< its sentence says what the solver is, what an iteration costs and when to use it
  std::span<const Law> laws = {};
  bool moments = false;  ///< takes rolling and spinning friction, with the laws coulomb, pyramid and frictionless
  /// The bits depend neither on the order of contacts and bodies nor, but for the sign, on a mirror.
  bool order_free = false;
  double relative_time = 1;  ///< rough ratio of a solve's time to that of nsgs in fields of floes; for plans of runs

  constexpr bool takes(Law law) const { return std::find(laws.begin(), laws.end(), law) != laws.end(); }
};

/// The one entry of each solver in the list of solvers.
constexpr SolverFacts facts_of(SolverName value) {
  switch (value) {
    case SolverName::pgs:
      return {
          .text = {"pgs",
                   "Projected Gauss-Seidel on single rows, about 25 ns per contact and sweep; for loose packings and "
                   "comparison with game-engine based simulators, slow for stacks and heavy-on-light contact."},
          .laws = k_row_laws,
          .relative_time = 0.6};
    case SolverName::nsgs:
      return {
          .text =
              {"nsgs",
               "Block Gauss-Seidel with the exact solution of each contact, 1.3 to 1.7 times the cost of a sweep of "
               "pgs; for loose fields and as a first stage, slow for stacks and heavy-on-light contact."},
          .laws = k_all_laws,
          .moments = true,
          .relative_time = 1};
    case SolverName::eg:
      return {
          .text =
              {"eg",
               "Self-adaptive extragradient, two products with W per iteration, O(contacts); for sliding fields, slow "
               "for stacks and redundant contacts."},
          .laws = k_convex_laws,
          .relative_time = 10};
    case SolverName::eg_order_free:
      return {
          .text =
              {"eg-order-free",
               "eg with exact cuts of every sum: mirror images, permuted bodies and contacts and any number of threads "
               "give the same bits, at about twice the cost of eg; for sliding fields, newton-order-free elsewhere."},
          .laws = k_convex_laws,
          .order_free = true,
          .relative_time = 20};
    case SolverName::apgd:
      return {.text = {"apgd",
                       "Accelerated projected gradient with De Saxce's outer loop, one product with W per iteration, "
                       "O(contacts); 100 to 20000 iterations; for mass ratios and fields where 1e-8 m/s is enough, may "
                       "stall at 1e-5 m/s on tall stacks."},
              .laws = k_convex_laws,
              .relative_time = 5};
    case SolverName::enumerate:
      return {
          .text = {"enumerate",
                   "Tries every combination of open, sticking and slipping of up to 8 contacts, 3^n dense systems; an "
                   "oracle to check others by."},
          .laws = k_cone_laws,
          .relative_time = 1};
    case SolverName::admm:
      return {
          .text =
              {"admm",
               "Alternating directions with De Saxce's shift; few factorisations, two triangular solves per iteration, "
               "30 to 1000 iterations; for sticking contact of any masses, stalls where slipping contacts are "
               "redundant."},
          .laws = k_cone_laws,
          .relative_time = 8};
    case SolverName::ipm:
      return {
          .text =
              {"ipm",
               "Interior point with a De Saxce outer loop and a Newton finish; 10 to 200 factorisations whatever the "
               "masses; for extreme mass ratios, stacks and redundant contacts, costly for large loose fields."},
          .laws = k_cone_laws,
          .relative_time = 25};
    case SolverName::newton:
      return {
          .text = {"newton",
                   "Proximal semismooth Newton, one sparse factorisation of the loaded contacts per iteration, 5 to 30 "
                   "iterations; the reference: for accuracy, stacks, jams, redundant contacts and mass ratios."},
          .laws = k_all_laws,
          .relative_time = 5};
    case SolverName::newton_order_free:
      return {
          .text =
              {"newton-order-free",
               "newton whose steps are solved to many more digits than are kept: mirror images, permuted bodies and "
               "contacts and any number of threads give the same bits, at one to three times the cost of newton; the "
               "first choice for studies of symmetry."},
          .laws = k_convex_laws,
          .order_free = true,
          .relative_time = 15};
    case SolverName::automatic:
      return {
          .text = {"auto",
                   "Climbs from nsgs over admm and newton to ipm until the tolerance holds, island by island, and says "
                   "what it used; the default for every problem."},
          .laws = k_all_laws,
          .moments = true,
          .relative_time = 1.2};
  }
  return {};
}

constexpr ChoiceText choice_text(SolverName value) { return facts_of(value).text; }

/// Why a solver cannot solve contacts of this law, with the laws that it takes and the solvers that take this one;
/// nothing where it can.
std::optional<std::string> law_problem(SolverName solver, Law law);
/// The same of rolling and spinning friction with this law.
std::optional<std::string> moment_problem(SolverName solver, Law law);

}  // namespace nilas
