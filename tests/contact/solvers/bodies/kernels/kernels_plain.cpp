/// The loops of run_kernels.h, compiled without wide registers, in a namespace of their own. The headers that they
/// share with the program and that stand outside of contact/solvers come first.
#include <cmath>

#include "contact/law/cone.h"
#include "contact/law/law_map.h"
#include "contact/measure/measure.h"
#include "contact/problem/block_fill.h"
#include "contact/problem/prepared_problem.h"
#include "contact/problem/row_of.h"
#include "contact/solvers/linear/wide_clones.h"
#include "core/base/error.h"
#include "core/base/parallel.h"
#include "tests/contact/solvers/bodies/kernels/run_kernels.h"

#undef NILAS_WIDE_CLONES
#define NILAS_WIDE_CLONES
#define has_widest_registers() false
#define solvers plain_solvers

#include "contact/solvers/bodies/body_island.cpp"
#include "contact/solvers/bodies/cone_pairs.cpp"
#include "contact/solvers/bodies/interior_on_bodies.cpp"
#include "contact/solvers/bodies/interior_rounds.cpp"
#include "contact/solvers/bodies/node_cholesky.cpp"
#include "contact/solvers/bodies/node_lu.cpp"
#include "contact/solvers/bodies/node_plan.cpp"
#include "contact/solvers/linear/padded_block.cpp"
#include "tests/contact/solvers/bodies/kernels/kernels_here.h"

std::vector<double> nilas::test::plain_kernel_results(const contact::ContactProblem& problem) {
  return nilas::solvers::run_kernels(problem);
}
