#pragma once
/// Checks of a packed field's description.
#include "core/field/field.h"

namespace nilas {

/// Throws InputError naming the parameter, what was found and what is allowed.
void check_packed_spec(const PackedSpec& spec);

}  // namespace nilas
