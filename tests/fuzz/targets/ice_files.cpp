/// Ice fields and libraries of outlines.
#include "core/field/field.h"
#include "core/field/outline_library.h"
#include "tests/fuzz/targets.h"

namespace nilas::fuzz {

void field(std::string_view bytes) {
  const auto file = file_with("field.geojson", bytes);
  read_or_refuse([&] { field::read_field(file); });
}

void outlines(std::string_view bytes) {
  const auto file = file_with("outlines.json", bytes);
  read_or_refuse([&] { field::read_outlines(file); });
}

}  // namespace nilas::fuzz
