#pragma once
/// Which runs of a comparison judge the others.
#include "apps/compare/scenes/judge/findings.h"

namespace nilas {

/// The reference runs; where none is done, the one at twice its step, else the most accurate setting that is done.
Judges judges_of(const Plan& plan, const RunTable& rows, Judged judged);

/// The rows with RunRow::judges set.
RunTable with_judges(RunTable rows, const Judges& judges);

}  // namespace nilas
