#pragma once
/// The tables of `./dev bench collision`. Each prints itself and returns false where something that must hold does not.
#include "core/choices/contact_choices.h"

namespace nilas::bench {

/// Every class of tests/support/collision/pair_classes.h against the oracle, `batches` of 1000 pairs each, or the one
/// class named, with one narrow phase.
bool class_table(int batches, int threads, NarrowPhase narrow, const char* only);
/// Time per pair and correctness of Nilas, FCL and Bullet on the same `pairs` of each class without round parts.
bool peer_table(int pairs, int rounds);
/// Detection in a packed field of so many floes that moves.
void step_row(int floes, int steps);
/// One and several threads on a field that moves: the same bits, and the time beside that of a loop that only computes.
bool thread_table(int floes, int threads, int steps);

}  // namespace nilas::bench
