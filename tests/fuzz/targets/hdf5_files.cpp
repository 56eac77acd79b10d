/// Contact problems and checkpoints.
#include <variant>

#include "contact/fclib/fclib_io.h"
#include "contact/problem/problem.h"
#include "core/sim/checkpoint.h"
#include "tests/fuzz/targets.h"

namespace nilas::fuzz {

void fclib(std::string_view bytes) {
  const auto file = file_with("problem.hdf5", bytes);
  read_or_refuse([&] {
    const contact::FclibProblem read = contact::read_fclib(file);
    if (const auto* problem = std::get_if<contact::ContactProblem>(&read.problem)) contact::validate(*problem);
  });
}

void checkpoint(std::string_view bytes) {
  const auto file = file_with("checkpoint.h5", bytes);
  read_or_refuse([&] { sim::read_checkpoint(file, {"program", "build", "scene"}); });
}

}  // namespace nilas::fuzz
