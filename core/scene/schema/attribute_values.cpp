#include "core/scene/schema/attribute_values.h"

#include <algorithm>

#include "core/scene/spec/values.h"

namespace nilas::scene {

std::optional<std::string> text_of(const SceneElement& element, const std::string& attribute) {
  const SceneAttribute* found = attribute_of(element, attribute);
  if (!found || !found->valid) return std::nullopt;
  return found->value;
}

std::optional<std::vector<double>> numbers_of(const SceneElement& element, const std::string& attribute) {
  const auto text = text_of(element, attribute);
  if (!text) return std::nullopt;
  std::vector<double> numbers;
  for (const auto& word : split_words(*text)) numbers.push_back(parse_number(word).value());
  return numbers;
}

std::optional<double> number_of(const SceneElement& element, const std::string& attribute) {
  const auto numbers = numbers_of(element, attribute);
  if (!numbers) return std::nullopt;
  return numbers->front();
}

std::vector<std::string> words_of(const SceneElement& element, const std::string& attribute) {
  return split_words(text_of(element, attribute).value_or(""));
}

bool is_true(const SceneElement& element, const std::string& attribute) {
  return text_of(element, attribute) == "true";
}

bool is_given_nonzero(const SceneElement& element, const std::string& attribute) {
  const SceneAttribute* found = attribute_of(element, attribute);
  if (!found || !found->given || !found->valid) return false;
  const auto numbers = *numbers_of(element, attribute);
  return std::any_of(numbers.begin(), numbers.end(), [](double x) { return x != 0; });
}

bool needs_water(const SceneElement& hydro) {
  return std::any_of(hydro.children.begin(), hydro.children.end(),
                     [](const SceneElement& child) { return child.name != "virtual_drag"; });
}

void assign(double& target, const SceneElement& element, const std::string& attribute) {
  target = number_of(element, attribute).value_or(target);
}

void assign(int& target, const SceneElement& element, const std::string& attribute) {
  if (const auto x = number_of(element, attribute)) target = static_cast<int>(*x);
}

void assign(bool& target, const SceneElement& element, const std::string& attribute) {
  if (text_of(element, attribute)) target = is_true(element, attribute);
}

void assign(std::string& target, const SceneElement& element, const std::string& attribute) {
  target = text_of(element, attribute).value_or(target);
}

void assign(ParsedLaw& target, const SceneElement& element, const std::string& attribute) {
  if (const auto name = text_of(element, attribute)) target = parse_law(*name);
}

void assign(std::vector<double>& target, const SceneElement& element, const std::string& attribute) {
  if (const auto numbers = numbers_of(element, attribute)) target = *numbers;
}

void assign(Vec3& target, const SceneElement& element, const std::string& attribute) {
  if (const auto x = numbers_of(element, attribute)) target = Vec3::Map(x->data());
}

void assign(Vec6& target, const SceneElement& element, const std::string& attribute) {
  if (const auto x = numbers_of(element, attribute)) target = Vec6::Map(x->data());
}

}  // namespace nilas::scene
