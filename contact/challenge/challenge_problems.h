#pragma once
/// Contact problems that are hard for solvers, at any size: heaps, columns, rafts of floes, stacks.
#include <cstdint>
#include <vector>

#include "contact/challenge/challenge_bodies.h"

namespace nilas::challenge {

/// Bodies of unlike mass and inertia thrown at each other and at the ground with random points and normals.
ContactProblem random_heap(std::uint64_t seed, int body_count, int contact_count, double mu);

/// Masses from the ground up, one frictionless contact between neighbours, falling for one step under g.
ContactProblem column(const std::vector<double>& masses, double h, double g);

/// side x side square floes of 1 m with two contact points per shared edge, moving at random; every row of floes ends
/// at a fixed wall. `closed`: share of the pairs that touch, the others have a gap that the step cannot close.
ContactProblem raft(int side, double mu, double closed, std::uint64_t seed);

/// Unit cubes of the given masses from the ground up, four contacts per face, falling for one step. W has two thirds
/// of full rank; nothing moves in the exact solution.
ContactProblem box_stack(const std::vector<double>& masses, double mu, double h = 0.01, double g = 9.81);

/// Masses growing from 1 kg to `ratio` kg.
std::vector<double> growing_masses(int count, double ratio);

}  // namespace nilas::challenge
