#pragma once
/// Typed values of a resolved tree. Absent and faulty attributes give an empty result.
#include <optional>
#include <string>
#include <vector>

#include "core/base/math.h"
#include "core/choices/law.h"
#include "core/scene/document/document.h"

namespace nilas::scene {

std::optional<std::string> text_of(const SceneElement& element, const std::string& attribute);
std::optional<std::vector<double>> numbers_of(const SceneElement& element, const std::string& attribute);
std::optional<double> number_of(const SceneElement& element, const std::string& attribute);
/// The choice of an attribute; empty where it is absent or faulty.
template <ChoiceEnum Enum>
std::optional<Enum> choice_of(const SceneElement& element, const std::string& attribute) {
  return find_choice<Enum>(text_of(element, attribute).value_or(""));
}
/// Words of a list, empty when absent.
std::vector<std::string> words_of(const SceneElement& element, const std::string& attribute);
bool is_true(const SceneElement& element, const std::string& attribute);
/// Whether the attribute is given and not zero throughout.
bool is_given_nonzero(const SceneElement& element, const std::string& attribute);

/// Whether an element <hydro> asks for a load that depends on the water.
bool needs_water(const SceneElement& hydro);

/// Sets the target to the attribute's value; keeps the target where the attribute gives none.
void assign(double& target, const SceneElement& element, const std::string& attribute);
void assign(int& target, const SceneElement& element, const std::string& attribute);
void assign(bool& target, const SceneElement& element, const std::string& attribute);
void assign(std::string& target, const SceneElement& element, const std::string& attribute);
void assign(ParsedLaw& target, const SceneElement& element, const std::string& attribute);
template <ChoiceEnum Enum>
void assign(Enum& target, const SceneElement& element, const std::string& attribute) {
  if (const auto name = text_of(element, attribute)) target = choice_named<Enum>(*name);
}
void assign(std::vector<double>& target, const SceneElement& element, const std::string& attribute);
void assign(Vec3& target, const SceneElement& element, const std::string& attribute);
void assign(Vec6& target, const SceneElement& element, const std::string& attribute);
template <class Value>
void assign(std::optional<Value>& target, const SceneElement& element, const std::string& attribute) {
  if (!text_of(element, attribute)) return;
  assign(target.emplace(), element, attribute);
}

}  // namespace nilas::scene
