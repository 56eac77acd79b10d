#pragma once
/// Contact problems that are hard for solvers, at any size: heaps, columns, rafts of floes, stacks.
#include <cstdint>
#include <vector>

#include "contact/challenge/challenge_bodies.h"

namespace nilas::challenge {

/// Bodies of different mass and inertia that are thrown at each other and at the ground, with random points and
/// normals.
contact::ContactProblem random_heap(std::uint64_t seed, int body_count, int contact_count, double mu);

/// A column of masses, listed from the ground up, with one frictionless contact between neighbours. It falls for one
/// step under g.
contact::ContactProblem column(const std::vector<double>& masses, double h, double g);

/// A raft of side x side square floes of 1 m with two contact points per shared edge. The floes move at random, and
/// every row of floes ends at a fixed wall. `closed` is the share of the pairs that touch; the others have a gap that
/// cannot close within the step.
contact::ContactProblem raft(int side, double mu, double closed, std::uint64_t seed);

/// A stack of unit cubes of the given masses, listed from the ground up, with four contacts per face. It falls for one
/// step. The rank of W is two thirds of its size, and nothing moves in the exact solution.
contact::ContactProblem box_stack(const std::vector<double>& masses, double mu, double h = 0.01, double g = 9.81);

/// Returns `count` masses that grow geometrically from 1 kg to `ratio` kg.
std::vector<double> growing_masses(int count, double ratio);

}  // namespace nilas::challenge
