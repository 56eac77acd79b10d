#pragma once
/// The runs of a comparison that judge the others.
#include "apps/compare/scenes/judge/findings.h"

namespace nilas::compare {

/// The runs that judge: those of the reference. If none is done, they are the reference at twice its step, else the
/// most accurate setting that is done.
Judges judges_of(const Plan& plan, const RunTable& rows, Judged judged);

/// The rows with RunRow::judges set.
RunTable with_judges(RunTable rows, const Judges& judges);

}  // namespace nilas::compare
