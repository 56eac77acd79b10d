#pragma once
/// Choices: enumerations whose values have names in scene files and on the command line. The only source of such a list
/// is a function beside the enumeration,
///   constexpr ChoiceText choice_text(Enum value)
/// that switches over all values without a default. A value that the switch leaves out does not compile (-Wswitch with
/// -Werror). The schema's allowed values, the reader, messages and documentation follow from it. Values count from 0; a
/// value with an empty name ends the list and cannot be asked for by name.
#include <array>
#include <concepts>
#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <type_traits>
#include <vector>

#include "core/base/error.h"

namespace nilas {

struct ChoiceText {
  std::string_view name = {};
  std::string_view doc = {};       ///< a whole sentence for the scene reference; may be empty
  std::string_view old_name = {};  ///< still read, with a warning; empty: none
};

template <class Enum>
concept ChoiceEnum = std::is_enum_v<Enum> && requires(Enum value) {
  { choice_text(value) } -> std::same_as<ChoiceText>;
};

template <ChoiceEnum Enum>
constexpr std::size_t num_choices() {
  std::size_t n = 0;
  while (!choice_text(static_cast<Enum>(n)).name.empty()) ++n;
  return n;
}

/// All values that have a name, in the order of the enumeration.
template <ChoiceEnum Enum>
constexpr std::array<Enum, num_choices<Enum>()> all_choices() {
  std::array<Enum, num_choices<Enum>()> all{};
  for (std::size_t k = 0; k < all.size(); ++k) all[k] = static_cast<Enum>(k);
  return all;
}

template <ChoiceEnum Enum>
std::string name_of(Enum value) {
  return std::string(choice_text(value).name);
}

/// The value with this name; nothing when there is none. Old names are not found.
template <ChoiceEnum Enum>
constexpr std::optional<Enum> find_choice(std::string_view name) {
  for (const Enum value : all_choices<Enum>())
    if (choice_text(value).name == name) return value;
  return std::nullopt;
}

/// The same of a name that was checked before. Throws ContractError when there is none.
template <ChoiceEnum Enum>
Enum choice_named(std::string_view name) {
  const auto found = find_choice<Enum>(name);
  NILAS_DEMAND(found.has_value());
  return *found;
}

template <ChoiceEnum Enum>
std::vector<std::string> choice_names() {
  std::vector<std::string> names;
  for (const Enum value : all_choices<Enum>()) names.push_back(name_of(value));
  return names;
}

}  // namespace nilas
