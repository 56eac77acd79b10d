/// A list of choices with a value that nothing handles, where NILAS_ADD_CHOICE is defined. ctest compiles this file
/// both ways with the project's warnings: the second must fail, at the table of names and at the function that acts on
/// them.
#include "core/choices/choice.h"

namespace nilas {

enum class Sample {
  first,
  second,
#ifdef NILAS_ADD_CHOICE
  added
#endif
};
constexpr ChoiceText choice_text(Sample value) {
  switch (value) {
    case Sample::first:
      return {"first"};
    case Sample::second:
      return {"second"};
  }
  return {};
}

static_assert(num_choices<Sample>() == 2 && find_choice<Sample>("second") == Sample::second);

int effect_of(Sample value);
int effect_of(Sample value) {
  switch (value) {
    case Sample::first:
      return 1;
    case Sample::second:
      return 2;
  }
  return 0;
}

}  // namespace nilas
