#pragma once
/// The tables of `./dev bench collision`. Each prints itself; those of type bool return false where a condition fails.
#include "core/choices/contact_choices.h"

namespace nilas::bench {

/// Every class of tests/support/collision/pair_classes.h, or the one class named, with one narrow phase against the
/// oracle: `batches` of 1000 pairs each.
bool class_table(int batches, int threads, NarrowPhase narrow, const char* only);
/// Time per pair and correctness of Nilas, FCL and Bullet on the same `pairs` of each class without round bodies.
bool peer_table(int pairs, int rounds);
/// Time of detection in a packed, moving field of so many floes.
void step_row(int floes, int steps);
/// Detection on one and several threads in a moving field: the results must be the same to the bit. Its time is
/// compared with that of a loop that only computes.
bool thread_table(int floes, int threads, int steps);

}  // namespace nilas::bench
