#pragma once
/// Variants whose alternatives are the values of an enumeration, in the same order: `kind_of` names the one that a
/// variant holds. A value without an alternative does not compile.
#include <variant>

#include "core/choices/choice.h"

namespace nilas {

/// Functions for the alternatives of a variant, for std::visit. One that is left out does not compile.
template <class... Calls>
struct Overloaded : Calls... {
  using Calls::operator()...;
};
template <class... Calls>
Overloaded(Calls...) -> Overloaded<Calls...>;

template <ChoiceEnum Enum, class... Alternatives>
constexpr Enum kind_of(const std::variant<Alternatives...>& variant) {
  static_assert(sizeof...(Alternatives) >= num_choices<Enum>());
  return static_cast<Enum>(variant.index());
}

}  // namespace nilas
